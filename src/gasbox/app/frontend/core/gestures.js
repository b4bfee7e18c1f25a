// Wheel and pinch zoom, drag to move (a wall by its handle, else the view), double click or "0" to see all again, click to
// pick a particle, point with a mouse to read its numbers.
import { discsOf } from "./molecules.js";
import { extent } from "./outline.js";

const CLICK = 5; // CSS pixels that a finger may slip and still click

export class Gestures {
  // onView() after a change of the view; onPick(px, py) in device pixels; onPoint likewise, or without them; handles: of walls, see handles.js.
  constructor(element, view, handles, { onView, onPick, onPoint }) {
    this.element = element;
    this.view = view;
    this.handles = handles;
    this.onView = onView;
    this.onPick = onPick;
    this.onPoint = onPoint;
    this.pointers = new Map();
    this.ender = new AbortController();
    const on = (type, handler, options) =>
      element.addEventListener(type, handler.bind(this), { signal: this.ender.signal, ...options });
    on("wheel", this.wheel, { passive: false });
    on("pointerdown", this.down);
    on("pointermove", this.move);
    on("pointerup", this.up);
    on("pointercancel", this.cancel);
    on("pointerleave", () => this.onPoint());
    on("dblclick", this.reset);
    on("touchstart", this.touch, { passive: false });
    window.addEventListener("keydown", (event) => this.key(event), { signal: this.ender.signal });
  }

  place(event) {
    const frame = this.element.getBoundingClientRect();
    return [(event.clientX - frame.left) * this.view.ratio, (event.clientY - frame.top) * this.view.ratio];
  }

  wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 33 : event.deltaMode === 2 ? 400 : 1;
    const strength = event.ctrlKey ? 0.01 : 0.0015; // a pinch on a touchpad arrives as ctrl + wheel
    this.view.zoomAt(Math.exp(-event.deltaY * lines * strength), ...this.place(event));
    this.changed();
  }

  // A finger on a wall moves it, and does not scroll the page.
  touch(event) {
    if (event.touches.length === 1 && this.handles.find(...this.place(event.touches[0]), true)) event.preventDefault();
  }

  down(event) {
    if (event.button !== 0) return;
    this.element.setPointerCapture(event.pointerId);
    if (!this.pointers.size && this.handles.grab(...this.place(event), event.pointerType === "touch")) {
      this.holder = event.pointerId;
      this.onView();
      return;
    }
    this.pointers.set(event.pointerId, this.place(event));
    this.slipped = this.pointers.size > 1 ? Infinity : 0;
  }

  move(event) {
    if (event.pointerId === this.holder) {
      this.handles.drag(...this.place(event));
      this.onView();
      return;
    }
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      if (event.pointerType === "mouse") this.hover(...this.place(event));
      return;
    }
    const now = this.place(event);
    this.slipped += Math.abs(now[0] - before[0]) + Math.abs(now[1] - before[1]);
    if (this.pointers.size === 2) this.pinch(event.pointerId, before, now);
    else if (this.view.zoom > 1 && this.slipped > CLICK * this.view.ratio) {
      this.view.pan(now[0] - before[0], now[1] - before[1]);
      this.changed();
    }
    this.pointers.set(event.pointerId, now);
  }

  hover(px, py) {
    this.element.style.cursor = this.handles.cursor(px, py);
    this.onPoint(px, py);
  }

  pinch(id, before, now) {
    const [, other] = [...this.pointers].find(([key]) => key !== id);
    const distance = ([x, y]) => Math.max(1, Math.sqrt((x - other[0]) ** 2 + (y - other[1]) ** 2));
    this.view.zoomAt(distance(now) / distance(before), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
    this.view.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    this.changed();
  }

  up(event) {
    if (this.letGo(event)) return;
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.slipped <= CLICK * this.view.ratio) this.onPick(...this.place(event));
  }

  cancel(event) {
    if (this.letGo(event)) return;
    this.pointers.delete(event.pointerId);
  }

  letGo(event) {
    if (event.pointerId !== this.holder) return false;
    this.holder = undefined;
    this.handles.release();
    this.onView();
    return true;
  }

  key(event) {
    const typing = event.target.closest?.("input, textarea, select, [contenteditable]");
    if (event.key === "0" && !typing && !event.ctrlKey && !event.metaKey && !event.altKey) this.reset();
  }

  reset() {
    this.view.reset();
    this.changed();
  }

  // While all is seen, one finger scrolls the page (on a phone); zoomed in, it moves the box.
  changed() {
    this.element.style.touchAction = this.view.zoom > 1 ? "none" : "pan-y";
    this.onView();
  }

  destroy() {
    this.ender.abort();
  }
}

// Row of the particle at a place in the box, or null. Small discs may be missed by `slack` [length].
export function pick(frame, table, x, y, slack) {
  const [left, bottom, right, top] = extent(table, frame);
  const [width, height] = [right - left, top - bottom];
  const { count, position, species, radii, owner } = discsOf(frame, table);
  let best = null;
  let least = Infinity;
  for (let i = 0; i < count; i++) {
    let dx = Math.abs(position[2 * i] - x);
    let dy = Math.abs(position[2 * i + 1] - y);
    if (table.periodicX) dx = Math.min(dx, Math.abs(width - dx));
    if (table.periodicY) dy = Math.min(dy, Math.abs(height - dy));
    const distance = dx * dx + dy * dy;
    const reach = Math.max(radii[species[i]], slack);
    if (distance <= reach * reach && distance < least) {
      least = distance;
      best = owner ? owner[i] : i;
    }
  }
  return best;
}
