// A picture that fills the canvas of WebGL2, pixel by pixel: the ground under the discs.
import { link, texture } from "./gl.js";

const VERTEX = `#version 300 es
void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 4.0 - 1.0;
  gl_Position = vec4(corner, 0.0, 1.0);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
uniform sampler2D picture;
out vec4 result;
void main() {
  ivec2 size = textureSize(picture, 0);
  ivec2 at = ivec2(gl_FragCoord.xy);
  result = texelFetch(picture, ivec2(at.x, size.y - 1 - at.y), 0);
}`;

export class Layer {
  constructor(gl) {
    this.gl = gl;
    this.program = link(gl, VERTEX, FRAGMENT);
    this.picture = texture(gl, gl.TEXTURE2);
    this.version = 0;
    gl.useProgram(this.program);
    gl.uniform1i(gl.getUniformLocation(this.program, "picture"), 2);
  }

  draw(ground) {
    const { gl } = this;
    if (this.version !== ground.version) {
      this.version = ground.version;
      gl.activeTexture(gl.TEXTURE2);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, ground.canvas);
    }
    gl.useProgram(this.program);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
