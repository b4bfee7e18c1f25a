// Straight lines of some width with round ends by WebGL2: one quad for each, drawn by instancing.
import { link } from "./gl.js";

const VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec4 ends;
uniform vec2 size;      // of the canvas, in pixels
uniform vec2 origin;    // pixel of the box's corner (0, 0), y down
uniform float scale;    // pixels per length
uniform float width;    // in pixels
out vec2 place;       // along the line from its start, and across it
flat out float span;
void main() {
  vec2 from = origin + vec2(ends.x, -ends.y) * scale;
  vec2 to = origin + vec2(ends.z, -ends.w) * scale;
  vec2 along = normalize(to - from + vec2(1e-6, 0.0));
  float reach = 0.5 * width + 0.5;
  span = length(to - from);
  place = vec2((gl_VertexID & 2) == 0 ? -reach : span + reach, (float(gl_VertexID & 1) * 2.0 - 1.0) * reach);
  vec2 pixel = from + along * place.x + vec2(-along.y, along.x) * place.y;
  vec2 clip = pixel / size * 2.0 - 1.0;
  gl_Position = vec4(clip.x, -clip.y, 0.0, 1.0);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec2 place;
flat in float span;
uniform float width;
uniform vec3 color;
out vec4 result;
void main() {
  float away = length(vec2(place.x - clamp(place.x, 0.0, span), place.y)); // round ends
  float alpha = clamp(0.5 * width + 0.5 - away, 0.0, 1.0);
  result = vec4(color * alpha, alpha);
}`;

export class Lines {
  constructor(gl) {
    this.gl = gl;
    this.program = link(gl, VERTEX, FRAGMENT);
    this.buffer = gl.createBuffer();
    this.at = (name) => gl.getUniformLocation(this.program, name);
  }

  // lines: [x, y, x, y] for each, in box coordinates; width in pixels
  draw(lines, { view }, width, color) {
    const { gl } = this;
    gl.useProgram(this.program);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, lines, gl.STREAM_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 4, gl.FLOAT, false, 0, 0);
    gl.vertexAttribDivisor(0, 1);
    gl.uniform2f(this.at("size"), view.width, view.height);
    gl.uniform2f(this.at("origin"), view.originX, view.originY);
    gl.uniform1f(this.at("scale"), view.scale);
    gl.uniform1f(this.at("width"), width);
    gl.uniform3f(this.at("color"), ...color.map((part) => part / 255));
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.length / 4);
  }
}
