// Walls as lines over the discs: plain, thermal (coloured by temperature), open (dashed), passed by some (dotted), moving
// (thick, with a handle), taken away (faint).
import { mix } from "./color.js";
import { blockPath, containerPath, isPlain } from "./ground.js";
import { displacementOf, ends, extent } from "./outline.js";

const COLD = [38, 116, 222];
const EVEN = [156, 90, 176];
const HOT = [222, 62, 38];
const SPAN = 2; // a wall four times as hot (or cold) as the gas has the full colour
const GRIP = [10, 30]; // CSS pixels, across and along its wall

export function drawWalls(context, scene) {
  const { table } = scene;
  if (table.shape === "rectangle") box(context, scene);
  else for (const side of table.sides) if (!isPlain(side.wall)) line(context, scene, side);
  for (const one of table.lines) line(context, scene, one);
  for (const block of table.blocks) if (!isPlain(block.wall)) edge(context, scene, block);
  for (const bat of table.bats) disc(context, scene, bat);
  for (const grip of grips(scene)) handle(context, scene, grip);
  arrow(context, scene);
  context.setLineDash([]);
  context.globalAlpha = 1;
}

// From the temperature of a wall and that of the gas: blue, violet, red.
export function warmth(temperature, gas) {
  if (!(gas > 0)) return HOT;
  const ratio = temperature > 0 ? Math.log2(temperature / gas) / SPAN : -1;
  const share = Math.min(Math.max(ratio, -1), 1);
  return share < 0 ? mix(EVEN, COLD, -share) : mix(EVEN, HOT, share);
}

// Sets how the line of a wall is stroked and returns its width in device pixels.
function pen(context, { wall, out }, { view, theme, frame }) {
  const thermal = wall.temperature !== null;
  const css = wall.motion !== null ? 4 : thermal ? 3.5 : out ? 1.5 : 2.25;
  const width = Math.max(1, Math.round((wall.present ? css : 1) * view.ratio));
  const quiet = out && wall.motion === null && wall.line === "solid";
  context.strokeStyle = thermal
    ? `rgb(${warmth(wall.temperature, frame?.temperature)})`
    : quiet
      ? theme.wall
      : theme.obstacle;
  context.globalAlpha = wall.present ? 1 : 0.45;
  context.lineWidth = width;
  context.lineCap = wall.line === "dotted" && wall.present ? "round" : wall.line === "solid" && out ? "square" : "butt";
  context.setLineDash(dashes(wall, width, view.ratio));
  return width;
}

function dashes(wall, width, ratio) {
  if (!wall.present) return [3 * ratio, 5 * ratio];
  if (wall.line === "dashed") return [9 * ratio, 6 * ratio];
  if (wall.line === "dotted") return [0.01, 2.4 * width];
  return [];
}

// The sides of a rectangle, on whole pixels, so that they are crisp. Dashed where it is periodic.
function box(context, scene) {
  const { table, view, frame, theme } = scene;
  const [left, bottom, right, top] = extent(table, frame);
  const [x0, y0] = view.toCanvas(left, bottom).map(Math.round);
  const [x1, y1] = view.toCanvas(right, top).map(Math.round);
  const thin = Math.max(1, Math.round(1.5 * view.ratio));
  for (const side of table.sides) {
    const [ox, oy] = side.out;
    let width = pen(context, side, scene);
    if (ox ? table.periodicX : table.periodicY) {
      width = context.lineWidth = thin;
      context.strokeStyle = theme.wall;
      context.setLineDash([4 * thin, 4 * thin]);
    }
    const half = width / 2; // outside, so that touching discs are whole
    const x = ox < 0 ? x0 - half : x1 + half;
    const y = oy < 0 ? y0 + half : y1 - half;
    context.beginPath();
    context.moveTo(ox ? x : x0 - thin / 2, ox ? y1 - thin / 2 : y);
    context.lineTo(ox ? x : x1 + thin / 2, ox ? y0 + thin / 2 : y);
    context.stroke();
  }
}

function line(context, scene, one) {
  const { view, table, frame } = scene;
  const width = pen(context, one, scene);
  context.beginPath();
  if (one.from) {
    const [x0, y0, x1, y1] = ends(one, table, frame);
    const [a, b] = view.toCanvas(x0, y0);
    const [c, d] = view.toCanvas(x1, y1);
    const [ox, oy] = one.out ? [(one.out[0] * width) / 2, (-one.out[1] * width) / 2] : [0, 0];
    context.moveTo(a + ox, b + oy);
    context.lineTo(c + ox, d + oy);
    way(context, scene, one, [a, b, c, d]);
  } else {
    const [x, y] = view.toCanvas(...one.center);
    context.arc(x, y, one.radius * view.scale + width / 2, 0, 2 * Math.PI);
  }
  context.stroke();
}

// A chevron in the middle of a line that is passed one way only.
function way(context, { view }, { wall, from, to }, [a, b, c, d]) {
  if (!wall.way || !wall.present) return;
  const length = Math.sqrt((to[0] - from[0]) ** 2 + (to[1] - from[1]) ** 2);
  const sign = wall.way === "forward" ? 1 : -1;
  // The normal points to the right of the way from start to end; in pixels y points down.
  const nx = (sign * (to[1] - from[1])) / length;
  const ny = (sign * (to[0] - from[0])) / length;
  const size = 6 * view.ratio;
  const [x, y] = [(a + c) / 2 + 1.6 * size * nx, (b + d) / 2 + 1.6 * size * ny];
  context.save();
  context.setLineDash([]);
  context.lineWidth = 2 * view.ratio;
  context.beginPath();
  context.moveTo(x - size * (nx - ny), y - size * (ny + nx));
  context.lineTo(x, y);
  context.lineTo(x - size * (nx + ny), y - size * (ny - nx));
  context.stroke();
  context.restore();
  context.beginPath();
  context.moveTo(a, b);
  context.lineTo(c, d);
}

function edge(context, scene, block) {
  pen(context, { wall: block.wall, out: null }, scene);
  context.save();
  context.beginPath();
  blockPath(context, block, scene.view);
  context.clip();
  context.lineWidth *= 2;
  context.stroke();
  context.restore();
}

// A disc that moves, where it is now, as far as it is in the container.
function disc(context, scene, bat) {
  if (!bat.wall.present) return;
  const { view, frame, theme } = scene;
  const away = displacementOf(bat.wall, frame);
  const [x, y] = view.toCanvas(...bat.center.map((place, k) => place + away * bat.wall.normal[k]));
  context.save();
  context.beginPath();
  containerPath(context, scene);
  context.clip();
  context.setLineDash([]);
  context.globalAlpha = bat.wall.line === "dotted" ? 0.25 : 1;
  context.beginPath();
  context.arc(x, y, bat.radius * view.scale, 0, 2 * Math.PI);
  context.fillStyle = theme.obstacle;
  context.fill();
  context.restore();
}

// Where handles of walls are: { wall, x, y, across: unit vector of the normal in pixels, from, to } in pixels.
export function grips({ table, view, frame }) {
  return [...table.sides, ...table.lines]
    .filter(({ wall, from }) => wall.handle && from)
    .map((one) => {
      const [x0, y0, x1, y1] = ends(one, table, frame);
      const from = view.toCanvas(x0, y0);
      const to = view.toCanvas(x1, y1);
      const out = one.out ? 4 * view.ratio : 0;
      const x = middle(from[0], to[0], view.width) + (one.out ? one.out[0] * out : 0);
      const y = middle(from[1], to[1], view.height) - (one.out ? one.out[1] * out : 0);
      return { wall: one.wall, x, y, across: [one.wall.normal[0], -one.wall.normal[1]], from, to };
    });
}

// The middle of the part that is seen.
function middle(a, b, most) {
  const low = Math.max(Math.min(a, b), 0);
  const high = Math.min(Math.max(a, b), most);
  return low <= high ? (low + high) / 2 : (a + b) / 2;
}

function handle(context, { view, theme, grabbed }, { wall, x, y, across }) {
  const [thick, long] = GRIP.map((size) => size * view.ratio);
  const held = grabbed?.wall === wall.index;
  context.save();
  context.globalAlpha = 1;
  context.lineCap = "butt";
  context.translate(x, y);
  context.rotate(Math.atan2(across[1], across[0]));
  context.setLineDash([]);
  context.beginPath();
  context.roundRect(-thick / 2, -long / 2, thick, long, thick / 2);
  context.fillStyle = held ? theme.obstacle : `rgb(${theme.box})`;
  context.fill();
  context.strokeStyle = theme.obstacle;
  context.lineWidth = 1.5 * view.ratio;
  context.stroke();
  context.strokeStyle = held ? `rgb(${theme.box})` : theme.obstacle;
  context.beginPath();
  for (const at of [-1.5, 1.5]) {
    context.moveTo(at * view.ratio, -long / 5);
    context.lineTo(at * view.ratio, long / 5);
  }
  context.stroke();
  if (held) ghost(context, view, theme, grabbed, long);
  context.restore();
}

// Where a wall is being dragged to: it follows with bounded speed.
function ghost(context, view, theme, { target, now }, long) {
  const away = (target - now) * view.scale;
  if (Math.abs(away) < 3 * view.ratio) return;
  context.globalAlpha = 0.6;
  context.strokeStyle = theme.obstacle;
  context.setLineDash([3 * view.ratio, 3 * view.ratio]);
  context.beginPath();
  context.moveTo(0, 0);
  context.lineTo(away, 0);
  context.moveTo(away, -long);
  context.lineTo(away, long);
  context.stroke();
}

// Which way is down, in a corner of the box.
function arrow(context, { table, view, theme }) {
  const [gx, gy] = table.gravity;
  const strength = Math.sqrt(gx * gx + gy * gy);
  if (!strength) return;
  const size = 11 * view.ratio;
  const [x, y] = [view.width - 2.2 * size, 2.2 * size];
  const [dx, dy] = [(gx / strength) * size, (-gy / strength) * size];
  context.setLineDash([]);
  context.globalAlpha = 0.85;
  context.lineWidth = 2 * view.ratio;
  context.lineCap = context.lineJoin = "round";
  context.strokeStyle = theme.obstacle;
  context.beginPath();
  context.moveTo(x - dx, y - dy);
  context.lineTo(x + dx, y + dy);
  context.moveTo(x + dx - 0.6 * (dx - dy), y + dy - 0.6 * (dy + dx));
  context.lineTo(x + dx, y + dy);
  context.lineTo(x + dx - 0.6 * (dx + dy), y + dy - 0.6 * (dy - dx));
  context.stroke();
  context.globalAlpha = 1;
}
