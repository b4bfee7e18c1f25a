// Words over a gas: their letters, and plates behind them so that they can be read over discs. All sizes in canvas pixels.

const FAMILY = 'system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';
const OPACITY = 0.82;

export function font(size, weight) {
  return `${weight} ${Math.round(size)}px ${FAMILY}`;
}

// In the colour of the box, around its middle.
export function plate(context, theme, x, y, width, height) {
  context.globalAlpha = OPACITY;
  context.fillStyle = `rgb(${theme.box})`;
  context.beginPath();
  context.roundRect(x - width / 2, y - height / 2, width, height, 0.25 * height);
  context.fill();
  context.globalAlpha = 1;
}

// [width, height] of a label.
export function measure(context, text, size, weight = 600) {
  context.font = font(size, weight);
  return [context.measureText(text).width + 0.9 * size, 1.6 * size];
}

// A line of text on a plate of its own, around its middle; upright it is read from below.
export function label(context, theme, text, x, y, { size, weight = 600, color = theme.ring, upright = false }) {
  const [width, height] = measure(context, text, size, weight);
  context.save();
  context.translate(x, y);
  if (upright) context.rotate(-Math.PI / 2);
  plate(context, theme, 0, 0, width, height);
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = color;
  context.fillText(text, 0, 0.05 * size);
  context.restore();
}
