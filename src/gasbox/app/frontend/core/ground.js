// What lies under the discs, as a picture that is made once and again only when it changes: the outside of containers that
// are no rectangles with their plain sides, and obstacles with an inside. A bare rectangle needs none.
import { extent } from "./outline.js";

export class Ground {
  constructor() {
    this.canvas = document.createElement("canvas");
    this.context = this.canvas.getContext("2d", { willReadFrequently: true });
    this.key = [];
    this.version = 0; // increases with each new picture
  }

  // Whether the scene needs a ground; if so, the canvas holds it afterwards.
  update(scene, width, height) {
    const { table, view, frame, theme } = scene;
    if (table.shape === "rectangle" && !table.blocks.length) return false;
    const { scale, originX, originY } = view;
    const key = [table, theme, width, height, scale, originX, originY, ...extent(table, frame)];
    if (key.length === this.key.length && key.every((part, k) => part === this.key[k])) return true;
    this.key = key;
    this.version++;
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.paint(scene);
    return true;
  }

  paint(scene) {
    const { context, canvas } = this;
    const { theme, table } = scene;
    context.fillStyle = `rgb(${theme.outside})`;
    context.fillRect(0, 0, canvas.width, canvas.height);
    plainSides(context, scene);
    context.fillStyle = `rgb(${theme.box})`;
    context.beginPath();
    containerPath(context, scene);
    context.fill();
    for (const block of table.blocks) if (block.wall.present) stone(context, block, scene);
  }
}

export function containerPath(context, { table, view, frame }) {
  if (table.shape === "circle") {
    const [x, y] = view.toCanvas(table.radius, table.radius);
    context.arc(x, y, table.radius * view.scale, 0, 2 * Math.PI);
  } else if (table.shape === "polygon") {
    polygon(context, view, table.vertices);
  } else {
    const [left, bottom, right, top] = extent(table, frame);
    const [x, y] = view.toCanvas(left, top);
    context.rect(x, y, (right - left) * view.scale, (top - bottom) * view.scale);
  }
}

export function blockPath(context, block, view) {
  if (block.shape === "polygon") {
    polygon(context, view, block.vertices);
  } else {
    const [x, y] = view.toCanvas(...block.center);
    context.arc(x, y, block.radius * view.scale, 0, 2 * Math.PI);
  }
}

function polygon(context, view, vertices) {
  for (const [x, y] of vertices) context.lineTo(...view.toCanvas(x, y));
  context.closePath();
}

// Sides with nothing special about them, twice as wide as they are: the inside covers half, so that touching discs are whole.
function plainSides(context, { table, view, theme }) {
  if (table.shape === "rectangle") return;
  context.strokeStyle = theme.wall;
  context.lineWidth = 2 * Math.max(1, Math.round(1.5 * view.ratio));
  context.lineJoin = "round";
  context.lineCap = "round";
  context.beginPath();
  for (const side of table.sides) {
    if (!isPlain(side.wall)) continue;
    if (side.from) {
      context.moveTo(...view.toCanvas(...side.from));
      context.lineTo(...view.toCanvas(...side.to));
    } else {
      const [x, y] = view.toCanvas(...side.center);
      context.arc(x, y, side.radius * view.scale, 0, 2 * Math.PI);
    }
  }
  context.stroke();
}

// Filled, with an edge that lies within it. One that lets somebody pass can be seen through.
function stone(context, block, { view, theme }) {
  context.save();
  context.beginPath();
  blockPath(context, block, view);
  context.clip();
  context.globalAlpha = block.wall.line === "dotted" ? 0.25 : 1;
  context.fillStyle = `rgb(${theme.stone})`;
  context.fill();
  context.globalAlpha = 1;
  if (isPlain(block.wall)) {
    context.strokeStyle = theme.obstacle;
    context.lineWidth = 2 * Math.max(1, Math.round(1.25 * view.ratio));
    context.stroke();
  }
  context.restore();
}

export function isPlain(wall) {
  return wall.line === "solid" && wall.temperature === null && wall.motion === null && wall.present;
}
