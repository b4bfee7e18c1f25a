// Lines over the discs: walls, ring and trail.
import { shareOf } from "./bonds.js";
import { discsOf, sticksOf } from "./molecules.js";
import { extent } from "./outline.js";
import { shadesOf } from "./shades.js";
import { drawWalls } from "./walls.js";

export function drawOverlay(context, scene) {
  if (!context || !scene.table) return;
  context.save();
  drawWalls(context, scene);
  trail(context, scene);
  ring(context, scene);
  context.restore();
}

function trail(context, { trail, view, theme, table, frame }) {
  const points = trail.points;
  if (points.length < 2) return;
  const [left, bottom, right, top] = extent(table, frame);
  context.strokeStyle = theme.ring;
  context.lineWidth = 1.5 * view.ratio;
  context.lineJoin = "round";
  for (let k = 1; k < points.length; k++) {
    const [x0, y0] = points[k - 1];
    const [x1, y1] = points[k];
    // A jump to the other side of a periodic box is no way.
    if (Math.abs(x1 - x0) > (right - left) / 2 || Math.abs(y1 - y0) > (top - bottom) / 2) continue;
    context.globalAlpha = 0.75 * (k / points.length);
    context.beginPath();
    context.moveTo(view.originX + x0 * view.scale, view.originY - y0 * view.scale);
    context.lineTo(view.originX + x1 * view.scale, view.originY - y1 * view.scale);
    context.stroke();
  }
  context.globalAlpha = 1;
}

// A ring around the followed particle, and its discs once more, over its trail.
function ring(context, { frame, view, theme, table, palette }) {
  if (!frame?.followed) return;
  const { row } = frame.followed;
  const discs = discsOf(frame, table);
  const share = view.scale * shareOf(frame);
  for (const k of discsOfRow(discs, row)) {
    const [x, y] = view.toCanvas(discs.position[2 * k], discs.position[2 * k + 1]);
    context.fillStyle = `rgb(${palette.strong[shadesOf(discs)[k]] ?? [128, 128, 128]})`;
    circle(context, x, y, discs.radii[discs.species[k]] * share);
    context.fill();
  }
  sticks(context, { frame, view, theme, table }, row);
  const [x, y] = view.toCanvas(frame.followed.x, frame.followed.y);
  const reach = (table.radii[frame.species[row]] ?? 0) * (discs.owner ? view.scale : share);
  context.strokeStyle = theme.ring;
  context.lineWidth = 2 * view.ratio;
  circle(context, x, y, reach + 3 * view.ratio);
  context.stroke();
}

function discsOfRow({ owner, count }, row) {
  if (!owner) return [row];
  const mine = [];
  for (let k = 0; k < count; k++) if (owner[k] === row) mine.push(k);
  return mine;
}

function sticks(context, { frame, view, theme, table }, row) {
  const mine = sticksOf(frame, table, view).find(({ kind }) => kind === frame.species[row]);
  if (!mine) return;
  const { position, first } = discsOf(frame, table);
  context.lineCap = "round";
  context.lineWidth = mine.width;
  context.strokeStyle = `rgb(${theme.stick})`;
  context.beginPath();
  for (const pair of table.bodies[mine.kind].sticks) {
    const [from, to] = pair.map((k) => 2 * (first[row] + k));
    context.moveTo(...view.toCanvas(position[from], position[from + 1]));
    context.lineTo(...view.toCanvas(position[to], position[to + 1]));
  }
  context.stroke();
}

function circle(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

// Where the followed disc has been, lately.
export class Trail {
  constructor(most = 180) {
    this.most = most;
    this.points = [];
    this.whose = null;
  }

  // Another gas.
  forget() {
    this.points = [];
    this.whose = null;
  }

  add(frame) {
    const whose = frame.followed ? frame.followed.id : null;
    if (whose !== this.whose || frame.time < this.time) this.points = [];
    this.whose = whose;
    if (!frame.followed || frame.time === this.time) return;
    this.time = frame.time;
    this.points.push([frame.followed.x, frame.followed.y]);
    if (this.points.length > this.most) this.points.shift();
  }
}
