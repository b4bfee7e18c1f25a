// The wire format, twin of app/protocol.py, where it is described.
import { readOutline } from "./outline.js";

export const VERSION = 3;
const HIGHLIGHT = 1;
const FOLLOWED = 2;
const PLAYING = 4;
const BONDS = 8;
const HEADER = 68;

// A frame from an ArrayBuffer. The arrays are views into it. Throws if it is no frame of this version.
export function decodeFrame(buffer) {
  const head = new DataView(buffer);
  if (buffer.byteLength < HEADER || head.getUint8(0) !== VERSION) {
    throw new Error(`not a frame of version ${VERSION}`);
  }
  const flags = head.getUint8(1);
  const header = head.getUint16(2, true);
  const count = head.getUint32(12, true);
  const walls = head.getUint32(60, true);
  const start = header + 4 * walls;
  const coloring = head.getUint8(64);
  const tail = start + (coloring ? 10 : 9) * count;
  const bits = flags & HIGHLIGHT ? (count + 7) >> 3 : 0;
  if (buffer.byteLength !== tail + bits) {
    throw new Error(`a frame of ${count} discs has ${tail + bits} bytes, not ${buffer.byteLength}`);
  }
  return {
    generation: head.getUint32(4, true),
    number: head.getUint32(8, true),
    count,
    time: head.getFloat64(16, true),
    width: head.getFloat32(24, true),
    height: head.getFloat32(28, true),
    temperature: head.getFloat32(56, true),
    playing: (flags & PLAYING) !== 0,
    displacement: new Float32Array(buffer, header, walls),
    position: new Float32Array(buffer, start, 2 * count),
    species: new Uint8Array(buffer, start + 8 * count, count),
    coloring,
    shades: coloring ? new Uint8Array(buffer, start + 9 * count, count) : null,
    bonds: (flags & BONDS) !== 0,
    highlight: flags & HIGHLIGHT ? new Uint8Array(buffer, tail, bits) : null,
    followed: flags & FOLLOWED ? followed(head) : null,
  };
}

function followed(head) {
  return {
    row: head.getUint32(32, true),
    id: head.getUint32(36, true),
    x: head.getFloat32(40, true),
    y: head.getFloat32(44, true),
    vx: head.getFloat32(48, true),
    vy: head.getFloat32(52, true),
  };
}

// The table message in the form that drawing needs: typed arrays, one entry per species, and the lines of the walls.
export function decodeTable(message) {
  return {
    generation: message.generation,
    ...readOutline(message),
    names: message.species.map((one) => one.name),
    colors: message.species.map((one) => one.color),
    radii: Float64Array.from(message.species, (one) => one.radius),
    reaches: Float64Array.from(message.species, (one) => one.reach),
  };
}

export function encodeAck(received, drawn) {
  return JSON.stringify({ ack: received, drawn });
}

export function encodeHidden(hidden) {
  return JSON.stringify({ hidden });
}

export function encodeDrag(wall, displacement) {
  return JSON.stringify({ drag: wall, to: displacement });
}

export function encodeDrop(wall) {
  return JSON.stringify({ drop: wall });
}
