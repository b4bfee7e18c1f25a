// The WebGL2 renderer for graphics hardware: one quad per disc, drawn by instancing, with a second canvas for lines.

import { BOND_WIDTH, bondsOf, shareOf } from "./bonds.js";
import { Lines } from "./gl_lines.js";
import { Ground } from "./ground.js";
import { Layer } from "./layer.js";
import { KINDS, discsOf, sticksOf } from "./molecules.js";
import { link, texture } from "./gl.js";
import { extent } from "./outline.js";
import { shadesOf } from "./shades.js";

const VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec2 position;
layout(location = 1) in uint species;
layout(location = 2) in uint lit;
layout(location = 3) in uint shade;
uniform vec2 size;      // of the canvas, in pixels
uniform vec2 origin;    // pixel of the box's corner (0, 0), y down
uniform float scale;    // pixels per length
uniform float share;    // of its radius that a disc is drawn with
uniform vec2 box;       // its width and height
uniform ivec2 image;    // which periodic image: -1, 0 or 1 along x and y
uniform bool dimmed;
uniform highp sampler2D radii;
uniform sampler2D palette;   // row 0 strong, row 1 dim
flat out vec4 color;
flat out float radius;
out vec2 place;
void main() {
  radius = texelFetch(radii, ivec2(int(species), 0), 0).r;
  vec2 center = position + vec2(image) * box;
  vec2 shift = vec2(image);
  // An image is drawn only if it reaches into the box.
  bool seen = all(lessThan(-vec2(radius) * abs(shift), (center) * abs(shift) + vec2(1e-30)))
           && all(lessThan((center - box) * abs(shift), vec2(radius) * abs(shift) + vec2(1e-30)));
  radius *= scale * share;
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  place = corner * (radius + 1.0);
  vec2 pixel = vec2(origin.x, origin.y) + vec2(center.x, -center.y) * scale + place;
  vec2 clip = pixel / size * 2.0 - 1.0;
  gl_Position = seen ? vec4(clip.x, -clip.y, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
  color = texelFetch(palette, ivec2(int(shade), dimmed && lit == 0u ? 1 : 0), 0);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
flat in vec4 color;
flat in float radius;
in vec2 place;
out vec4 result;
void main() {
  // The ramp of one pixel adds pi/12 to the area; discs below its width become fainter instead of smaller.
  float ramp = sqrt(max(radius * radius - 1.0 / 12.0, 0.25));
  float alpha = clamp(ramp - length(place) + 0.5, 0.0, 1.0) * min(1.0, 3.0 * radius * radius);
  if (alpha <= 0.0) discard;
  result = vec4(color.rgb * alpha, alpha);
}`;

const ROOM = 2 * KINDS; // of radii and colours

export class GlRenderer {
  constructor(canvas, overlayCanvas) {
    this.name = "gl";
    this.canvas = canvas;
    this.overlayCanvas = overlayCanvas;
    this.overlay = overlayCanvas.getContext("2d");
    this.gl = canvas.getContext("webgl2", { alpha: false, antialias: false, preserveDrawingBuffer: false });
    if (!this.gl) throw new Error("WebGL2 is not available");
    this.capacity = 0;
    this.ground = new Ground();
    this.setUp();
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      this.capacity = 0;
      this.setUp();
    });
  }

  setUp() {
    const { gl } = this;
    this.program = link(gl, VERTEX, FRAGMENT);
    this.layer = new Layer(gl);
    this.lines = new Lines(gl);
    gl.useProgram(this.program);
    this.at = (name) => gl.getUniformLocation(this.program, name);
    gl.uniform1i(this.at("radii"), 0);
    gl.uniform1i(this.at("palette"), 1);
    this.radii = texture(gl, gl.TEXTURE0);
    this.palette = texture(gl, gl.TEXTURE1);
    this.buffers = Array.from({ length: 4 }, () => gl.createBuffer());
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  resize(width, height) {
    for (const canvas of [this.canvas, this.overlayCanvas]) {
      canvas.width = width;
      canvas.height = height;
    }
  }

  draw(scene) {
    const { gl } = this;
    const { width, height } = this.canvas;
    this.overlay.clearRect(0, 0, width, height);
    gl.viewport(0, 0, width, height);
    gl.disable(gl.SCISSOR_TEST);
    clear(gl, scene.theme.outside);
    const [left, bottom, boxWidth, boxHeight] = this.box(scene);
    if (this.ground.update(scene, width, height)) {
      this.layer.draw(this.ground);
      gl.useProgram(this.program);
    } else {
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(left, bottom, boxWidth, boxHeight);
      clear(gl, scene.theme.box);
    }
    if (!scene.frame || scene.frame.count === 0) return;
    const { periodicX, periodicY } = scene.table;
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(
      periodicX ? left : 0,
      periodicY ? bottom : 0,
      periodicX ? boxWidth : width,
      periodicY ? boxHeight : height,
    );
    const lines = bondsOf(scene.frame, scene.table);
    if (lines.length) {
      this.lines.draw(lines, scene, BOND_WIDTH * scene.view.ratio, scene.theme.bond);
      gl.useProgram(this.program);
    }
    const discs = discsOf(scene.frame, scene.table);
    this.upload(scene, discs);
    this.instances(scene, discs.count);
    this.sticks(scene);
  }

  sticks(scene) {
    for (const { lines, width } of sticksOf(scene.frame, scene.table, scene.view)) {
      this.lines.draw(lines, scene, width, scene.theme.stick);
    }
    this.gl.useProgram(this.program);
  }

  // Nothing but one colour.
  blank(color) {
    this.gl.disable(this.gl.SCISSOR_TEST);
    clear(this.gl, color);
  }

  // In pixels from the lower left corner: left, bottom, width, height of the box on the canvas.
  box({ view, table, frame }) {
    const { width, height } = this.canvas;
    const [x0, y0, x1, y1] = extent(table, frame);
    const within = (value, most) => Math.min(Math.max(Math.round(value), 0), most);
    const left = within(view.originX + x0 * view.scale, width);
    const right = within(view.originX + x1 * view.scale, width);
    const top = within(view.originY - y1 * view.scale, height);
    const bottom = within(view.originY - y0 * view.scale, height);
    return [left, height - bottom, right - left, bottom - top];
  }

  upload({ palette, frame, table, view }, discs) {
    const { gl } = this;
    const [position, species, lit, shades] = this.buffers;
    const picks = shadesOf(discs);
    const fresh = discs.count > this.capacity;
    if (fresh) this.capacity = Math.ceil(discs.count * 1.25);
    store(gl, position, discs.position, fresh && this.capacity * 8);
    store(gl, species, discs.species, fresh && this.capacity * 2);
    store(gl, lit, unpacked(discs), fresh && this.capacity);
    store(gl, shades, picks, fresh && this.capacity * 2);
    attribute(gl, 0, position, 2, gl.FLOAT);
    attribute(gl, 1, species, 1, whole(gl, discs.species));
    attribute(gl, 2, lit, 1, gl.UNSIGNED_BYTE);
    attribute(gl, 3, shades, 1, whole(gl, picks));
    const radii = new Float32Array(ROOM);
    const least = (table.least * view.ratio) / (view.scale * shareOf(frame));
    radii.set(discs.radii.map((r) => Math.max(r, least)));
    gl.activeTexture(gl.TEXTURE0);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, ROOM, 1, 0, gl.RED, gl.FLOAT, radii);
    const colors = new Uint8Array(ROOM * 2 * 4).fill(255);
    palette.strong.forEach((color, k) => colors.set(color, 4 * k));
    palette.dim.forEach((color, k) => colors.set(color, 4 * (ROOM + k)));
    gl.activeTexture(gl.TEXTURE1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, ROOM, 2, 0, gl.RGBA, gl.UNSIGNED_BYTE, colors);
  }

  instances({ frame, table, view }, count) {
    const { gl } = this;
    gl.uniform2f(this.at("size"), this.canvas.width, this.canvas.height);
    gl.uniform2f(this.at("origin"), view.originX, view.originY);
    gl.uniform1f(this.at("scale"), view.scale);
    const [left, bottom, right, top] = extent(table, frame);
    gl.uniform1f(this.at("share"), shareOf(frame));
    gl.uniform2f(this.at("box"), right - left, top - bottom);
    gl.uniform1i(this.at("dimmed"), frame.highlight === null ? 0 : 1);
    const along = (periodic) => (periodic ? [-1, 0, 1] : [0]);
    for (const i of along(table.periodicX)) {
      for (const j of along(table.periodicY)) {
        gl.uniform2i(this.at("image"), i, j);
        gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
      }
    }
  }

  destroy() {
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}

// One byte per disc: whether it is highlighted.
function unpacked({ highlight, count }) {
  const lit = new Uint8Array(count);
  if (highlight !== null) for (let i = 0; i < count; i++) lit[i] = (highlight[i >> 3] >> (i & 7)) & 1;
  return lit;
}

function clear(gl, [r, g, b]) {
  gl.clearColor(r / 255, g / 255, b / 255, 1);
  gl.clear(gl.COLOR_BUFFER_BIT);
}

function store(gl, buffer, data, bytes) {
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  if (bytes) gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.STREAM_DRAW);
  gl.bufferSubData(gl.ARRAY_BUFFER, 0, data);
}

function whole(gl, array) {
  return array.BYTES_PER_ELEMENT === 2 ? gl.UNSIGNED_SHORT : gl.UNSIGNED_BYTE;
}

function attribute(gl, index, buffer, size, type) {
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.enableVertexAttribArray(index);
  if (type === gl.FLOAT) gl.vertexAttribPointer(index, size, type, false, 0, 0);
  else gl.vertexAttribIPointer(index, size, type, 0, 0);
  gl.vertexAttribDivisor(index, 1);
}
