// The live box, without any framework: createLab(element, options) draws a session's frames into an element.
import { CpuRenderer } from "./cpu.js";
import { Gestures, pick } from "./gestures.js";
import { Handles } from "./handles.js";
import { Message } from "./message.js";
import { grown, reach } from "./outline.js";
import { Trail, drawOverlay } from "./overlay.js";
import { chooseRenderer } from "./probe.js";
import { decodeFrame, decodeTable, encodeDrag, encodeDrop, encodePoint, encodeSetting } from "./protocol.js";
import { palettes } from "./shades.js";
import { FrameSocket } from "./socket.js";
import { Stats } from "./stats.js";
import { installStyle, readTheme, watchTheme } from "./theme.js";
import { Tip } from "./tip.js";
import { View } from "./view.js";
import { GlRenderer } from "./webgl2.js";
import { WorldOverlay } from "./world.js";

export { decodeFrame, decodeTable };

const SLACK = 5; // CSS pixels by which a click may miss a small disc

// options: session (id), renderer ("cpu", "gl", else by probe), guest (a second box on the page), onPick(row or null),
// onNotice({ kind, ... })
export function createLab(element, options) {
  return new Lab(element, options);
}

// Device pixels: the browser's own count if it has one. It is not believed where it is far off, because an emulated
// screen of high density counts pixels of the real one.
function snapped(estimate, exact) {
  return exact !== undefined && Math.abs(exact - estimate) <= 2 ? exact : Math.round(estimate);
}

// What two tables have in common if they are of the same gas, before and after a change.
function kin({ shape, width, height, names, walls }) {
  return JSON.stringify([shape, width, height, names, walls.map(({ name }) => name)]);
}

class Lab {
  constructor(element, { session, renderer, guest, onPick, onNotice }) {
    installStyle();
    element.classList.add("gasbox-lab");
    this.element = element;
    this.onPick = onPick;
    this.onNotice = onNotice;
    this.view = new View();
    this.trail = new Trail();
    this.message = new Message(element);
    this.tip = new Tip(element);
    this.renderer = this.makeRenderer(chooseRenderer(renderer));
    this.stats = new Stats(this.renderer.name);
    window[guest ? "gasboxGuestStats" : "gasboxStats"] = this.stats;
    this.table = this.frame = null;
    this.ticket = 0;
    this.unwatch = watchTheme(() => this.restyle());
    this.sizer = new ResizeObserver((entries) => this.resized(entries[0]));
    this.observeSize();
    this.handles = new Handles(() => this.table && this.scene(), {
      send: (wall, displacement) => this.socket.send(encodeDrag(wall, displacement)),
      drop: (wall) => this.socket.send(encodeDrop(wall)),
    });
    this.world = new WorldOverlay(this, (name, value) => this.socket.send(encodeSetting(name, value)));
    this.gestures = new Gestures(element, this.view, this.handles, {
      onView: () => this.schedule(),
      onPick: (px, py) => this.picked(px, py),
      onPoint: (px, py) => this.point(px === undefined ? null : this.rowAt(px, py)),
    });
    this.restyle();
    this.socket = new FrameSocket(session, {
      onFrame: () => this.schedule(),
      onText: (message) => this.hear(message),
      guest,
    });
  }

  makeRenderer(kind) {
    const canvas = document.createElement("canvas");
    this.element.prepend(canvas);
    if (kind === "cpu") return new CpuRenderer(canvas);
    const overlay = document.createElement("canvas");
    overlay.className = "gasbox-overlay";
    canvas.after(overlay);
    try {
      return new GlRenderer(canvas, overlay);
    } catch {
      canvas.remove();
      overlay.remove();
      return this.makeRenderer("cpu");
    }
  }

  observeSize() {
    try {
      this.sizer.observe(this.element, { box: "device-pixel-content-box" });
    } catch {
      this.sizer.observe(this.element); // Safari
    }
  }

  resized(entry) {
    const ratio = window.devicePixelRatio || 1;
    const exact = entry.devicePixelContentBoxSize?.[0];
    const width = snapped(entry.contentRect.width * ratio, exact?.inlineSize);
    const height = snapped(entry.contentRect.height * ratio, exact?.blockSize);
    if (width < 1 || height < 1) return;
    this.renderer.resize(width, height);
    this.view.resize(width, height, ratio);
    this.sized = true;
    this.redraw();
  }

  restyle() {
    this.theme = readTheme(this.element);
    if (this.table) this.mixColors();
    this.schedule();
  }

  mixColors() {
    this.palettes = palettes(this.table, this.theme);
  }

  hear(message) {
    if (message.kind === "table") {
      this.settle(decodeTable(message));
      this.stats.connected = true;
    } else if (message.kind === "world") {
      this.world.hear(message.view);
      return;
    } else if (message.kind === "lost") {
      this.stats.connected = false;
    }
    this.message.show(message);
    this.onNotice?.(message.kind === "table" ? { kind: "connected" } : message);
  }

  // Another gas is seen whole; after a change to the same one, what was seen stays in sight.
  settle(table) {
    const same = this.table && kin(this.table) === kin(table);
    const room = reach(table);
    this.table = table;
    if (!same) {
      this.frame = this.pointed = null;
      this.trail.forget();
    }
    this.world.settle(table.world);
    table.least = this.world.least;
    this.show(same ? room.map((end, k) => (k < 2 ? Math.min : Math.max)(end, this.view.room[k])) : room);
    this.mixColors();
  }

  show(room) {
    this.view.setRoom(room, this.table.sides.some(({ wall }) => wall.handle));
  }

  schedule() {
    this.ticket ||= requestAnimationFrame(() => this.tick());
  }

  // Once per screen frame at most. The ack goes out even if drawing fails.
  tick() {
    this.ticket = 0;
    const { socket } = this;
    this.stats.received += socket.received - socket.acked;
    try {
      const began = performance.now();
      const fresh = this.takeFrame();
      this.redraw();
      if (fresh && this.sized) {
        socket.drawn++;
        this.stats.drew(this.frame, began);
      }
    } catch (error) {
      this.stats.errors++;
      console.error(error);
    } finally {
      socket.ack();
      if (socket.backlog.spared) this.schedule();
    }
  }

  takeFrame() {
    const message = this.socket.backlog.take();
    if (!message || !this.table) return false;
    const frame = decodeFrame(message);
    if (frame.generation !== this.table.generation) return false;
    this.frame = frame;
    this.trail.add(frame);
    const room = grown(this.view.room, this.table, frame);
    if (room !== this.view.room) this.show(room);
    return true;
  }

  redraw() {
    if (!this.sized) return;
    if (!this.table) {
      this.renderer.blank(this.theme.outside);
      return;
    }
    const scene = this.scene();
    this.renderer.draw(scene);
    drawOverlay(this.renderer.overlay, scene);
    this.world.draw(this.renderer.overlay, scene);
    this.tip.show(scene);
  }

  scene() {
    const { frame, table, view, theme, trail } = this;
    const palette = this.palettes[frame?.coloring ?? 0];
    return { frame, table, view, theme, palette, trail, grabbed: this.handles.seen(frame) };
  }

  picked(px, py) {
    if (this.frame) this.onPick?.(this.rowAt(px, py));
  }

  // Row of the particle at a pixel, or null.
  rowAt(px, py) {
    if (!this.frame) return null;
    const [x, y] = this.view.toBox(px, py);
    return pick(this.frame, this.table, x, y, (SLACK * this.view.ratio) / this.view.scale);
  }

  // What is pointed at stays so, wherever it flies, until the pointer moves on.
  point(row) {
    if (row === this.pointed) return;
    this.pointed = row;
    this.socket.send(encodePoint(row));
  }

  resetView() {
    this.gestures.reset();
  }

  destroy() {
    cancelAnimationFrame(this.ticket);
    this.socket.close();
    this.gestures.destroy();
    this.world.destroy();
    this.sizer.disconnect();
    this.unwatch();
    this.renderer.destroy();
    this.element.replaceChildren();
  }
}
