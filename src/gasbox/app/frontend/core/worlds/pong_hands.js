// Who moves which bat: keys push it, a mouse or a finger says where it is to go. Values go out at once, each setting at
// most once per animation frame, and the newest counts.

export const SIDES = ["left", "right"];
const PAIRS = { w: ["left", 1], s: ["left", -1], arrowup: ["right", 1], arrowdown: ["right", -1] };
const TAP = 300; // ms
const SLIP = 12; // CSS pixels that a finger may slip and still tap

// At most one message for each setting between two animation frames.
export class Outbox {
  constructor(send, nextFrame = (call) => requestAnimationFrame(call)) {
    this.send = send;
    this.nextFrame = nextFrame;
    this.waiting = new Map();
    this.said = new Map();
    this.open = true;
  }

  put(name, value) {
    this.waiting.set(name, value);
    if (this.open) this.flush();
  }

  flush() {
    const news = [...this.waiting].filter(([name, value]) => this.said.get(name) !== value);
    this.waiting.clear();
    for (const [name, value] of news) {
      this.said.set(name, value);
      this.send(name, value);
    }
    if (!news.length) return;
    this.open = false;
    this.nextFrame(() => {
      this.open = true;
      this.flush();
    });
  }
}

export class Hands {
  // send(name, value); onTap(): the box was clicked or tapped
  constructor(send, onTap) {
    this.outbox = new Outbox(send);
    this.onTap = onTap;
    this.humans = [];
    this.held = []; // keys, the newest last
    this.fingers = new Map(); // pointer id -> { side, x, y, at }
    this.pushed = {}; // side -> way
    this.moved = false; // whether anybody has touched a bat yet
  }

  // players: who plays on each side; bats: low and high of each [length]
  know(players, bats) {
    this.bats = bats;
    const humans = SIDES.filter((side) => players?.[side] === "human");
    if (humans.join() === this.humans.join()) return;
    this.release();
    this.humans = humans;
    this.moved = false;
  }

  // A single human has all keys.
  sideOf(side) {
    return this.humans.length === 1 ? this.humans[0] : this.humans.includes(side) ? side : null;
  }

  key(name, down, repeated) {
    const side = name in PAIRS ? this.sideOf(PAIRS[name][0]) : null;
    if (!side) return false;
    if (!repeated) {
      this.held = this.held.filter((one) => one !== name);
      if (down) this.held.push(name);
      if (down) this.moved = true;
      this.push();
    }
    return true;
  }

  push() {
    for (const side of this.humans) {
      const newest = this.held.findLast((name) => this.sideOf(PAIRS[name][0]) === side);
      const way = newest ? PAIRS[newest][1] : 0;
      if (way === (this.pushed[side] ?? 0)) continue;
      this.pushed[side] = way;
      this.outbox.said.delete(`${side}_target`); // the same place is news again
      this.outbox.put(`${side}_push`, way);
    }
  }

  release() {
    this.held = [];
    this.fingers.clear();
    this.push();
  }

  // x, y in the box; middle: half its width. Whether it was for a bat.
  pointer(x, y, event, middle) {
    const { type, pointerId, pointerType } = event;
    // A mouse that was let go outside of the box tells so only by what it no longer presses.
    if (type === "pointermove" && pointerType === "mouse" && event.buttons === 0) this.fingers.delete(pointerId);
    const held = this.fingers.get(pointerId);
    if (type === "pointerup" || type === "pointercancel") {
      this.fingers.delete(pointerId);
      if (held && type === "pointerup" && tapped(held, event)) this.onTap();
      return held !== undefined;
    }
    if (type === "pointermove" && !held && pointerType !== "mouse") return false;
    const side = held?.side ?? this.sideOf(x < middle ? "left" : "right");
    if (!side) return false;
    if (type === "pointerdown") {
      this.fingers.set(pointerId, { side, x: event.clientX, y: event.clientY, at: event.timeStamp });
    }
    // A mouse that is held down stays with its bat; one that only moves past a resting finger's bat does not take it.
    if (pointerType === "mouse" && this.others(side, pointerId)) return true;
    this.aim(side, y);
    return true;
  }

  others(side, id) {
    return [...this.fingers].some(([other, finger]) => other !== id && finger.side === side);
  }

  aim(side, y) {
    const { low = -Infinity, high = Infinity } = this.bats?.[side] ?? {};
    this.moved = true;
    this.outbox.put(`${side}_target`, Math.min(Math.max(y, low), high));
  }
}

function tapped({ x, y, at }, event) {
  const slip = Math.max(Math.abs(event.clientX - x), Math.abs(event.clientY - y));
  return event.timeStamp - at <= TAP && slip <= SLIP;
}
