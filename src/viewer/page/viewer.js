// The state of the viewer, and the picture that belongs to it. Controls and notebooks call its methods.
class Viewer {
  constructor(film, canvas) {
    this.film = film;
    this.canvas = canvas;
    this.renderer = new Renderer(canvas);
    this.camera = new Camera(film.dimension);
    this.frame = null;
    this.wanted = 0;
    this.decoded = 0;
    this.shown = film.labels.map((label) => !film.hidden.includes(label));
    this.color = 'label';
    this.wire = false;
    this.box = false;
    this.cut = { mode: 'none', axis: 0, position: null, flip: false };
    this.domain = Geometry.emptyBox();
    this.recent = [];
    this.stale = { surface: true, section: true, picture: true };
    this.request = 0;
    this.listeners = [];
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => { this.renderer.restore(); this.invalidate('surface'); });
  }

  // Calls a function after each change of the frame ('frame'), of a setting ('setting'), of the camera ('camera')
  // and after each decoded frame ('decoded').
  listen(listener) { this.listeners.push(listener); }
  tell(what) { for (const listener of this.listeners) listener(what); }

  // Decodes and draws the first frame.
  async start() {
    const first = await this.film.decode(0);
    this.receive(first);
    this.use(first);
    this.resetCamera();
    this.flush();
  }

  // Decodes all other frames; the page stays responsive between them.
  async decodeRest() {
    for (let i = 1; i < this.film.count; i++) {
      await new Promise((resolve) => setTimeout(resolve));
      this.receive(await this.film.decode(i));
    }
    if (!this.camera.touched) this.resetCamera();
  }

  receive(frame) {
    this.decoded = frame.index + 1;
    Geometry.enlargeBox(this.domain, frame, this.film.corners, null);
    this.tell('decoded');
  }

  // Shows a frame. Returns a promise that is resolved when the frame is drawn; a frame that is not decoded yet follows.
  async showFrame(index) {
    this.wanted = Math.max(0, Math.min(this.film.count - 1, Math.round(index)));
    const frame = await this.film.decode(this.wanted);
    if (frame.index === this.wanted) this.use(frame);
    this.flush();
  }

  use(frame) {
    this.frame = frame;
    this.invalidate('surface');
    this.tell('frame');
  }

  // Shows only the given labels.
  setLabels(labels) {
    this.shown = this.film.labels.map((label) => labels.includes(label));
    this.change('surface');
  }

  // Sets some of mode ('none', 'cells', 'flat'), axis (0, 1, 2), position (a coordinate) and flip.
  setCut(changes) {
    Object.assign(this.cut, changes);
    if (this.film.dimension === 2 || (!this.film.cells && this.cut.mode === 'cells')) this.cut.mode = 'none';
    this.change(this.cut.mode === 'flat' && Object.keys(changes).join() === 'position' ? 'section' : 'surface');
  }

  // Colors by 'label', 'quality' or the name of a field.
  setColor(color) {
    this.color = color;
    this.change('surface');
  }

  setWireframe(wire) {
    this.wire = wire;
    this.change('picture');
  }

  // Shows or hides the box of the domain.
  setBox(box) {
    this.box = box;
    this.change('surface');
  }

  // Sets the coordinate axis that points up, and resets the camera.
  setUp(axis) {
    this.camera.up = axis;
    this.resetCamera();
    this.change('surface');
  }

  // Fits the shown labels in all decoded frames into the picture.
  resetCamera() {
    const box = Geometry.emptyBox();
    for (const frame of this.film.frames) {
      if (frame) Geometry.enlargeBox(box, frame, this.film.corners, this.shown);
    }
    this.camera.box = box[0] <= box[3] ? box : this.domain.slice();
    this.camera.reset();
    this.invalidate('picture');
  }

  change(part) {
    this.invalidate(part);
    this.tell('setting');
  }

  // Requests that a part ('surface', 'section' or only the 'picture') is computed again before the next picture.
  invalidate(part) {
    this.stale.picture = true;
    if (part !== 'picture') this.stale.section = true;
    if (part === 'surface') this.stale.surface = true;
    if (!this.request) this.request = requestAnimationFrame(() => this.flush());
  }

  // Draws now if anything has changed.
  flush() {
    cancelAnimationFrame(this.request);
    this.request = 0;
    if (!this.frame || !this.stale.picture) return;
    if (this.stale.surface) this.updateSurface();
    if (this.stale.section) this.updateSection();
    this.draw();
    this.stale = { surface: false, section: false, picture: false };
  }

  // Returns the cut in units of the grid, null if the mode is another one. The side towards the initial camera is cut off.
  gridCut(mode) {
    const { cut, film } = this;
    if (cut.mode !== mode) return null;
    const position = cut.position === null ? (this.domain[cut.axis] + this.domain[3 + cut.axis]) / 2
      : (cut.position - film.origin[cut.axis]) / film.unit;
    const sign = (this.camera.initialDirection()[cut.axis] < 0) === cut.flip ? 1 : -1;
    return { axis: cut.axis, position, sign };
  }

  // Returns the coordinates of the domain's ends on an axis.
  extent(axis) {
    const at = (q) => this.film.origin[axis] + this.film.unit * q;
    return [at(this.domain[axis]), at(this.domain[3 + axis])];
  }

  // Returns the colors of labels and the values of a frame, or no values for colors by label.
  paint(frame) {
    const { film } = this;
    const paint = { colors: film.colors.map((color) => Colors.pack(Colors.parse(color))), values: null };
    if (this.color === 'quality') paint.values = this.prepare(frame).qualities;
    const field = film.fields.find((one) => one.name === this.color);
    if (field && frame.fields[field.name]) paint.values = frame.fields[field.name];
    paint.ofVertices = Boolean(field) && field.of === 'vertices';
    return paint;
  }

  // Computes the neighbors and qualities of a frame; keeps those of the most recent frames.
  prepare(frame) {
    if (!this.film.cells || frame.neighbors) return frame;
    frame.neighbors = Geometry.neighbors(frame.simplices, this.film.corners);
    frame.qualities = Measures.qualities(frame, this.film.corners);
    this.recent.push(frame);
    let total = this.recent.reduce((sum, one) => sum + one.simplexCount, 0);
    while (total > 4e6 && this.recent.length > 1) {
      const oldest = this.recent.shift();
      total -= oldest.simplexCount;
      oldest.neighbors = oldest.qualities = null;
    }
    return frame;
  }

  // Returns the triangles and line segments of a frame with the current labels and cut: WordBuffers or null.
  surface(frame, paint) {
    const { film, shown } = this;
    if (!film.cells) {
      if (film.dimension === 3) return { surface: Geometry.storedSurface(frame, shown, paint), edges: null };
      return { surface: null, edges: Geometry.storedEdges(frame, shown, paint) };
    }
    const visible = Geometry.visibleCells(this.prepare(frame), film.corners, shown, this.gridCut('cells'));
    if (film.dimension === 3) return { surface: Geometry.cellSurface(frame, visible, paint), edges: null };
    const line = Colors.pack(Theme.color('--line'));
    return { surface: Geometry.planeCells(frame, visible, paint), edges: Geometry.planeInterface(frame, visible, line) };
  }

  updateSurface() {
    const { renderer } = this;
    const paint = this.paint(this.frame);
    const { surface, edges } = this.surface(this.frame, paint);
    this.byValue = paint.values !== null;
    renderer.upload('surface', surface);
    renderer.upload('edges', edges);
    renderer.upload('box', this.box ? Geometry.boxEdges(this.domain, Colors.pack(Theme.color('--box'))) : null);
  }

  updateSection() {
    const cut = this.gridCut('flat');
    const section = cut && this.film.cells ? Geometry.section(this.frame, this.shown, cut, this.paint(this.frame)) : null;
    this.renderer.upload('section', section);
  }

  draw() {
    const aspect = this.renderer.resize();
    const { view, projection, right, up } = this.camera.matrices(aspect, this.domain);
    const cut = this.gridCut('flat');
    let plane = null;
    if (cut) {
      plane = [0, 0, 0, cut.sign * cut.position];
      plane[cut.axis] = cut.sign;
    }
    this.renderer.draw({
      background: Theme.color('--canvas'), view, projection, plane, byValue: this.byValue, wire: this.wire,
      lit: this.film.dimension === 3, size: this.camera.radius,
    });
    this.screenAxes = [right, up];
    this.tell('camera');
  }

  // Returns the numbers of a decoded frame for display and for notebooks.
  numbers(index = this.frame.index) {
    const { film } = this;
    const frame = film.frames[index];
    const result = { frame: index, step: frame.step, time: frame.time, vertices: frame.vertexCount };
    if (!film.cells) return Object.assign(result, { facets: frame.simplexCount });
    if (!frame.measures) {
      this.prepare(frame);
      const angles = Measures.angles(frame, film.corners);
      const worst = frame.qualities.reduce((low, quality) => Math.min(low, quality), 1);
      frame.measures = { angles, worst, facets: Geometry.interfaceFacets(frame, film.corners) };
    }
    const { angles, worst, facets } = frame.measures;
    return Object.assign(result, {
      cells: frame.simplexCount, facets, smallestAngle: angles.smallest, largestAngle: angles.largest,
      worstQuality: worst, bins: angles.bins,
    });
  }

  // Draws and returns the pixels of the picture: width, height and bytes from the bottom row.
  pixels() {
    this.redraw();
    return this.renderer.pixels();
  }

  // Returns the meaning of the colors: a title, and the values of the first and the last color; null for labels.
  legend() {
    if (this.color === 'quality') {
      return { title: this.film.dimension === 3 ? 'volume-length ratio' : 'area-length ratio', low: 0, high: 1 };
    }
    const field = this.film.fields.find((one) => one.name === this.color);
    return field ? { title: field.name, low: field.minimum, high: field.maximum } : null;
  }

  // Draws and returns the picture, with a color bar if there is one, as a PNG blob.
  picture() {
    this.redraw();
    const copy = document.createElement('canvas');
    copy.width = this.canvas.width;
    copy.height = this.canvas.height;
    const context = copy.getContext('2d');
    context.drawImage(this.canvas, 0, 0);
    const legend = this.legend();
    if (legend) Charts.drawColorBar(context, legend);
    return new Promise((resolve) => copy.toBlob(resolve, 'image/png'));
  }

  redraw() {
    this.stale.picture = true;
    this.flush();
  }
}

// Colors of the style sheet, which depend on the light or dark scheme.
const Theme = {
  cache: new Map(),
  color(name) {
    if (!Theme.cache.has(name)) {
      Theme.cache.set(name, Colors.parse(getComputedStyle(document.documentElement).getPropertyValue(name).trim()));
    }
    return Theme.cache.get(name);
  },
};
