// An epidemic over the people who walk about: rooms, quarantine, central places, rings where somebody was just infected,
// how far an infection reaches, and the day. The view is described in Python (worlds: epidemic).

const RING = 0.6; // days that a ring is seen
const RING_SIZE = [3, 15]; // CSS pixels, when it appears and when it is gone
const STEPS = 5; // shades of rings: those of one shade are drawn in one go
const FEW = 300; // infectious people whose reach is shown; zoomed in, all
const ZOOMED = 1.8;
const LEAST_REACH = 3; // CSS pixels; a smaller circle shows nothing
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
    context.strokeStyle = colorOf("--heat", theme.obstacle);
    context.lineWidth = 1.75 * view.ratio;
    context.setLineDash([6 * view.ratio, 4 * view.ratio]);
    outline(context, view, quarantine);
    context.setLineDash([]);
    const [left, top] = view.toCanvas(quarantine[0], quarantine[3]);
    const width = (quarantine[2] - quarantine[0]) * view.scale;
    label(context, view, theme, "quarantine", left + width / 2, top + 4 * view.ratio, width, -24 * view.ratio);
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

  // In the upper left corner of what is seen.
  facts(context, { view, theme }) {
    const { day, infected, over } = this.view;
    const text = `day ${day.toFixed(1)} · ${infected.toLocaleString("en").replaceAll(",", "\u2009")} infected${over ? " · over" : ""}`;
    label(context, view, theme, text, 8 * view.ratio, 8 * view.ratio, Infinity);
  }
}

function outline(context, view, [left, bottom, right, top]) {
  const [x, y] = view.toCanvas(left, top);
  context.strokeRect(x, y, (right - left) * view.scale, (top - bottom) * view.scale);
}

function circle(context, x, y, radius) {
  context.moveTo(x + radius, y);
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

function colorOf(name, otherwise) {
  return getComputedStyle(document.body).getPropertyValue(name).trim() || otherwise;
}

// Text on a ground of its own, so that it can be read over people. In the middle of so much room; if that is too little,
// higher up. Where the room is endless, from the left.
function label(context, view, theme, text, x, y, room, lift = 0) {
  const size = 12 * view.ratio;
  context.font = `600 ${size}px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif`;
  context.textBaseline = "top";
  const width = context.measureText(text).width + 0.9 * size;
  if (width > room) y += lift;
  const left = room < Infinity ? Math.min(x - width / 2, view.width - width) : x;
  context.globalAlpha = 0.82;
  context.fillStyle = `rgb(${theme.box})`;
  context.beginPath();
  context.roundRect(left, y, width, 1.6 * size, 0.5 * size);
  context.fill();
  context.globalAlpha = 1;
  context.fillStyle = theme.ring;
  context.fillText(text, left + 0.45 * size, y + 0.36 * size);
}
