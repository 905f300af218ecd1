// Plays the frames of a viewer and records them.
class Playback {
  constructor(viewer, changed) {
    Object.assign(this, { viewer, changed });
    this.rate = 5;
    this.playing = false;
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  // Plays from the shown frame, or from the first one if the last one is shown.
  play() {
    const { viewer } = this;
    if (this.playing || viewer.film.count < 2) return;
    this.playing = true;
    this.due = performance.now() + 1000 / this.rate;
    if (viewer.frame.index === viewer.film.count - 1) viewer.showFrame(0);
    this.changed();
    this.wait();
  }

  pause() {
    clearTimeout(this.timer);
    this.playing = false;
    this.changed();
  }

  // Waits until the next frame is due. A delay does not skip frames.
  wait() {
    this.due = Math.max(this.due, performance.now());
    this.timer = setTimeout(() => this.advance(), this.due - performance.now());
  }

  // Shows the next frame; a frame that is not decoded yet is awaited.
  async advance() {
    const { viewer } = this;
    this.due += 1000 / this.rate;
    await viewer.showFrame(viewer.frame.index + 1);
    if (!this.playing) return;
    if (viewer.frame.index === viewer.film.count - 1) this.pause();
    else this.wait();
  }

  // Returns the video format that the browser can record. Throws Error if there is none.
  static format() {
    const types = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm', 'video/mp4'];
    const able = typeof MediaRecorder !== 'undefined' && HTMLCanvasElement.prototype.captureStream;
    const type = able && types.find((one) => MediaRecorder.isTypeSupported(one));
    if (!type) throw new Error('This browser cannot record a canvas. Save single pictures, or open the page in Firefox or Chrome.');
    return type;
  }

  // Records all frames in real time. Calls progress(index) before each frame. Returns the blob of the video.
  async record(progress) {
    const type = Playback.format();
    const { viewer } = this;
    this.pause();
    const before = viewer.frame.index;
    const stream = viewer.canvas.captureStream(0);
    const [track] = stream.getVideoTracks();
    const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 8e6 });
    const parts = [];
    recorder.addEventListener('dataavailable', (event) => { if (event.data.size > 0) parts.push(event.data); });
    const stopped = new Promise((resolve, reject) => {
      recorder.addEventListener('stop', resolve);
      recorder.addEventListener('error', (event) => reject(event.error || new Error('The recording failed.')));
    });
    recorder.start();
    for (let i = 0; i < viewer.film.count; i++) {
      progress(i);
      await viewer.showFrame(i);
      viewer.redraw();
      if (track.requestFrame) track.requestFrame();
      else stream.requestFrame();
      await new Promise((resolve) => setTimeout(resolve, 1000 / this.rate));
    }
    recorder.stop();
    await stopped;
    track.stop();
    await viewer.showFrame(before);
    return new Blob(parts, { type: type.split(';')[0] });
  }
}
