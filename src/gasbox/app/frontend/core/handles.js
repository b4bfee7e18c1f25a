// Walls that are dragged: which one a pointer is at, and where it is to go. The server lets it follow with bounded speed.
import { displacementOf } from "./outline.js";
import { grips } from "./walls.js";

const NEAR = 9; // CSS pixels from a wall, with a mouse
const NEAR_FINGER = 18;
const PAUSE = 60; // ms between two messages

export class Handles {
  // scene() gives what is shown; send(wall index, displacement) and drop(wall index) tell the server.
  constructor(scene, { send, drop }) {
    this.scene = scene;
    this.send = send;
    this.drop = drop;
    this.held = null; // { wall, target, now }: index, and displacements asked for and reached
    this.told = 0;
  }

  // The handle at a place on the canvas, or null.
  find(px, py, finger) {
    const scene = this.scene();
    if (!scene?.frame) return null;
    const slack = (finger ? NEAR_FINGER : NEAR) * scene.view.ratio;
    const near = grips(scene).map((grip) => [away(px, py, grip), grip]).filter(([distance]) => distance <= slack);
    return near.length ? near.reduce((a, b) => (b[0] < a[0] ? b : a))[1] : null;
  }

  cursor(px, py) {
    const grip = this.find(px, py, false);
    if (!grip) return "";
    return Math.abs(grip.across[0]) > Math.abs(grip.across[1]) ? "ew-resize" : "ns-resize";
  }

  grab(px, py, finger) {
    const grip = this.find(px, py, finger);
    if (!grip) return false;
    const now = displacementOf(grip.wall, this.scene().frame);
    this.held = { wall: grip.wall.index, target: now, now };
    this.origin = { px, py, across: grip.across, displacement: now };
    return true;
  }

  drag(px, py) {
    const { origin, held } = this;
    const { view } = this.scene();
    const way = (px - origin.px) * origin.across[0] + (py - origin.py) * origin.across[1];
    held.target = origin.displacement + way / view.scale;
    const wait = this.told + PAUSE - performance.now();
    clearTimeout(this.timer);
    if (wait <= 0) this.tell();
    else this.timer = setTimeout(() => this.tell(), wait);
  }

  tell() {
    this.told = performance.now();
    if (this.held) this.send(this.held.wall, this.held.target);
  }

  release() {
    if (!this.held) return;
    clearTimeout(this.timer);
    this.tell();
    this.drop(this.held.wall);
    this.held = null;
  }

  // What the scene shows of it.
  seen(frame) {
    if (this.held) this.held.now = frame?.displacement[this.held.wall] ?? this.held.now;
    return this.held;
  }
}

// Distance of a place from a line, in pixels; infinite beyond its ends.
function away(px, py, { from, to, x, y, across }) {
  const along = [-across[1], across[0]];
  const place = (p, q) => p * along[0] + q * along[1];
  const ends = [place(...from), place(...to)];
  const at = place(px, py);
  if (at < Math.min(...ends) || at > Math.max(...ends)) return Infinity;
  return Math.abs((px - x) * across[0] + (py - y) * across[1]);
}
