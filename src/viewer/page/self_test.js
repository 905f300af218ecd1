// Uses every control as a user does and compares pictures. Runs if the address ends with #test.
class SelfTest {
  constructor(viewer) {
    this.viewer = viewer;
    this.film = viewer.film;
    this.passed = 0;
    this.failures = [];
    // Files are made, but not saved.
    addEventListener('click', (event) => { if (event.target.download) event.preventDefault(); });
    addEventListener('error', (event) => this.failures.push(`error: ${event.message}`));
    addEventListener('securitypolicyviolation', (event) => this.failures.push(`policy violation: ${event.violatedDirective}`));
  }

  check(condition, text) {
    if (condition) this.passed++;
    else this.failures.push(text);
  }

  // Runs all checks and writes the result into the element "verdict".
  async run() {
    const verdict = element('verdict');
    verdict.hidden = false;
    const first = `viewer: first picture after ${Math.round(this.viewer.firstPicture)} ms`;
    verdict.textContent = first;
    const parts = ['frames', 'volumes', 'labels', 'display', 'cuts', 'colors', 'camera', 'time', 'keyboard', 'events', 'charts', 'layout', 'files'];
    await this.viewer.ready;
    for (const part of parts) {
      try {
        await this[part]();
      } catch (error) {
        this.failures.push(`${part}: ${error.message}`);
      }
    }
    const result = this.failures.length === 0 ? [`viewer: all ${this.passed} checks passed`]
      : this.failures.map((text) => `viewer: FAILED: ${text}`);
    verdict.textContent = [first, ...result].join('\n');
  }

  // Waits until a condition holds. Throws Error after some seconds.
  async until(condition, text, seconds = 20) {
    for (let i = 0; i < seconds * 50; i++) {
      if (condition()) return;
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    throw new Error(`no end of: ${text}`);
  }

  // Changes a control and dispatches the events of a user's input.
  set(control, value) {
    if (control.type === 'checkbox' || control.type === 'radio') control.checked = value;
    else control.value = value;
    control.dispatchEvent(new Event('input', { bubbles: true }));
    control.dispatchEvent(new Event('change', { bubbles: true }));
  }

  key(key) { document.body.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true })); }

  // Dispatches a pointer event at a point given in shares of the canvas.
  pointer(type, x, y, options = {}) {
    const box = this.viewer.canvas.getBoundingClientRect();
    const place = { clientX: box.left + x * box.width, clientY: box.top + y * box.height };
    const Kind = type === 'wheel' ? WheelEvent : type === 'dblclick' ? MouseEvent : PointerEvent;
    this.viewer.canvas.dispatchEvent(new Kind(type, { bubbles: true, cancelable: true, pointerId: 1, ...place, ...options }));
  }

  drag(from, to, options) {
    this.pointer('pointerdown', ...from, options);
    this.pointer('pointermove', ...to, options);
    this.pointer('pointerup', ...to, options);
  }

  picture() { return this.viewer.pixels(); }

  // Returns the share of pixels that differ between two pictures, by more than rounding.
  difference(a, b) {
    if (a.data.length !== b.data.length) return 1;
    let count = 0;
    for (let i = 0; i < a.data.length; i += 4) {
      const change = Math.max(Math.abs(a.data[i] - b.data[i]), Math.abs(a.data[i + 1] - b.data[i + 1]), Math.abs(a.data[i + 2] - b.data[i + 2]));
      if (change > 2) count++;
    }
    return count / (a.data.length / 4);
  }

  // Returns the share of pixels that differ from the background.
  coverage(picture) {
    const background = Theme.color('--canvas').map((x) => Math.round(255 * x));
    const blank = { data: new Uint8Array(picture.data.length) };
    for (let i = 0; i < blank.data.length; i++) blank.data[i] = i % 4 === 3 ? 255 : background[i % 4];
    return this.difference(picture, blank);
  }

  // Checks that an action changes the picture and another one restores it.
  changes(text, action, undo) {
    const before = this.picture();
    action();
    const after = this.picture();
    this.check(this.difference(before, after) > 0, `${text} does not change the picture`);
    if (!undo) return;
    undo();
    this.check(this.difference(before, this.picture()) === 0, `${text}: the picture is not restored`);
  }

  // Shows a frame by the time slider.
  async show(index) {
    this.set(element('time'), index);
    await this.until(() => this.viewer.frame.index === index, `frame ${index}`);
  }

  frames() {
    const { film } = this;
    for (const [i, entry] of film.entries.entries()) {
      const frame = film.frames[i];
      this.check(frame.positions.length === 3 * entry.vertices, `frame ${i}: number of vertices`);
      this.check(frame.simplices.length === film.corners * entry.simplices, `frame ${i}: number of simplices`);
      this.check(frame.labels.length === entry.simplices, `frame ${i}: number of labels`);
      this.check(frame.simplices.every((vertex) => vertex < entry.vertices), `frame ${i}: a vertex index is out of range`);
      this.check(frame.labels.every((label) => label < film.labels.length), `frame ${i}: a label index is out of range`);
      this.check(frame.positions.every(Number.isFinite), `frame ${i}: a position is not a number`);
      for (const field of film.fields) {
        const values = frame.fields[field.name] || [];
        this.check(values.every((t) => t >= 0 && t <= 1), `frame ${i}: a value of ${field.name} is out of range`);
      }
    }
  }

  // Returns the volume (3D) or area (2D) of a label in a frame, from the decoded cells.
  volume(frame, label) {
    const { film } = this;
    let sum = 0;
    for (let cell = 0; cell < frame.simplexCount; cell++) {
      if (film.labels[frame.labels[cell]] !== label) continue;
      const e = Measures.edges(frame, film.corners, cell);
      const cross = Vector.cross([e[0], e[1], e[2]], [e[3], e[4], e[5]]);
      sum += film.dimension === 3 ? Math.abs(Vector.dot(cross, [e[6], e[7], e[8]])) / 6 : Math.abs(cross[2]) / 2;
    }
    return sum * film.unit ** film.dimension;
  }

  // Compares series with the names of volumes or areas of labels with the decoded cells.
  volumes() {
    const { film } = this;
    if (!film.cells) return;
    for (const series of film.series) {
      const name = /^(volume|area) of label (-?\d+)( |$)/.exec(series.name);
      if (!name) continue;
      film.frames.forEach((frame, i) => {
        if (series.values[i] === null) return;
        const error = Math.abs(this.volume(frame, Number(name[2])) - series.values[i]);
        this.check(error <= 1e-3 * Math.abs(series.values[i]) + 1e-9, `frame ${i}: the cells differ from the series ${series.name}`);
      });
    }
  }

  labels() {
    const boxes = [...element('labels').querySelectorAll('input')];
    const initial = boxes.map((box) => box.checked);
    const before = this.picture();
    const least = this.film.dimension === 2 && !this.film.cells ? 0.0005 : 0.02;
    this.check(this.coverage(before) > least, 'the surface covers too few pixels');
    for (const box of boxes) this.set(box, false);
    this.check(this.coverage(this.picture()) === 0, 'hiding all labels leaves more than the background');
    boxes.forEach((box, i) => {
      this.set(box, true);
      this.check(this.viewer.shown[i], `${box.value}: the label is not shown`);
    });
    boxes.forEach((box, i) => this.set(box, initial[i]));
    this.check(this.difference(before, this.picture()) === 0, 'showing the labels again does not restore the picture');
  }

  display() {
    if (this.viewer.film.dimension === 3 || this.film.cells) {
      this.changes('wireframe', () => this.set(element('wire'), true), () => this.set(element('wire'), false));
    }
    // The box may be several times as large as the interface.
    for (let i = 0; i < 8; i++) this.pointer('wheel', 0.5, 0.5, { deltaY: 200 });
    this.changes('box', () => this.set(element('box'), true), () => this.set(element('box'), false));
    element('reset').click();
    if (this.film.dimension === 2) return;
    const up = this.viewer.camera.up;
    this.changes('up axis', () => this.set(element('up'), (up + 1) % 3), () => this.set(element('up'), up));
  }

  // Returns whether the plane of the flat cut meets a cell of a shown label.
  meetsCells() {
    const { film, viewer } = this;
    const cut = viewer.gridCut('flat');
    if (!cut || !film.cells) return false;
    const { simplices, positions, labels } = viewer.frame;
    return labels.some((label, cell) => {
      const above = [0, 1, 2, 3].filter((k) => positions[3 * simplices[4 * cell + k] + cut.axis] >= cut.position).length;
      return viewer.shown[label] && above > 0 && above < 4;
    });
  }

  cuts() {
    if (this.film.dimension === 2) return;
    const radio = (name, value) => document.querySelector(`[name=${name}][value="${value}"]`);
    const { camera, domain } = this.viewer;
    const modes = this.film.cells ? ['cells', 'flat'] : ['flat'];
    const before = this.picture();
    for (const mode of modes) {
      for (let axis = 0; axis < 3; axis++) {
        this.set(radio('cut', mode), true);
        this.set(radio('axis', axis), true);
        const middle = (camera.box[axis] + camera.box[3 + axis]) / 2;
        this.set(element('position'), Math.round(1000 * (middle - domain[axis]) / (domain[3 + axis] - domain[axis])));
        const cut = this.picture();
        this.check(this.difference(before, cut) > 0, `cut ${mode} of axis ${axis} does not change the picture`);
        const polygons = this.viewer.renderer.layers.section.count;
        this.check(polygons > 0 === this.meetsCells(), `cut ${mode} of axis ${axis}: ${polygons} corners of polygons`);
        const flip = element('flip');
        this.changes(`flipped cut ${mode} of axis ${axis}`, () => this.set(flip, true), () => this.set(flip, false));
        const at = element('position').value;
        this.changes(`position of cut ${mode}`, () => this.set(element('position'), 0.8 * at), () => this.set(element('position'), at));
        if (this.film.cells) this.changes(`wireframe of cut ${mode}`, () => this.set(element('wire'), true), () => this.set(element('wire'), false));
        this.set(radio('cut', 'none'), true);
        this.check(this.difference(before, this.picture()) === 0, `no cut after ${mode}: the picture is not restored`);
      }
    }
  }

  colors() {
    for (const option of element('color').options) {
      if (option.value === 'label') continue;
      const field = this.film.fields.find((one) => one.name === option.value);
      if (field && !this.viewer.frame.fields[field.name]) continue;
      this.changes(`color by ${option.value}`, () => {
        this.set(element('color'), option.value);
        this.check(element('color_bar').textContent.length > 0 && !element('color_bar').hasAttribute('hidden'), `${option.value}: no color bar`);
      }, () => this.set(element('color'), 'label'));
    }
    this.check(element('color_bar').hasAttribute('hidden'), 'colors by label have a color bar');
  }

  camera() {
    const reset = () => element('reset').click();
    const uploads = this.viewer.renderer.uploads;
    this.changes('drag', () => this.drag([0.4, 0.5], [0.6, 0.6]), reset);
    this.changes('drag with shift', () => this.drag([0.4, 0.5], [0.6, 0.6], { shiftKey: true }), reset);
    this.changes('drag with the right button', () => this.drag([0.4, 0.5], [0.5, 0.5], { button: 2 }), reset);
    this.changes('wheel', () => this.pointer('wheel', 0.4, 0.4, { deltaY: -150 }), () => this.pointer('dblclick', 0.5, 0.5));
    this.changes('pinch', () => {
      this.pointer('pointerdown', 0.4, 0.5, { pointerId: 2 });
      this.pointer('pointerdown', 0.6, 0.5, { pointerId: 3 });
      this.pointer('pointermove', 0.8, 0.5, { pointerId: 3 });
      this.pointer('pointerup', 0.8, 0.5, { pointerId: 3 });
      this.pointer('pointerup', 0.4, 0.5, { pointerId: 2 });
      this.check(this.viewer.camera.zoom > 1, 'pinch does not zoom');
    }, () => this.key('r'));
    this.check(this.viewer.renderer.uploads === uploads, 'camera moves upload buffers again');
  }

  // Returns whether the drawn shapes of two frames differ by enough for a visible change.
  shapesDiffer(i, j) {
    const words = [i, j].map((index) => {
      const frame = this.film.frames[index];
      const { surface, edges } = this.viewer.surface(frame, this.viewer.paint(frame));
      return surface || edges;
    });
    if (words[0].count !== words[1].count) return true;
    let most = 0;
    for (let k = 0; k < words[0].count; k++) {
      for (let axis = 0; axis < 3; axis++) {
        most = Math.max(most, Math.abs(words[0].floats[7 * k + axis] - words[1].floats[7 * k + axis]));
      }
    }
    return most > 0.02 * this.viewer.camera.radius;
  }

  async time() {
    const last = this.film.count - 1;
    if (last === 0) return;
    const first = this.picture();
    await this.show(last);
    this.check(!this.shapesDiffer(0, last) || this.difference(first, this.picture()) > 0, 'first and last frame look the same');
    this.check(element('numbers').textContent.includes(this.film.entries[last].step), 'the numbers do not follow');
    await this.show(0);
    this.check(this.difference(first, this.picture()) === 0, 'showing the first frame again does not restore the picture');
    const { playback } = this.viewer.controls;
    for (const option of element('speed').options) {
      this.set(element('speed'), option.value);
      this.check(playback.rate === Number(option.value), `speed ${option.value}`);
    }
    // At one frame per second, a short film does not end before it is paused.
    this.set(element('speed'), '1');
    element('play').click();
    this.check(playback.playing, 'playing');
    element('play').click();
    this.check(!playback.playing, 'pause');
    this.set(element('speed'), '20');
    await this.show(0);
    element('play').click();
    await this.until(() => !playback.playing, 'playing to the end');
    this.check(this.viewer.frame.index === last, 'playing stops before the last frame');
    await this.show(0);
  }

  async keyboard() {
    const last = this.film.count - 1;
    if (last === 0) return;
    const press = async (key, frame) => {
      this.key(key);
      await this.until(() => this.viewer.frame.index === frame, `key ${key}`);
      this.check(Number(element('time').value) === frame, `key ${key}: the time slider does not follow`);
    };
    await press('ArrowRight', 1);
    await press('ArrowLeft', 0);
    await press('End', last);
    await press('Home', 0);
    this.key(' ');
    this.check(this.viewer.controls.playback.playing, 'the space key does not play');
    this.key(' ');
    this.check(!this.viewer.controls.playback.playing, 'the space key does not pause');
    await this.show(0);
  }

  async events() {
    const ticks = element('event_ticks').children, items = element('events').querySelectorAll('button');
    for (const [i, event] of this.film.events.slice(0, 5).entries()) {
      ticks[i].click();
      await this.until(() => this.viewer.frame.index === event.frame, 'event tick');
      this.check(element('event_text').textContent.includes(event.text), 'the event tick shows no text');
      await this.show(0);
      items[i].click();
      await this.until(() => this.viewer.frame.index === event.frame, 'event in the list');
      this.check(element('event_text').textContent.includes(event.text), 'the event in the list shows no text');
      this.check(items[i].parentElement.classList.contains('current'), 'the current event is not marked');
      await this.show(0);
    }
  }

  async charts() {
    const { film } = this;
    const last = film.count - 1;
    if (film.cells) {
      const numbers = this.viewer.numbers();
      const sum = numbers.bins.reduce((a, b) => a + b, 0);
      this.check(sum === (film.dimension === 3 ? 6 : 3) * numbers.cells, 'the histogram misses angles');
      const filled = numbers.bins.filter((count) => count > 0).length;
      this.check(element('histogram').querySelectorAll('.bar').length === filled, 'the histogram has a wrong number of bars');
    }
    if (film.series.length === 0 || last === 0) return;
    const cursor = () => element('series').querySelector('.cursor').getAttribute('x1');
    const before = cursor();
    await this.show(last);
    this.check(cursor() !== before, 'the cursor of the series does not move');
    const box = element('series').getBoundingClientRect();
    element('series').dispatchEvent(new MouseEvent('click', { clientX: box.left + 53 / 300 * box.width, clientY: box.top + 50 }));
    await this.until(() => this.viewer.frame.index === 0, 'click into the series');
    for (const option of [...element('series_choice').options].reverse()) {
      this.set(element('series_choice'), option.value);
      const count = option.value === 'all' ? film.series.length : 1;
      this.check(element('series').querySelectorAll('.series').length === count, `series ${option.text}: wrong number of lines`);
    }
  }

  layout() {
    const toggle = element('panel_toggle');
    toggle.click();
    this.check(toggle.getAttribute('aria-expanded') === 'true', 'the panel does not open');
    toggle.click();
    this.check(toggle.getAttribute('aria-expanded') === 'false', 'the panel does not close');
    this.check(document.documentElement.scrollWidth <= window.innerWidth, 'the page is wider than the window');
    this.check(element('message').hidden, `message: ${element('message').textContent}`);
  }

  async files() {
    const { controls } = this.viewer;
    element('save').click();
    await this.until(() => controls.picture, 'saving a picture');
    this.check(controls.picture.size > 500 && controls.picture.type === 'image/png', 'the saved picture is empty');
    const color = this.viewer.color;
    this.viewer.setColor('quality');
    const bitmap = await createImageBitmap(await this.viewer.picture());
    const context = Object.assign(document.createElement('canvas'), { width: bitmap.width, height: bitmap.height }).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const saved = context.getImageData(0, bitmap.height - 58, 120, 58).data;
    const drawn = new Set();
    for (let i = 0; i < saved.length; i += 4) drawn.add(saved.slice(i, i + 3).join());
    this.check(drawn.size > 20, 'the saved picture has no color bar');
    this.viewer.setColor(color);
    if (this.film.count < 2) return;
    this.set(element('speed'), 20);
    element('record').click();
    await this.until(() => !element('record').disabled, 'recording', 60);
    const recorded = controls.video && controls.video.size > 0;
    this.check(recorded || element('export_text').textContent.length > 0, 'no animation and no message');
  }
}
