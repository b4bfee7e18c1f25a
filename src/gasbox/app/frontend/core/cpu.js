// The CPU renderer: anti-aliased discs rasterised into an ImageData. One canvas, so that the page has one layer to compose.
import { BOND_WIDTH, bondsOf, shareOf } from "./bonds.js";
import { blend, pack } from "./color.js";
import { stroke } from "./cpu_lines.js";
import { stick } from "./cpu_sticks.js";
import { Ground } from "./ground.js";
import { discsOf, sticksOf } from "./molecules.js";
import { extent } from "./outline.js";
import { shadesOf } from "./shades.js";
import { PHASES, makeSprites } from "./sprites.js";

const STAMPED = 8; // device pixels; larger discs are filled row by row

export class CpuRenderer {
  constructor(canvas) {
    this.name = "cpu";
    this.canvas = canvas;
    this.context = canvas.getContext("2d", { alpha: false });
    this.overlay = this.context;
    this.stamps = new Map(); // radius in pixels -> sprites
    this.ground = new Ground();
  }

  resize(width, height) {
    this.canvas.width = width;
    this.canvas.height = height;
    this.image = this.context.createImageData(width, height);
    this.pixels = new Uint32Array(this.image.data.buffer);
    this.stamps.clear();
  }

  // scene: frame, table, view, theme, palette { strong, dim: [r, g, b] per species }
  draw(scene) {
    this.clear(scene);
    if (scene.frame) {
      this.bonds(scene);
      this.discs(scene);
      this.sticks(scene);
    }
    this.context.putImageData(this.image, 0, 0);
  }

  // Nothing but one colour.
  blank(color) {
    this.pixels.fill(pack(color));
    this.context.putImageData(this.image, 0, 0);
  }

  // In pixels: the part of the canvas that the box covers, [left, top, right, bottom).
  box({ view, table, frame }) {
    const { width, height } = this.canvas;
    const [left, bottom, right, top] = extent(table, frame);
    const within = (value, most) => Math.min(Math.max(Math.round(value), 0), most);
    return [
      within(view.originX + left * view.scale, width),
      within(view.originY - top * view.scale, height),
      within(view.originX + right * view.scale, width),
      within(view.originY - bottom * view.scale, height),
    ];
  }

  clear(scene) {
    const { width, height } = this.canvas;
    if (this.ground.update(scene, width, height)) {
      this.pixels.set(this.grounded());
      return;
    }
    const [left, top, right, bottom] = this.box(scene);
    const inside = pack(scene.theme.box);
    if (left > 0 || top > 0 || right < width || bottom < height) this.pixels.fill(pack(scene.theme.outside));
    for (let y = top; y < bottom; y++) this.pixels.fill(inside, y * width + left, y * width + right);
  }

  // The ground as pixels, read once for each picture.
  grounded() {
    const { ground } = this;
    if (this.groundVersion !== ground.version) {
      const { width, height } = ground.canvas;
      this.groundPixels = new Uint32Array(ground.context.getImageData(0, 0, width, height).data.buffer);
      this.groundVersion = ground.version;
    }
    return this.groundPixels;
  }

  bonds(scene) {
    const { frame, table, view, theme } = scene;
    this.lines(scene, bondsOf(frame, table), stroke, BOND_WIDTH * view.ratio, theme.bond);
  }

  sticks(scene) {
    for (const { lines, width } of sticksOf(scene.frame, scene.table, scene.view)) {
      this.lines(scene, lines, stick, width, scene.theme.stick);
    }
  }

  // lines: [x, y, x, y] for each, in box coordinates; width in pixels; draw(target, x, y, x, y, width, color)
  lines(scene, lines, draw, width, rgb) {
    if (!lines.length) return;
    const target = this.target(scene);
    const color = pack(rgb);
    const { scale, originX, originY } = scene.view;
    for (let k = 0; k < lines.length; k += 4) {
      const x0 = originX + lines[k] * scale;
      const y0 = originY - lines[k + 1] * scale;
      const x1 = originX + lines[k + 2] * scale;
      const y1 = originY - lines[k + 3] * scale;
      draw(target, x0, y0, x1, y1, width, color);
    }
  }

  discs(scene) {
    const { frame, table, view } = scene;
    const discs = discsOf(frame, table);
    const { position, species, highlight, count } = discs;
    const shades = shadesOf(discs);
    const { scale, originX, originY } = view;
    const kinds = discs.radii.length;
    const target = this.target(scene);
    const strong = Uint32Array.from(scene.palette.strong, pack);
    const dim = Uint32Array.from(scene.palette.dim, pack);
    const share = shareOf(frame) * scale;
    const radii = Float64Array.from(discs.radii, (r) => Math.max(r * share, table.least * view.ratio));
    const sprites = Array.from(radii, (r) => (r > 0 && r <= STAMPED ? this.sprites(r) : null));
    const { periodicX, periodicY } = table;
    const [left, bottom, right, top] = extent(table, frame);
    const spanX = (right - left) * scale;
    const spanY = (top - bottom) * scale;
    const startX = originX + left * scale;
    const startY = originY - bottom * scale;
    for (let i = 0; i < count; i++) {
      const s = species[i];
      if (s >= kinds) continue;
      const r = radii[s];
      const x = originX + position[2 * i] * scale;
      const y = originY - position[2 * i + 1] * scale;
      const color = highlight !== null && !((highlight[i >> 3] >> (i & 7)) & 1) ? dim[shades[i]] : strong[shades[i]];
      paint(target, sprites[s], x, y, r, color);
      if (!periodicX && !periodicY) continue;
      const dx = !periodicX ? 0 : x - startX < r ? spanX : startX + spanX - x < r ? -spanX : 0;
      const dy = !periodicY ? 0 : startY - y < r ? -spanY : y - (startY - spanY) < r ? spanY : 0;
      if (dx) paint(target, sprites[s], x + dx, y, r, color);
      if (dy) paint(target, sprites[s], x, y + dy, r, color);
      if (dx && dy) paint(target, sprites[s], x + dx, y + dy, r, color);
    }
  }

  // Where discs may be painted: the canvas, cut at the periodic sides of the box.
  target(scene) {
    const { width, height } = this.canvas;
    const [left, top, right, bottom] = this.box(scene);
    const { periodicX, periodicY } = scene.table;
    return {
      pixels: this.pixels,
      stride: width,
      left: periodicX ? left : 0,
      right: periodicX ? right : width,
      top: periodicY ? top : 0,
      bottom: periodicY ? bottom : height,
    };
  }

  sprites(r) {
    let sprites = this.stamps.get(r);
    if (!sprites) {
      if (this.stamps.size > 64) this.stamps.clear();
      sprites = makeSprites(r, this.canvas.width);
      this.stamps.set(r, sprites);
    }
    return sprites;
  }

  destroy() {}
}

function paint(target, sprites, x, y, r, color) {
  if (x + r < target.left || x - r > target.right || y + r < target.top || y - r > target.bottom) return;
  if (sprites !== null) stamp(target, sprites, x, y, color);
  else fill(target, x, y, r, color);
}

function stamp(target, sprites, x, y, color) {
  const atX = Math.round(x * PHASES);
  const atY = Math.round(y * PHASES);
  const px = Math.floor(atX / PHASES);
  const py = Math.floor(atY / PHASES);
  const sprite = sprites[(atY - py * PHASES) * PHASES + atX - px * PHASES];
  const { reach, solid, edge, alpha } = sprite;
  if (px - reach < target.left || px + reach >= target.right || py - reach < target.top || py + reach >= target.bottom) {
    stampClipped(target, sprite, px, py, color);
    return;
  }
  const { pixels } = target;
  const at = py * target.stride + px;
  for (let k = 0; k < solid.length; k++) pixels[at + solid[k]] = color;
  for (let k = 0; k < edge.length; k++) {
    const p = at + edge[k];
    pixels[p] = blend(color, pixels[p], alpha[k]);
  }
}

function stampClipped(target, sprite, px, py, color) {
  const { pixels, stride, left, right, top, bottom } = target;
  const [solid, edge] = sprite.cells;
  const inside = (i, j) => i >= left && i < right && j >= top && j < bottom;
  for (const [i, j] of solid) {
    if (inside(px + i, py + j)) pixels[(py + j) * stride + px + i] = color;
  }
  edge.forEach(([i, j], k) => {
    if (!inside(px + i, py + j)) return;
    const p = (py + j) * stride + px + i;
    pixels[p] = blend(color, pixels[p], sprite.alpha[k]);
  });
}

// Row by row: a solid run, and on both sides pixels whose coverage falls from 1 to 0 over one pixel of distance.
function fill(target, x, y, r, color) {
  const { pixels, stride, left, right } = target;
  const inner = r - 0.5;
  const outer = r + 0.5;
  const first = Math.max(target.top, Math.floor(y - outer));
  const last = Math.min(target.bottom - 1, Math.ceil(y + outer));
  for (let j = first; j <= last; j++) {
    const dy = j + 0.5 - y;
    const reach = outer * outer - dy * dy;
    if (reach <= 0) continue;
    const wide = Math.sqrt(reach);
    const core = inner * inner - dy * dy;
    const half = core > 0 ? Math.sqrt(core) : 0;
    const from = Math.max(left, Math.ceil(x - wide - 0.5));
    const to = Math.min(right, Math.floor(x + wide - 0.5) + 1);
    const solidFrom = Math.min(Math.max(from, core > 0 ? Math.ceil(x - half - 0.5) : Math.ceil(x)), to);
    const solidTo = Math.max(Math.min(to, core > 0 ? Math.floor(x + half - 0.5) + 1 : Math.ceil(x)), solidFrom);
    const row = j * stride;
    rim(pixels, row, from, solidFrom, x, dy, outer, color);
    pixels.fill(color, row + solidFrom, row + solidTo);
    rim(pixels, row, solidTo, to, x, dy, outer, color);
  }
}

function rim(pixels, row, from, to, x, dy, outer, color) {
  for (let i = from; i < to; i++) {
    const dx = i + 0.5 - x;
    const share = Math.round(256 * (outer - Math.sqrt(dx * dx + dy * dy)));
    if (share <= 0) continue;
    pixels[row + i] = share >= 256 ? color : blend(color, pixels[row + i], share);
  }
}
