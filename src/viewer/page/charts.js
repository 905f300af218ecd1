// Numbers as short texts.
const Format = {
  // Returns a number with some significant digits.
  number(x, digits = 4) {
    if (x === null || x === undefined || Number.isNaN(x)) return '–';
    if (Number.isInteger(x) && Math.abs(x) < 1e9) return String(x);
    const size = Math.abs(x);
    if (size !== 0 && (size < 1e-3 || size >= 1e6)) return x.toExponential(digits - 1).replace(/\.?0+e/, 'e');
    return String(Number(x.toPrecision(digits)));
  },

  count: (n) => n.toLocaleString('en-US').replace(/,/g, '\u202f'),

  // Returns about n round numbers between two limits, and a function that writes them with equal precision.
  ticks(low, high, n) {
    const raw = (high - low) / n;
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((f) => f * power).find((s) => s >= raw * 0.999);
    const places = Math.max(0, Math.min(12, -Math.floor(Math.log10(step) + 1e-9)));
    const ticks = [];
    for (let i = Math.ceil(low / step - 1e-9); i <= Math.floor(high / step + 1e-9); i++) ticks.push(i * step);
    const large = Math.max(Math.abs(low), Math.abs(high));
    const scientific = large >= 1e6 || large < 1e-3;
    const digits = Math.max(0, Math.min(4, Math.ceil(Math.log10(large / step) - 1e-9)));
    return { ticks, write: (x) => (x === 0 ? '0' : scientific ? x.toExponential(digits) : x.toFixed(places)) };
  },
};

// Charts as SVG elements that take their colors from the style sheet.
const Charts = {
  // Returns a new SVG element with attributes, as the last child of a parent.
  add(parent, name, attributes, text) {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    if (text !== undefined) element.textContent = text;
    parent.append(element);
    return element;
  },

  // Draws a histogram of angles in bins of 5 degrees.
  histogram(svg, angles) {
    svg.replaceChildren();
    const width = 300, height = 120, left = 6, right = 6, bottom = 18, top = 6;
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    const most = Math.max(1, ...angles.bins);
    const step = (width - left - right) / angles.bins.length;
    const base = height - bottom;
    angles.bins.forEach((count, bin) => {
      const bar = (base - top) * count / most;
      if (count === 0) return;
      const rect = Charts.add(svg, 'rect', {
        class: 'bar', x: left + bin * step + 0.5, y: base - Math.max(bar, 1), width: step - 1, height: Math.max(bar, 1),
      });
      Charts.add(rect, 'title', {}, `${5 * bin}° to ${5 * bin + 5}°: ${Format.count(count)}`);
    });
    Charts.add(svg, 'line', { class: 'axis', x1: left, x2: width - right, y1: base, y2: base });
    for (let angle = 0; angle <= 180; angle += 30) {
      const x = left + angle / 5 * step;
      Charts.add(svg, 'line', { class: 'axis', x1: x, x2: x, y1: base, y2: base + 3 });
      const anchor = angle === 0 ? 'start' : angle === 180 ? 'end' : 'middle';
      Charts.add(svg, 'text', { x, y: height - 4, 'text-anchor': anchor }, `${angle}°`);
    }
  },

  // Draws the color map with the numbers of its ends and its middle.
  colorBar(svg, { title, low, high }) {
    svg.replaceChildren();
    svg.setAttribute('viewBox', '0 0 220 46');
    Charts.add(svg, 'text', { x: 6, y: 12, class: 'title' }, title);
    for (let i = 0; i < 52; i++) {
      Charts.add(svg, 'rect', { x: 6 + 4 * i, y: 18, width: 4.3, height: 10, fill: Colors.css(Colors.map((i + 0.5) / 52)) });
    }
    const anchors = ['start', 'middle', 'end'];
    anchors.forEach((anchor, i) => {
      Charts.add(svg, 'text', { x: 6 + 104 * i, y: 41, 'text-anchor': anchor }, Format.number(low + (high - low) * i / 2, 3));
    });
  },

  // Draws the same color bar into the lower left corner of a canvas, with a width of a quarter of the canvas.
  drawColorBar(context, { title, low, high }) {
    const { canvas } = context;
    const scale = Math.max(1, canvas.width / 880);
    context.setTransform(scale, 0, 0, scale, 12 * scale, canvas.height - 58 * scale);
    for (let i = 0; i < 52; i++) {
      context.fillStyle = Colors.css(Colors.map((i + 0.5) / 52));
      context.fillRect(6 + 4 * i, 18, 4.3, 10);
    }
    context.fillStyle = Colors.css(Theme.color('--text'));
    context.font = '11px sans-serif';
    context.fillText(title, 6, 12);
    ['left', 'center', 'right'].forEach((align, i) => {
      context.textAlign = align;
      context.fillText(Format.number(low + (high - low) * i / 2, 3), 6 + 104 * i, 41);
    });
  },

  // Draws the directions of the coordinate axes on the screen.
  axes(svg, right, up) {
    svg.replaceChildren();
    svg.setAttribute('viewBox', '-32 -32 64 64');
    ['x', 'y', 'z'].forEach((name, axis) => {
      const x = 20 * right[axis], y = -20 * up[axis];
      Charts.add(svg, 'line', { class: `axis_${name}`, x1: 0, y1: 0, x2: x, y2: y });
      Charts.add(svg, 'text', { x: 1.38 * x, y: 1.38 * y + 3.5, 'text-anchor': 'middle' }, name);
    });
  },
};

// A chart of series over the time of the frames, with a cursor at the shown frame.
class SeriesChart {
  // Calls choose(index of a frame) when a user clicks into the chart.
  constructor(svg, film, choose) {
    Object.assign(this, { svg, film });
    this.times = film.entries.map((entry) => entry.time);
    this.first = this.times[0];
    this.span = this.times[this.times.length - 1] - this.first || 1;
    this.area = { left: 52, right: 292, top: 8, bottom: 112 };
    svg.setAttribute('viewBox', '0 0 300 134');
    svg.addEventListener('click', (event) => {
      const box = svg.getBoundingClientRect();
      choose(this.nearest((event.clientX - box.left) / box.width * 300));
    });
  }

  x(time) { return this.area.left + (this.area.right - this.area.left) * (time - this.first) / this.span; }

  // Returns the frame whose time is nearest to a horizontal position.
  nearest(position) {
    let best = 0;
    this.times.forEach((time, i) => {
      if (Math.abs(this.x(time) - position) < Math.abs(this.x(this.times[best]) - position)) best = i;
    });
    return best;
  }

  // Draws the series of the given indices.
  draw(indices) {
    this.svg.replaceChildren();
    const values = indices.flatMap((i) => this.film.series[i].values).filter((v) => v !== null);
    let low = Math.min(...values), high = Math.max(...values);
    if (!(high >= low)) [low, high] = [0, 1];
    // A constant series gets a small range.
    const margin = Math.max((high - low) * 0.06, Math.abs(high) * 1e-7, 1e-300);
    low -= margin;
    high += margin;
    const { left, right, top, bottom } = this.area;
    this.y = (value) => bottom - (bottom - top) * (value - low) / (high - low);
    this.drawAxes(low, high);
    for (const index of indices) this.drawLine(index);
    this.cursor = Charts.add(this.svg, 'line', { class: 'cursor', y1: top, y2: bottom });
    Charts.add(this.svg, 'rect', { x: left, y: top, width: right - left, height: bottom - top, class: 'target' });
  }

  drawAxes(low, high) {
    const { left, right, top, bottom } = this.area;
    const vertical = Format.ticks(low, high, 4);
    // Nearly constant series get ticks relative to the lowest one.
    const size = Math.max(Math.abs(low), Math.abs(high));
    const relative = vertical.ticks.length > 1 && (vertical.ticks[1] - vertical.ticks[0]) < 1e-4 * size;
    const base = relative ? vertical.ticks[0] : 0;
    if (relative) Charts.add(this.svg, 'text', { x: left + 4, y: top + 4 }, `${Format.number(base, 10)} plus`);
    for (const value of vertical.ticks) {
      const y = this.y(value);
      const text = relative ? Format.number(value - base, 2) : vertical.write(value);
      Charts.add(this.svg, 'line', { class: 'grid', x1: left, x2: right, y1: y, y2: y });
      Charts.add(this.svg, 'text', { x: left - 4, y: y + 3.5, 'text-anchor': 'end' }, text);
    }
    Charts.add(this.svg, 'path', { class: 'axis', d: `M${left} ${top}V${bottom}H${right}` });
    const horizontal = Format.ticks(this.first, this.first + this.span, 5);
    for (const time of horizontal.ticks) {
      const x = this.x(time);
      Charts.add(this.svg, 'line', { class: 'axis', x1: x, x2: x, y1: bottom, y2: bottom + 3 });
      Charts.add(this.svg, 'text', { x, y: bottom + 14, 'text-anchor': 'middle' }, horizontal.write(time));
    }
  }

  // Draws one series. A frame with an unknown value interrupts the line; a lone value becomes a dot.
  drawLine(index) {
    const { values, color } = this.film.series[index];
    let path = '';
    values.forEach((value, i) => {
      if (value === null) return;
      const before = i > 0 && values[i - 1] !== null;
      path += `${before ? 'L' : 'M'}${this.x(this.times[i]).toFixed(2)} ${this.y(value).toFixed(2)}`;
      if (!before && (i + 1 === values.length || values[i + 1] === null)) path += 'h0.01';
    });
    Charts.add(this.svg, 'path', { class: 'series', d: path, stroke: color });
  }

  // Moves the cursor to a frame.
  show(frame) {
    const x = this.x(this.times[frame]).toFixed(2);
    this.cursor.setAttribute('x1', x);
    this.cursor.setAttribute('x2', x);
  }
}

// Marks of the events above the time slider.
class EventTicks {
  // Calls choose(event) when a user clicks a mark and hover(event or null) when the pointer enters or leaves it.
  constructor(container, film, choose, hover) {
    const last = Math.max(1, film.count - 1);
    for (const event of film.events) {
      const button = document.createElement('button');
      button.style.left = `${100 * event.frame / last}%`;
      button.title = event.text;
      button.setAttribute('aria-label', event.text);
      button.addEventListener('click', () => choose(event));
      button.addEventListener('pointerenter', () => hover(event));
      button.addEventListener('pointerleave', () => hover(null));
      container.append(button);
    }
  }
}

// Tables of all frames and events, for browsers without WebGL 2.
const Tables = {
  // Returns a table with a head and rows of texts.
  table(className, head, rows) {
    const table = make('table', className);
    for (const [cells, name] of [[head, 'th'], ...rows.map((row) => [row, 'td'])]) {
      const line = make('tr');
      line.append(...cells.map((text) => make(name, '', text)));
      table.append(line);
    }
    return table;
  },

  // Returns the measures of a frame as texts: empty ones if the browser cannot decode the film.
  async measures(film, index) {
    try {
      const frame = await film.decode(index);
      const angles = Measures.angles(frame, film.corners);
      const worst = Measures.qualities(frame, film.corners).reduce((a, b) => Math.min(a, b), 1);
      return [angles.smallest.toFixed(1), angles.largest.toFixed(1), Format.number(worst, 3)];
    } catch (error) {
      return ['', '', ''];
    }
  },

  // Replaces the page's content by tables.
  async show(film, reason) {
    document.body.classList.add('plain');
    const area = element('tables');
    area.hidden = false;
    const head = ['Frame', 'Step', 'Time', 'Vertices', film.cells ? 'Cells' : 'Facets'];
    if (film.cells) head.push('Smallest angle (°)', 'Largest angle (°)', 'Worst quality');
    head.push(...film.series.map((series) => series.name));
    const rows = [];
    for (let i = 0; i < film.count; i++) {
      const entry = film.entries[i];
      const row = [i, entry.step, Format.number(entry.time, 6), entry.vertices, entry.simplices];
      if (film.cells) row.push(...await Tables.measures(film, i));
      rows.push([...row, ...film.series.map((series) => Format.number(series.values[i], 8))]);
    }
    area.replaceChildren(make('h2', '', film.title),
      make('p', 'note', `The page cannot draw the film (${reason}). It lists the numbers of the frames.`),
      Tables.table('frames', head, rows));
    if (film.events.length > 0) {
      const events = film.events.map((event) => [event.frame, Format.number(event.time), event.text]);
      area.append(make('h2', '', 'Events'), Tables.table('events', ['Frame', 'Time', 'Event'], events));
    }
    element('verdict').textContent = `viewer: tables of ${film.count} frames and ${film.events.length} events`;
  },
};
