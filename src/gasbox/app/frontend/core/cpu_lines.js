// Straight lines of some width into pixels, anti-aliased along their length: between discs there are many short ones.
import { blend } from "./color.js";

// target: pixels, stride, and the part that may be painted; ends in pixels; width in pixels.
export function stroke(target, x0, y0, x1, y1, width, color) {
  if (Math.abs(x1 - x0) >= Math.abs(y1 - y0)) run(target, x0, y0, x1, y1, width, color, false);
  else run(target, y0, x0, y1, x1, width, color, true);
}

// Step by step along the longer way `a`, with a short run of pixels across it, along `b`; `steep` if `a` is y.
function run(target, a0, b0, a1, b1, width, color, steep) {
  if (a0 > a1) [a0, b0, a1, b1] = [a1, b1, a0, b0];
  const { pixels, stride } = target;
  const slope = a1 > a0 ? (b1 - b0) / (a1 - a0) : 0;
  const half = 0.5 * width * Math.sqrt(1 + slope * slope);
  const [lowA, highA] = steep ? [target.top, target.bottom] : [target.left, target.right];
  const [lowB, highB] = steep ? [target.left, target.right] : [target.top, target.bottom];
  const [stepA, stepB] = steep ? [stride, 1] : [1, stride];
  const last = Math.min(Math.ceil(a1), highA) - 1;
  for (let a = Math.max(Math.floor(a0), lowA); a <= last; a++) {
    const middle = b0 + slope * (a + 0.5 - a0);
    const from = middle - half;
    const to = middle + half;
    const end = Math.min(Math.ceil(to), highB);
    for (let b = Math.max(Math.floor(from), lowB); b < end; b++) {
      const share = Math.round(256 * (Math.min(to, b + 1) - Math.max(from, b)));
      const p = a * stepA + b * stepB;
      pixels[p] = share >= 256 ? color : blend(color, pixels[p], share);
    }
  }
}
