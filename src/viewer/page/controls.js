const element = (id) => document.getElementById(id);

// Returns a new element with a class and a text.
function make(name, className, text) {
  const result = document.createElement(name);
  if (className) result.className = className;
  if (text !== undefined) result.textContent = text;
  return result;
}

// Offers a blob as a file.
function download(blob, name) {
  const link = make('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// Shows a text over the picture; an empty text hides it.
function showMessage(text) {
  element('message').textContent = text;
  element('message').hidden = text === '';
}

// The controls around the picture. They call the viewer, and follow its state.
class Controls {
  constructor(viewer) {
    this.viewer = viewer;
    this.film = viewer.film;
    this.playback = new Playback(viewer, () => this.showPlaying());
    this.gestures = new Gestures(viewer.canvas, viewer.camera, () => viewer.invalidate('picture'), () => viewer.resetCamera());
    this.hideUnavailable();
    this.buildLabels();
    this.buildColors();
    this.buildTimeline();
    this.buildEvents();
    this.buildSeries();
    this.bindDisplay();
    this.bindCut();
    this.bindExport();
    this.bindKeys();
    this.bindLayout();
    viewer.listen((what) => this.follow(what));
    this.showSettings();
  }

  // Hides the controls that the film does not need.
  hideUnavailable() {
    const { film } = this;
    const plane = film.dimension === 2;
    element('cut_section').hidden = plane;
    element('up_row').hidden = plane;
    element('axes').toggleAttribute('hidden', plane);
    document.querySelector('[name=cut][value=cells]').parentElement.hidden = !film.cells;
    element('wire').parentElement.hidden = plane && !film.cells;
    element('angles_section').hidden = !film.cells;
    element('series_section').hidden = film.series.length === 0;
    element('series_row').hidden = film.series.length < 2;
    element('events_section').hidden = film.events.length === 0;
    element('event_text').hidden = film.events.length === 0;
    element('timeline').hidden = film.count < 2;
    element('record').hidden = film.count < 2;
    element('angles_title').textContent = plane ? 'Angles' : 'Dihedral angles';
  }

  buildLabels() {
    const { film, viewer } = this;
    for (const [i, label] of film.labels.entries()) {
      const row = make('label', 'check');
      const box = make('input');
      box.type = 'checkbox';
      box.value = label;
      const swatch = make('span', 'swatch');
      swatch.style.background = film.colors[i];
      row.append(box, swatch, film.withNames(`Label ${label}`));
      element('labels').append(row);
    }
    element('labels').addEventListener('change', () => {
      const checked = [...element('labels').querySelectorAll('input:checked')];
      viewer.setLabels(checked.map((box) => Number(box.value)));
    });
  }

  buildColors() {
    const { film, viewer } = this;
    const add = (value, text) => element('color').append(new Option(text, value));
    add('label', 'Label');
    if (film.cells) add('quality', 'Quality of cells');
    for (const field of film.fields) add(field.name, field.components > 1 ? `${field.name} (length)` : field.name);
    element('color').addEventListener('change', (event) => viewer.setColor(event.target.value));
  }

  buildTimeline() {
    const { film, viewer, playback } = this;
    element('time').max = film.count - 1;
    element('time').addEventListener('input', (event) => viewer.showFrame(Number(event.target.value)));
    element('play').addEventListener('click', () => playback.toggle());
    element('speed').value = film.count > 60 ? 20 : film.count > 25 ? 10 : 5;
    playback.rate = Number(element('speed').value);
    element('speed').addEventListener('change', (event) => { playback.rate = Number(event.target.value); });
    this.ticks = new EventTicks(element('event_ticks'), film, (event) => {
      viewer.showFrame(event.frame);
      this.showEvent(event);
    }, (event) => this.showEvent(event));
  }

  buildEvents() {
    for (const event of this.film.events) {
      const item = make('li'), button = make('button');
      button.append(make('span', '', `t = ${Format.number(event.time, 3)}`), make('span', '', event.text));
      button.addEventListener('click', () => this.viewer.showFrame(event.frame));
      item.append(button);
      element('events').append(item);
    }
  }

  buildSeries() {
    const { film } = this;
    if (film.series.length === 0) return;
    this.chart = new SeriesChart(element('series'), film, (frame) => this.viewer.showFrame(frame));
    const choice = element('series_choice');
    choice.append(new Option('All', 'all'));
    film.series.forEach((series, i) => choice.append(new Option(series.name, i)));
    choice.addEventListener('change', () => this.showSeries());
  }

  bindDisplay() {
    const { viewer } = this;
    element('wire').addEventListener('change', (event) => viewer.setWireframe(event.target.checked));
    element('box').addEventListener('change', (event) => viewer.setBox(event.target.checked));
    element('up').addEventListener('change', (event) => viewer.setUp(Number(event.target.value)));
    element('reset').addEventListener('click', () => viewer.resetCamera());
  }

  bindCut() {
    const { viewer } = this;
    for (const radio of document.querySelectorAll('[name=cut]')) {
      radio.addEventListener('change', () => viewer.setCut({ mode: radio.value }));
    }
    for (const radio of document.querySelectorAll('[name=axis]')) {
      radio.addEventListener('change', () => viewer.setCut({ axis: Number(radio.value), position: null }));
    }
    element('position').addEventListener('input', (event) => {
      const [low, high] = viewer.extent(viewer.cut.axis);
      viewer.setCut({ position: low + (high - low) * event.target.value / 1000 });
    });
    element('flip').addEventListener('change', (event) => viewer.setCut({ flip: event.target.checked }));
  }

  bindExport() {
    const { viewer, film, playback } = this;
    const base = film.title.replace(/[^\w.-]+/g, '_').slice(0, 60) || 'picture';
    const report = (text) => { element('export_text').textContent = text; };
    element('save').addEventListener('click', async () => {
      this.picture = await viewer.picture();
      download(this.picture, `${base}_${viewer.frame.index}.png`);
    });
    element('record').addEventListener('click', async () => {
      element('record').disabled = true;
      try {
        this.video = await playback.record((i) => report(`Recording frame ${i + 1} of ${film.count}`));
        download(this.video, `${base}.${this.video.type.includes('mp4') ? 'mp4' : 'webm'}`);
        report(`The animation has ${Format.count(Math.ceil(this.video.size / 1024))} kB.`);
      } catch (error) {
        report(error.message);
      }
      element('record').disabled = false;
    });
  }

  bindKeys() {
    const { viewer, playback } = this;
    const step = (by) => { playback.pause(); viewer.showFrame(viewer.wanted + by); };
    const actions = {
      ' ': () => playback.toggle(), ArrowLeft: () => step(-1), ArrowRight: () => step(1),
      Home: () => step(-Infinity), End: () => step(Infinity), r: () => viewer.resetCamera(),
    };
    document.addEventListener('keydown', (event) => {
      // Focused controls keep their own keys.
      if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest('input, select, button, summary')) return;
      if (!actions[event.key]) return;
      event.preventDefault();
      actions[event.key]();
    });
  }

  bindLayout() {
    const { viewer } = this;
    element('panel_toggle').addEventListener('click', () => {
      const open = document.body.classList.toggle('open');
      element('panel_toggle').setAttribute('aria-expanded', open);
    });
    new ResizeObserver(() => viewer.invalidate('picture')).observe(viewer.canvas);
    window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      Theme.cache.clear();
      viewer.invalidate('surface');
    });
  }

  follow(what) {
    if (what === 'frame') this.showFrame();
    if (what === 'setting') this.showSettings();
    if (what === 'decoded') {
      element('ready_bar').style.width = `${100 * (this.viewer.decoded - 1) / Math.max(1, this.film.count - 1)}%`;
      this.showCut();
    }
    if (what === 'camera' && this.film.dimension === 3) Charts.axes(element('axes'), ...this.viewer.screenAxes);
  }

  showPlaying() {
    element('play_shape').setAttribute('d', this.playback.playing ? 'M4 3h4v14h-4zM12 3h4v14h-4z' : 'M5 3l12 7-12 7z');
    element('play').setAttribute('aria-label', this.playback.playing ? 'Pause' : 'Play');
  }

  showFrame() {
    const { viewer, film } = this;
    const numbers = viewer.numbers();
    element('time').value = numbers.frame;
    element('clock').textContent = `t = ${Format.number(numbers.time)}  (${numbers.frame + 1}/${film.count})`;
    this.showNumbers(numbers);
    this.showSeries();
    this.showEvent(null);
    [...element('events').children].forEach((item, i) => {
      item.classList.toggle('current', film.events[i].frame === numbers.frame);
    });
  }

  showNumbers(numbers) {
    const angle = this.film.dimension === 3 ? 'dihedral angle' : 'angle';
    const facets = [this.film.dimension === 3 ? 'Interface facets' : 'Interface edges', Format.count(numbers.facets)];
    const rows = [['Step', numbers.step], ['Time', Format.number(numbers.time, 6)], ['Vertices', Format.count(numbers.vertices)]];
    if (this.film.cells) {
      rows.push([this.film.dimension === 3 ? 'Tetrahedra' : 'Triangles', Format.count(numbers.cells)]);
      rows.push(facets);
      rows.push([`Smallest ${angle}`, `${numbers.smallestAngle.toFixed(1)}°`]);
      rows.push([`Largest ${angle}`, `${numbers.largestAngle.toFixed(1)}°`]);
      rows.push(['Worst quality', Format.number(numbers.worstQuality, 3)]);
      Charts.histogram(element('histogram'), numbers);
      element('angles_text').textContent = `${numbers.smallestAngle.toFixed(1)}° to ${numbers.largestAngle.toFixed(1)}°, all cells`;
    } else rows.push(facets);
    element('numbers').replaceChildren(...rows.map((row) => {
      const line = make('tr');
      line.append(...row.map((text) => make('td', '', text)));
      return line;
    }));
  }

  // Draws the chosen series again if the choice has changed, and moves the cursor.
  showSeries() {
    if (!this.chart) return;
    const { film, viewer } = this;
    const choice = element('series_choice').value;
    const indices = choice === 'all' ? film.series.map((series, i) => i) : [Number(choice)];
    if (choice !== this.drawnChoice) this.chart.draw(indices);
    this.drawnChoice = choice;
    const frame = viewer.frame ? viewer.frame.index : 0;
    this.chart.show(frame);
    element('series_legend').replaceChildren(...indices.map((i) => {
      const item = make('li'), swatch = make('span', 'swatch');
      swatch.style.background = film.series[i].color;
      item.append(swatch, make('span', '', film.series[i].name), make('span', '', Format.number(film.series[i].values[frame], 6)));
      return item;
    }));
  }

  // Shows the text of an event; without an event, the texts of the shown frame.
  showEvent(event) {
    const { film, viewer } = this;
    const events = event ? [event] : film.events.filter((one) => viewer.frame && one.frame === viewer.frame.index);
    element('event_text').textContent = events.map((one) => `t = ${Format.number(one.time, 3)}: ${one.text}`).join('; ');
  }

  showSettings() {
    const { viewer, film } = this;
    [...element('labels').querySelectorAll('input')].forEach((box, i) => { box.checked = viewer.shown[i]; });
    element('color').value = viewer.color;
    element('wire').checked = viewer.wire;
    element('box').checked = viewer.box;
    element('up').value = viewer.camera.up;
    const legend = viewer.legend();
    element('color_bar').toggleAttribute('hidden', legend === null);
    if (legend) Charts.colorBar(element('color_bar'), legend);
    this.showCut();
  }

  showCut() {
    const { viewer } = this;
    const { cut } = viewer;
    document.querySelector(`[name=cut][value=${cut.mode}]`).checked = true;
    document.querySelector(`[name=axis][value="${cut.axis}"]`).checked = true;
    element('cut_options').hidden = cut.mode === 'none';
    element('flip').checked = cut.flip;
    const [low, high] = viewer.extent(cut.axis);
    const position = cut.position === null ? (low + high) / 2 : cut.position;
    element('position').value = high > low ? 1000 * (position - low) / (high - low) : 500;
    element('position_value').textContent = `${'xyz'[cut.axis]} = ${Format.number(position)}`;
  }
}

// Shows the film of the page, or tables if the browser cannot draw it. Sets window.viewer. Throws Error if the
// film cannot be read.
async function show(modes) {
  const film = new Film(JSON.parse(element('film').textContent));
  document.title = film.title;
  element('title').textContent = film.title;
  let viewer;
  try {
    if (modes.includes('nogl')) throw new Error('WebGL 2 is switched off');
    viewer = new Viewer(film, element('canvas'));
  } catch (error) {
    await Tables.show(film, error.message);
    showMessage('');
    return;
  }
  window.viewer = viewer;
  viewer.controls = new Controls(viewer);
  showMessage('Decoding the film');
  await viewer.start();
  viewer.firstPicture = performance.now();
  showMessage('');
  viewer.ready = viewer.decodeRest();
  if (modes.includes('test')) await new SelfTest(viewer).run();
  if (modes.includes('bench')) await new Benchmark(viewer).run();
  await viewer.ready;
}

// Starts the page. Its address may end with #test, #bench or #nogl.
async function start() {
  const modes = location.hash.slice(1).split(',');
  const delay = modes.some((mode) => ['test', 'bench', 'nogl'].includes(mode)) ? new LoadDelay() : null;
  try {
    await show(modes);
  } catch (error) {
    showMessage(`The film cannot be shown: ${error.message}`);
    if (modes.includes('test')) element('verdict').textContent = `viewer: FAILED: ${error.message}`;
    throw error;
  } finally {
    if (delay) delay.release();
  }
}

document.addEventListener('DOMContentLoaded', start);
