// What is really shown, for readouts, tests and benchmarks: window.gasboxStats.

export class Stats {
  constructor(renderer) {
    this.renderer = renderer;
    this.received = 0; // frames over the socket
    this.drawn = 0;
    this.errors = 0; // frames that could not be decoded or drawn
    this.drawMs = 0; // sliding mean
    this.firstFrame = null; // ms since navigation
    this.number = null;
    this.time = null;
    this.count = null;
    this.playing = null;
    this.connected = false;
    this.moments = [];
  }

  drew(frame, began) {
    const now = performance.now();
    this.drawn++;
    this.firstFrame ??= now;
    this.drawMs += (now - began - this.drawMs) * (this.drawn === 1 ? 1 : 0.1);
    this.number = frame.number;
    this.time = frame.time;
    this.count = frame.count;
    this.playing = frame.playing;
    this.moments.push(now);
    if (this.moments.length > 1200) this.moments.splice(0, 600);
  }

  // Frames shown per second over the last seconds.
  get fps() {
    return this.shown(2);
  }

  shown(seconds) {
    const since = performance.now() - 1000 * seconds;
    return this.moments.filter((moment) => moment >= since).length / seconds;
  }
}
