// The world on top of the gas, if there is one: it draws over the discs, and keys and pointers are its before all others.
import { WORLDS } from "./worlds/index.js";

const POINTS = ["pointerdown", "pointermove", "pointerup", "pointercancel"];

function typing(target) {
  return target.closest?.("input, textarea, select, [contenteditable], .q-dialog, .q-menu");
}

export class WorldOverlay {
  // send(name, value) gives a setting of the world another value.
  constructor(lab, send) {
    this.lab = lab;
    this.send = send;
    this.kind = null;
    this.world = null;
    this.ender = new AbortController();
    const options = { capture: true, signal: this.ender.signal };
    window.addEventListener("keydown", (event) => this.key(event, true), options);
    window.addEventListener("keyup", (event) => this.key(event, false), options);
    for (const type of POINTS) lab.element.addEventListener(type, (event) => this.pointer(event), options);
  }

  // There is another table: perhaps another world.
  settle(kind) {
    if (kind === this.kind) return;
    this.world?.destroy?.();
    this.kind = kind;
    this.world = kind in WORLDS ? new WORLDS[kind](this.lab, this.send) : null;
  }

  // CSS pixels: no disc is drawn with a smaller radius.
  get least() {
    return this.world?.constructor.LEAST ?? 0;
  }

  hear(view) {
    this.world?.hear?.(view);
    this.lab.schedule();
  }

  draw(context, scene) {
    if (!context || !this.world) return;
    context.save();
    this.world.draw(context, scene);
    context.restore();
  }

  key(event, down) {
    if (!this.world?.key) return;
    // A key that is let go is always told, or it would seem to be held for ever.
    if (down && (event.ctrlKey || event.metaKey || event.altKey || typing(event.target))) return;
    if (this.world.key(event, down)) keep(event);
  }

  pointer(event) {
    if (!this.world?.pointer || !this.lab.table) return;
    const { view, element } = this.lab;
    const frame = element.getBoundingClientRect();
    const [px, py] = [event.clientX - frame.left, event.clientY - frame.top];
    if (this.world.pointer(...view.toBox(px * view.ratio, py * view.ratio), event)) keep(event);
  }

  destroy() {
    this.ender.abort();
    this.world?.destroy?.();
  }
}

function keep(event) {
  event.preventDefault();
  event.stopImmediatePropagation();
}
