// Colours as [r, g, b] from 0 to 255, as packed pixels of an ImageData, and mixed.

const ink = document.createElement("canvas").getContext("2d", { willReadFrequently: true });

// Any CSS colour; what is no colour becomes `fallback`.
export function parse(text, fallback = [128, 128, 128]) {
  if (!text || !CSS.supports("color", text)) return fallback;
  ink.clearRect(0, 0, 1, 1);
  ink.fillStyle = text;
  ink.fillRect(0, 0, 1, 1);
  return Array.from(ink.getImageData(0, 0, 1, 1).data.subarray(0, 3));
}

export function mix(a, b, share) {
  return a.map((value, k) => Math.round(value * (1 - share) + b[k] * share));
}

// An opaque pixel; ImageData is little endian on every machine that runs a browser.
export function pack([r, g, b]) {
  return ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;
}

// `share` of 256 of one pixel over another; both are opaque.
export function blend(over, under, share) {
  const rest = 256 - share;
  const redBlue = ((Math.imul(over & 0xff00ff, share) + Math.imul(under & 0xff00ff, rest)) >>> 8) & 0xff00ff;
  const green = ((Math.imul(over & 0xff00, share) + Math.imul(under & 0xff00, rest)) >>> 8) & 0xff00;
  return 0xff000000 | redBlue | green;
}
