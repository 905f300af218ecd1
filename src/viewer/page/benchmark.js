// Delays the load event until a release, so that a browser without a screen waits before it prints the page.
class LoadDelay {
  constructor() {
    this.frame = make('iframe');
    this.frame.hidden = true;
    document.body.append(this.frame);
    this.frame.contentDocument.open();
  }

  release() { this.frame.contentDocument.close(); }
}

// Measures times in milliseconds. Runs if the address ends with #bench.
class Benchmark {
  constructor(viewer) { this.viewer = viewer; }

  // Returns the mean time of an action over some repetitions.
  measure(repetitions, action) {
    const start = performance.now();
    for (let i = 0; i < repetitions; i++) action(i);
    return (performance.now() - start) / repetitions;
  }

  async run() {
    const { viewer } = this;
    const { film } = viewer;
    await viewer.ready;
    const decoded = performance.now();
    const lines = [['first picture', viewer.firstPicture], ['all frames decoded', decoded]];
    if (film.cells) {
      const frame = (i) => film.frames[i % film.count];
      lines.push(['neighbors', this.measure(5, (i) => Geometry.neighbors(frame(i).simplices, film.corners))]);
      lines.push(['qualities', this.measure(5, (i) => Measures.qualities(frame(i), film.corners))]);
      lines.push(['angles', this.measure(5, (i) => Measures.angles(frame(i), film.corners))]);
    }
    lines.push(['surface', this.measure(5, () => viewer.surface(viewer.frame, viewer.paint(viewer.frame)))]);
    if (film.cells && film.dimension === 3) {
      viewer.setCut({ mode: 'flat' });
      lines.push(['flat cut', this.measure(5, () => viewer.updateSection())]);
      viewer.setCut({ mode: 'none' });
    }
    lines.push(['picture with readback', this.measure(5, () => viewer.pixels())]);
    element('verdict').hidden = false;
    element('verdict').textContent = lines.map(([name, time]) => `bench: ${name}: ${time.toFixed(1)} ms`).join('\n');
  }
}
