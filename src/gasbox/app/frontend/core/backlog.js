// Frames that have arrived and are not drawn yet: two at most, the others are stale.
//
// Server and screen keep 60 beats a second each, but not the same ones. Of two frames that arrive between two beats of the
// screen the older one is drawn first, and the newer one is spared for the next beat, which otherwise may come up
// empty. Only once in a row, though: whoever draws more slowly than frames arrive is shown the newest.

export class Backlog {
  constructor() {
    this.clear();
  }

  clear() {
    this.waiting = [];
    this.spared = false;
  }

  put(frame) {
    this.waiting.push(frame);
    if (this.waiting.length > 2) this.waiting.shift();
  }

  // The frame to draw now, or null.
  take() {
    if (this.waiting.length === 2 && this.spared) this.waiting.shift();
    this.spared = this.waiting.length === 2;
    return this.waiting.shift() ?? null;
  }
}
