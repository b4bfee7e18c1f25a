// The wire format, twin of app/protocol.py, where it is described.
import { readBodies } from "./molecules.js";
import { readOutline } from "./outline.js";

export const VERSION = 4;
const HIGHLIGHT = 1;
const FOLLOWED = 2;
const PLAYING = 4;
const BONDS = 8;
const MOLECULES = 16;
const POINTED = 32;
const HEADER = 100;

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
  const molecules = (flags & MOLECULES) !== 0;
  const soft = head.getUint32(68, true);
  const places = start + (molecules ? 12 : 8) * count;
  const bytes = places + (molecules ? 8 * soft : 0);
  const tail = bytes + (coloring ? 2 : 1) * count;
  const bits = flags & HIGHLIGHT ? (count + 7) >> 3 : 0;
  if (buffer.byteLength !== tail + bits) {
    throw new Error(`a frame of ${count} particles has ${tail + bits} bytes, not ${buffer.byteLength}`);
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
    angle: molecules ? new Float32Array(buffer, start + 8 * count, count) : null,
    places: molecules ? new Float32Array(buffer, places, 2 * soft) : null,
    species: new Uint8Array(buffer, bytes, count),
    coloring,
    shades: coloring ? new Uint8Array(buffer, bytes + count, count) : null,
    bonds: (flags & BONDS) !== 0,
    highlight: flags & HIGHLIGHT ? new Uint8Array(buffer, tail, bits) : null,
    followed: flags & FOLLOWED ? followed(head) : null,
    pointed: flags & POINTED ? pointed(head) : null,
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

// Numbers that a particle does not have are NaN.
function pointed(head) {
  return {
    row: head.getUint32(72, true),
    id: head.getUint32(76, true),
    speed: head.getFloat32(80, true),
    angularVelocity: head.getFloat32(84, true),
    translational: head.getFloat32(88, true),
    rotational: head.getFloat32(92, true),
    vibrational: head.getFloat32(96, true),
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
    ...readBodies(message),
    world: message.world ?? null,
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

export function encodePoint(row) {
  return JSON.stringify({ point: row });
}

// A setting of the world.
export function encodeSetting(name, value) {
  return JSON.stringify({ set: [name, value] });
}

export function encodeDrop(wall) {
  return JSON.stringify({ drop: wall });
}
