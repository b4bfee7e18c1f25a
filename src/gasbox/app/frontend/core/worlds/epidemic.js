// An epidemic over the people who walk about: rooms, quarantine, central places, rings where somebody was just infected,
// how far an infection reaches, and the day. The view is described in Python (worlds: epidemic).
import { extent } from "../outline.js";
import { label, measure } from "./ink.js";

const RING = 0.6; // days that a ring is seen
const RING_SIZE = [3, 15]; // CSS pixels, when it appears and when it is gone
const STEPS = 5; // shades of rings: those of one shade are drawn in one go
const FEW = 300; // infectious people whose reach is shown; zoomed in, all
const ZOOMED = 1.8;
const LEAST_REACH = 3; // CSS pixels; a smaller circle shows nothing
const SIZE = 12; // CSS pixels, of letters
const EDGE = 8; // CSS pixels from the edge of what is seen to words
const MARK = 36; // CSS pixels, in the upper corner: the letter of a run
const SPREADING = ["infectious", "asymptomatic"];

export class EpidemicWorld {
  static LEAST = 1.2; // of thousands of people each is a point

  constructor(lab) {
    this.lab = lab;
    this.view = null;
  }

  hear(view) {
    this.view = view.rooms ? view : null;
  }

  draw(context, scene) {
    if (!this.view) return;
    this.rooms(context, scene);
    this.reaches(context, scene);
    this.rings(context, scene);
    this.facts(context, scene);
  }

  rooms(context, { view, theme }) {
    const { rooms, central, quarantine } = this.view;
    context.lineWidth = 1.25 * view.ratio;
    context.strokeStyle = theme.obstacle;
    if (rooms.length > 1 || quarantine) for (const room of rooms) outline(context, view, room);
    context.setLineDash([2 * view.ratio, 3 * view.ratio]);
    for (const place of central ?? []) outline(context, view, place);
    if (!quarantine) return context.setLineDash([]);
    context.strokeStyle = theme.heat;
    context.lineWidth = 1.75 * view.ratio;
    context.setLineDash([6 * view.ratio, 4 * view.ratio]);
    outline(context, view, quarantine);
    context.setLineDash([]);
    this.name(context, view, theme, quarantine);
  }

  // In its room; where that is too narrow, upright over it, or under it if a mark in the corner leaves no room there.
  name(context, view, theme, [left, bottom, right, top]) {
    const size = SIZE * view.ratio;
    const [width, height] = measure(context, "quarantine", size);
    const [x, y] = view.toCanvas((left + right) / 2, top);
    const near = 4 * view.ratio;
    if (width <= (right - left) * view.scale) return label(context, theme, "quarantine", x, y + near + height / 2, { size });
    const [, under] = view.toCanvas(left, bottom);
    const over = y >= width + near + MARK * view.ratio || view.height - under < width + near;
    const middle = over ? y - near - width / 2 : under + near + width / 2;
    label(context, theme, "quarantine", x, middle, { size, upright: true });
  }

  // How far an infection reaches, faintly.
  reaches(context, { view, frame, table }) {
    const { radius, counts } = this.view;
    if (!frame || !radius || radius * view.scale < LEAST_REACH * view.ratio) return;
    const ill = SPREADING.reduce((sum, name) => sum + (counts[name] ?? 0), 0);
    if (ill > FEW && view.zoom < ZOOMED) return;
    for (const name of SPREADING) {
      const kind = table.names.indexOf(name);
      if (kind < 0 || !counts[name]) continue;
      context.beginPath();
      for (let i = 0; i < frame.count; i++) {
        if (frame.species[i] !== kind) continue;
        const [x, y] = view.toCanvas(frame.position[2 * i], frame.position[2 * i + 1]);
        circle(context, x, y, radius * view.scale);
      }
      context.fillStyle = context.strokeStyle = table.colors[kind];
      context.globalAlpha = 0.08;
      context.fill();
      context.globalAlpha = 0.3;
      context.lineWidth = view.ratio;
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  rings(context, { view, table }) {
    const { rings } = this.view;
    if (!rings?.length) return;
    const kind = table.names.indexOf("infectious");
    context.strokeStyle = kind < 0 ? "#d1495b" : table.colors[kind];
    context.lineWidth = 1.75 * view.ratio;
    const [least, most] = RING_SIZE;
    for (let step = 0; step < STEPS; step++) {
      context.globalAlpha = 0.95 * (1 - (step + 0.5) / STEPS);
      context.beginPath();
      for (const [bx, by, age] of rings) {
        const share = age / RING;
        if (share < step / STEPS || share >= (step + 1) / STEPS) continue;
        const [x, y] = view.toCanvas(bx, by);
        circle(context, x, y, (least + (most - least) * share) * view.ratio);
      }
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  // Upper left: beside the box, one below the other; where there is no room, over it; else in it.
  facts(context, { view, theme, table, frame }) {
    const { day, infected, people, over } = this.view;
    const [size, edge] = [SIZE * view.ratio, EDGE * view.ratio];
    const said = [`day ${day.toFixed(1)}`, `${whole(infected)} infected`, ...(over ? ["over"] : [])];
    const [left, , , top] = extent(table, frame);
    const [x0, y0] = view.toCanvas(left, top);
    const [widest, height] = measure(context, `${whole(people)} infected`, size);
    const beside = x0 >= widest + 1.5 * edge;
    const inside = !beside && y0 < height + edge;
    const x = beside ? edge : Math.max(edge, x0 + (inside ? edge / 2 : 0));
    const y = inside ? Math.max(edge, y0 + edge / 2) : edge;
    (beside ? said : [said.join(" · ")]).forEach((text, row) => {
      const [width] = measure(context, text, size);
      label(context, theme, text, x + width / 2, y + (row + 0.5) * height, { size });
    });
  }
}

function outline(context, view, [left, bottom, right, top]) {
  const [x, y] = view.toCanvas(left, top);
  context.strokeRect(x, y, (right - left) * view.scale, (top - bottom) * view.scale);
}

function whole(number) {
  return number.toLocaleString("en").replaceAll(",", "\u2009");
}

function circle(context, x, y, radius) {
  context.moveTo(x + radius, y);
  context.arc(x, y, radius, 0, 2 * Math.PI);
}
