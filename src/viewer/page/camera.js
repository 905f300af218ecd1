// Products and sums of vectors with three components.
const Vector = {
  add: (a, b, scale = 1) => a.map((x, i) => x + scale * b[i]),
  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
  cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
  unit: (a) => { const length = Math.hypot(...a) || 1; return a.map((x) => x / length); },
};

// A camera that looks at a target point: perspective in 3D, orthographic in 2D.
class Camera {
  constructor(dimension) {
    this.flat = dimension === 2;
    this.up = 2;
    this.slope = Math.tan(Math.PI / 12);
    this.box = [0, 0, 0, 1, 1, 1];
    this.touched = false;
    this.reset();
  }

  // Returns the direction from the target to the initial position of the camera.
  initialDirection() {
    if (this.flat) return [0, 0, 1];
    const [right, up, out] = this.initialAxes();
    return Vector.unit(Vector.add(Vector.add(out, right, 0.55), up, 0.45));
  }

  // Returns the coordinate axes that point to the right, up and out of the screen at the start.
  initialAxes() {
    if (this.up === 0) return [[0, 1, 0], [1, 0, 0], [0, 0, -1]];
    if (this.up === 1) return [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    return [[1, 0, 0], [0, 0, 1], [0, -1, 0]];
  }

  // Fits the box into the picture, from the initial direction.
  reset() {
    const out = this.initialDirection();
    const up = this.flat ? [0, 1, 0] : this.initialAxes()[1];
    const right = Vector.unit(Vector.cross(up, out));
    this.home = [right, Vector.cross(out, right), out];
    this.axes = this.home;
    this.target = [0, 1, 2].map((i) => (this.box[i] + this.box[3 + i]) / 2);
    this.zoom = 1;
    this.touched = false;
  }

  // Returns the distance from the target at which the box fills the picture of the initial view.
  fittingDistance(aspect) {
    const half = [0, 1, 2].map((i) => Math.max((this.box[3 + i] - this.box[i]) / 2, 0));
    this.radius = Math.hypot(...half) || 1;
    let distance = 0;
    for (let i = 0; i < 8; i++) {
      const corner = half.map((length, axis) => (i >> axis & 1 ? length : -length));
      const [x, y, z] = this.home.map((axis) => Vector.dot(axis, corner));
      const needed = Math.max(Math.abs(y), Math.abs(x) / aspect) * 1.12 / this.slope;
      distance = Math.max(distance, needed + (this.flat ? 0 : z));
    }
    return distance || this.radius / this.slope;
  }

  // Returns the matrices for a picture of an aspect ratio. All content lies within a box of the domain.
  matrices(aspect, domain) {
    this.distance = this.fittingDistance(aspect) / this.zoom;
    const [right, up, out] = this.axes;
    const view = new Float32Array(16);
    this.axes.forEach((axis, row) => {
      for (let column = 0; column < 3; column++) view[4 * column + row] = axis[column];
      view[12 + row] = -Vector.dot(axis, this.target);
    });
    view[14] -= this.distance;
    view[15] = 1;
    const center = [0, 1, 2].map((i) => (domain[i] + domain[3 + i]) / 2);
    const reach = Math.hypot(domain[3] - center[0], domain[4] - center[1], domain[5] - center[2]) * 1.01 + 1;
    const depth = this.distance - Vector.dot(out, Vector.add(center, this.target, -1));
    const far = Math.max(depth + reach, this.distance * 1.1);
    const near = this.flat ? Math.min(depth - reach, 0) : Math.max(depth - reach, far / 5000);
    return { view, projection: this.projection(aspect, near, far), right, up };
  }

  projection(aspect, near, far) {
    const matrix = new Float32Array(16);
    const height = this.flat ? this.slope * this.distance : this.slope;
    matrix[0] = 1 / (height * aspect);
    matrix[5] = 1 / height;
    if (this.flat) {
      matrix[10] = -2 / (far - near);
      matrix[14] = -(far + near) / (far - near);
      matrix[15] = 1;
    } else {
      matrix[10] = -(far + near) / (far - near);
      matrix[11] = -1;
      matrix[14] = -2 * far * near / (far - near);
    }
    return matrix;
  }

  // Rotates the view by angles about the vertical and the horizontal direction of the screen.
  orbit(horizontal, vertical) {
    const turn = (a, b, angle) => {
      const c = Math.cos(angle), s = Math.sin(angle);
      [this.axes[a], this.axes[b]] = [
        Vector.add(this.axes[a].map((x) => c * x), this.axes[b], s),
        Vector.add(this.axes[b].map((x) => c * x), this.axes[a], -s)];
    };
    turn(0, 2, horizontal);
    turn(1, 2, -vertical);
    // Rounding errors of many small rotations must not add up.
    const out = Vector.unit(this.axes[2]);
    const right = Vector.unit(Vector.cross(this.axes[1], out));
    this.axes = [right, Vector.cross(out, right), out];
    this.touched = true;
  }

  // Moves the picture by a share of its height.
  pan(right, up) {
    const scale = 2 * this.slope * this.distance;
    this.target = Vector.add(Vector.add(this.target, this.axes[0], -right * scale), this.axes[1], -up * scale);
    this.touched = true;
  }

  // Enlarges the picture by a factor about a point, given in shares of the picture's height from its center.
  magnify(factor, right = 0, up = 0) {
    const zoom = Math.min(500, Math.max(0.1, this.zoom * factor));
    const share = 1 - this.zoom / zoom;
    this.pan(-right * share, -up * share);
    this.zoom = zoom;
  }
}

// Mouse, touch and pen gestures on a canvas that move a camera.
class Gestures {
  constructor(canvas, camera, changed, reset) {
    Object.assign(this, { canvas, camera, changed });
    this.pointers = new Map();
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      canvas.addEventListener(name, (event) => this.pointers.delete(event.pointerId));
    }
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('dblclick', () => reset());
  }

  down(event) {
    // A synthetic event has no pointer that could be captured.
    if (event.isTrusted) this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    this.panning = event.button !== 0 || event.shiftKey || event.ctrlKey;
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const height = this.canvas.clientHeight;
    const x = (event.clientX - before[0]) / height, y = (event.clientY - before[1]) / height;
    const other = [...this.pointers].find(([id]) => id !== event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (other) this.pinch(before, [event.clientX, event.clientY], other[1]);
    else if (this.camera.flat || this.panning) this.camera.pan(x, -y);
    else this.camera.orbit(3.5 * x, 3.5 * y);
    this.changed();
  }

  // Zooms by the change of the distance between two fingers and pans by the motion of their center.
  pinch(before, after, other) {
    const height = this.canvas.clientHeight;
    const length = (p) => Math.max(10, Math.hypot(p[0] - other[0], p[1] - other[1]));
    this.camera.pan((after[0] - before[0]) / 2 / height, -(after[1] - before[1]) / 2 / height);
    this.camera.magnify(length(after) / length(before), ...this.place((after[0] + other[0]) / 2, (after[1] + other[1]) / 2));
  }

  wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    const delta = Math.max(-200, Math.min(200, event.deltaY * lines));
    this.camera.magnify(Math.exp(-0.0016 * delta), ...this.place(event.clientX, event.clientY));
    this.changed();
  }

  // Returns a point of the window in shares of the canvas's height from the canvas's center.
  place(x, y) {
    const area = this.canvas.getBoundingClientRect();
    return [(x - area.left - area.width / 2) / area.height, -(y - area.top - area.height / 2) / area.height];
  }
}
