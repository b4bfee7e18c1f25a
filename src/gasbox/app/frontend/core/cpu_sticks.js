// Sticks with round ends into pixels, anti-aliased all around.
import { blend } from "./color.js";

// target: pixels, stride, and the part that may be painted; ends in pixels; width in pixels.
export function stick(target, x0, y0, x1, y1, width, color) {
  const { pixels, stride } = target;
  const outer = 0.5 * width + 0.5;
  const left = Math.max(Math.floor(Math.min(x0, x1) - outer), target.left);
  const right = Math.min(Math.ceil(Math.max(x0, x1) + outer), target.right);
  const top = Math.max(Math.floor(Math.min(y0, y1) - outer), target.top);
  const bottom = Math.min(Math.ceil(Math.max(y0, y1) + outer), target.bottom);
  const [dx, dy] = [x1 - x0, y1 - y0];
  const square = dx * dx + dy * dy || 1;
  for (let j = top; j < bottom; j++) {
    const y = j + 0.5 - y0;
    for (let i = left; i < right; i++) {
      const x = i + 0.5 - x0;
      const along = Math.min(Math.max((x * dx + y * dy) / square, 0), 1);
      const share = Math.round(256 * (outer - Math.sqrt((x - along * dx) ** 2 + (y - along * dy) ** 2)));
      if (share <= 0) continue;
      const p = j * stride + i;
      pixels[p] = share >= 256 ? color : blend(color, pixels[p], share);
    }
  }
}
