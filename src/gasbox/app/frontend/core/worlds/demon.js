// A demon at its gate: how warm both sides are, whom the gate has just let pass, and how many bits were written. The view is
// described in Python (worlds: demon).
import { extent } from "../outline.js";
import { warmth } from "../walls.js";
import { label } from "./ink.js";

const FLASH = 450; // ms that the gate shows whom it let pass
const TINT = 0.13;
const COLORS = { speed: "heat", species: "accent", direction: "cool" }; // of the theme, for each rule

export class DemonWorld {
  constructor(lab) {
    this.lab = lab;
    this.view = null;
    this.passed = [0, 0]; // from the first side, from the second
    this.until = [0, 0]; // ms, when the flash of each way ends
  }

  hear(view) {
    if (!view?.sides) {
      this.view = null;
      return;
    }
    const passed = view.sides.map((side) => view[`from_${side}`].passed);
    const now = performance.now();
    passed.forEach((count, way) => {
      if (this.view && count > this.passed[way]) this.until[way] = now + FLASH;
    });
    this.passed = passed;
    this.view = view;
  }

  draw(context, scene) {
    if (!this.view) return;
    const { table } = scene;
    const [[x0, y0], [x1, y1]] = this.view.line;
    const halves = this.halves(scene, [x0, y0, x1, y1]);
    if (halves && table.shape === "rectangle") this.tint(context, scene, halves);
    this.gate(context, scene, [x0, y0, x1, y1]);
    this.flashes(context, scene, [x0, y0, x1, y1]);
    if (halves) this.labels(context, scene, halves);
  }

  // [left, bottom, right, top] of both sides of a gate that stands or lies; null of one that slants.
  halves({ table, frame }, [x0, y0, x1, y1]) {
    const [left, bottom, right, top] = extent(table, frame);
    if (x0 === x1) return [[left, bottom, x0, top], [x0, bottom, right, top]];
    if (y0 === y1) return [[left, bottom, right, y0], [left, y0, right, top]];
    return null;
  }

  get mean() {
    const [a, b] = this.view.sides.map((side) => this.view[side]);
    if (!a || !b) return 0;
    return (a.discs * a.temperature + b.discs * b.temperature) / Math.max(a.discs + b.discs, 1);
  }

  tint(context, { view }, halves) {
    halves.forEach(([left, bottom, right, top], k) => {
      const side = this.view[this.view.sides[k]];
      if (!side?.discs) return;
      const ratio = side.temperature / this.mean;
      context.globalAlpha = TINT * Math.min(Math.abs(Math.log2(Math.max(ratio, 1e-3))), 1.5);
      context.fillStyle = `rgb(${warmth(ratio > 1 ? 4 : 0.25, 1)})`;
      const [px, py] = view.toCanvas(left, top);
      context.fillRect(px, py, (right - left) * view.scale, (top - bottom) * view.scale);
    });
    context.globalAlpha = 1;
  }

  // The line of the gate in the colour of its rule: whole where it is shut, and broken while it lets somebody pass.
  gate(context, { view, theme }, [x0, y0, x1, y1]) {
    const { rule } = this.view;
    if (rule === "none") return;
    const open = this.until.some((end) => end > performance.now());
    context.strokeStyle = theme[COLORS[rule]] ?? theme.obstacle;
    context.lineWidth = 4 * view.ratio;
    context.lineCap = "round";
    context.globalAlpha = open ? 0.45 : 0.9;
    context.setLineDash(open ? [2 * view.ratio, 9 * view.ratio] : []);
    context.beginPath();
    context.moveTo(...view.toCanvas(x0, y0));
    context.lineTo(...view.toCanvas(x1, y1));
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
  }

  // An arrow for each way in which somebody was let pass just now; it fades.
  flashes(context, { view, theme }, [x0, y0, x1, y1]) {
    const now = performance.now();
    const upright = Math.abs(y1 - y0) >= Math.abs(x1 - x0);
    const [px, py] = view.toCanvas((x0 + x1) / 2, (y0 + y1) / 2);
    this.until.forEach((end, way) => {
      const share = (end - now) / FLASH;
      if (share <= 0) return;
      const sign = way === 0 ? 1 : -1;
      const [dx, dy] = upright ? [sign, 0] : [0, -sign];
      const size = 13 * view.ratio;
      const off = (way === 0 ? -1.2 : 1.2) * size; // side by side
      const [cx, cy] = upright ? [px, py + off] : [px + off, py];
      context.globalAlpha = Math.min(1, 1.4 * share);
      context.lineCap = context.lineJoin = "round";
      for (const [color, width] of [[`rgb(${theme.box})`, 7], [theme[COLORS[this.view.rule]] ?? theme.ring, 3.5]]) {
        context.strokeStyle = color;
        context.lineWidth = width * view.ratio;
        context.beginPath();
        context.moveTo(cx - 1.4 * size * dx, cy - 1.4 * size * dy);
        context.lineTo(cx + 1.4 * size * dx, cy + 1.4 * size * dy);
        context.moveTo(cx + size * (0.7 * dx - 0.55 * dy), cy + size * (0.7 * dy - 0.55 * dx));
        context.lineTo(cx + 1.4 * size * dx, cy + 1.4 * size * dy);
        context.lineTo(cx + size * (0.7 * dx + 0.55 * dy), cy + size * (0.7 * dy + 0.55 * dx));
        context.stroke();
      }
      this.lab.schedule();
    });
    context.globalAlpha = 1;
  }

  labels(context, scene, halves) {
    const { view, theme } = scene;
    const height = (halves[0][3] - halves[0][1]) * view.scale;
    const size = Math.max(Math.min(0.045 * height, 20 * view.ratio), 11 * view.ratio);
    halves.forEach(([left, , right, top], k) => {
      const side = this.view[this.view.sides[k]];
      if (!side) return;
      const [x, y] = view.toCanvas((left + right) / 2, top);
      const color = side.discs ? legible(warmth((side.temperature / this.mean) ** 3, 1), theme) : theme.ring;
      const shown = side.discs ? `T = ${side.temperature.toPrecision(3)}` : "nobody";
      label(context, theme, shown, x, y + 1.3 * size, { size, weight: 700, color });
    });
    if (!(this.view.rule in COLORS)) return;
    const [middle, bottom] = view.toCanvas(...this.foot(halves));
    const bits = this.view.decisions;
    label(context, theme, `${bits} ${bits === 1 ? "bit" : "bits"}`, middle, bottom - 1.1 * size, { size: 0.9 * size });
  }

  // Below the gate, at the edge of the box.
  foot([[left, bottom, right], [other]]) {
    return [right === other ? right : (left + right) / 2, bottom];
  }
}

// A colour of warmth that can be read on the box: half-way to the ink.
function legible([r, g, b], theme) {
  const dark = theme.box[0] < 128;
  const toward = dark ? 255 : 0;
  return `rgb(${[r, g, b].map((part) => Math.round(part + (dark ? 0.5 : 0.25) * (toward - part)))})`;
}
