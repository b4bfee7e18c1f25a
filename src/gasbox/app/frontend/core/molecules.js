// The discs to draw: one for each particle, or in a gas with molecules their atoms, turned as the molecules are; and the
// sticks between these. All found once for each frame.
//
// An atom of a molecule is drawn as a pale disc of its full size, and over it a small one in its colour: so the shape that
// collides is seen, and which atom is where.
import { extent } from "./outline.js";

export const KINDS = 256; // room for kinds of disc; beyond it, the same kinds drawn small (radii) or pale (colours)
const CORE = 0.45; // of the radius of an atom

// What is drawn of a frame: { count, position, species, shades, highlight } like the frame itself, with the radii that
// `species` picks, and `owner`, the row of the particle that each disc belongs to (null: its own). With molecules, `first`
// says where the atoms of each row begin.
export function discsOf(frame, table) {
  frame.discs ??= table.bodies && frame.angle ? atoms(frame, table) : plain(frame, table);
  return frame.discs;
}

function plain({ count, position, species, shades, highlight }, { radii }) {
  return { count, position, species, shades, highlight, radii, owner: null };
}

function atoms(frame, table) {
  const { bodies } = table;
  const { count, species } = frame;
  const first = new Uint32Array(count + 1);
  let cores = 0;
  for (let i = 0; i < count; i++) {
    const length = bodies[species[i]]?.discs.length ?? 0;
    first[i + 1] = first[i] + length;
    if (length > 1) cores += length;
  }
  const total = first[count] + cores;
  const found = {
    count: total,
    position: new Float32Array(2 * total),
    species: new Uint16Array(total),
    shades: new Uint16Array(total),
    highlight: frame.highlight && new Uint8Array((total + 7) >> 3),
    radii: table.discs.radii,
    owner: new Uint32Array(total),
    first,
  };
  place(found, frame, bodies);
  dress(found, frame, bodies);
  return found;
}

// Rigid molecules are turned as a whole; of flexible ones the frame has the places.
function place({ position, first }, frame, bodies) {
  let soft = 0;
  for (let i = 0; i < frame.count; i++) {
    const body = bodies[frame.species[i]];
    if (!body) continue;
    const { place, flexible } = body;
    const c = Math.cos(frame.angle[i]);
    const s = Math.sin(frame.angle[i]);
    for (let k = first[i], n = 0; k < first[i + 1]; k++, n += 2) {
      if (flexible) {
        position[2 * k] = frame.places[soft++];
        position[2 * k + 1] = frame.places[soft++];
      } else {
        position[2 * k] = frame.position[2 * i] + c * place[n] - s * place[n + 1];
        position[2 * k + 1] = frame.position[2 * i + 1] + s * place[n] + c * place[n + 1];
      }
    }
  }
}

function dress({ position, species, shades, highlight, owner, first }, frame, bodies) {
  let core = first[frame.count];
  for (let i = 0; i < frame.count; i++) {
    const lit = frame.highlight && (frame.highlight[i >> 3] >> (i & 7)) & 1;
    const discs = bodies[frame.species[i]]?.discs;
    const one = first[i + 1] - first[i] === 1;
    const put = (k, disc, small, pale) => {
      owner[k] = i;
      species[k] = disc + small;
      shades[k] = (frame.shades ? frame.shades[i] : disc) + pale;
      if (lit) highlight[k >> 3] |= 1 << (k & 7);
    };
    for (let k = first[i]; k < first[i + 1]; k++) {
      const disc = discs[k - first[i]];
      put(k, disc, 0, one ? 0 : KINDS);
      if (one) continue;
      position[2 * core] = position[2 * k];
      position[2 * core + 1] = position[2 * k + 1];
      put(core++, disc, KINDS, 0);
    }
  }
}

const SHARE = 0.22; // width of a stick, of the radius of the smallest atom of its molecule
const THIN = 1; // CSS pixels; below this there is nothing to see

// The sticks between atoms, [{ lines, width }] for each kind of molecule: ends in box coordinates [x, y, x, y], and the
// width in pixels. None where they would be too thin to see.
export function sticksOf(frame, table, { scale, ratio }) {
  if (!table.bodies || !frame.angle) return [];
  frame.sticks ??= table.bodies.map((body, kind) => (body.sticks.length ? sticks(frame, table, kind) : null));
  return table.bodies.flatMap(({ thinnest }, kind) => {
    const width = SHARE * thinnest * scale;
    return frame.sticks[kind]?.length && width >= THIN * ratio ? [{ lines: frame.sticks[kind], width, kind }] : [];
  });
}

function sticks(frame, table, kind) {
  const { position, first } = discsOf(frame, table);
  const lines = [];
  const images = imagesOf(frame, table);
  for (let i = 0; i < frame.count; i++) {
    if (frame.species[i] !== kind) continue;
    for (const [dx, dy] of images(i)) {
      for (const [a, b] of table.bodies[kind].sticks) {
        const p = 2 * (first[i] + a);
        const q = 2 * (first[i] + b);
        lines.push(position[p] + dx, position[p + 1] + dy, position[q] + dx, position[q + 1] + dy);
      }
    }
  }
  return Float32Array.from(lines);
}

const HERE = [[0, 0]];

// For each row the shifts at which the particle is seen: more than one near a periodic side.
function imagesOf(frame, table) {
  const { periodicX, periodicY, radii } = table;
  if (!periodicX && !periodicY) return () => HERE;
  const [left, bottom, right, top] = extent(table, frame);
  const shift = (x, low, high, reach, periodic) =>
    !periodic ? 0 : x - low < reach ? high - low : high - x < reach ? low - high : 0;
  return (i) => {
    const reach = radii[frame.species[i]];
    const dx = shift(frame.position[2 * i], left, right, reach, periodicX);
    const dy = shift(frame.position[2 * i + 1], bottom, top, reach, periodicY);
    if (!dx && !dy) return HERE;
    return [[0, 0], ...(dx ? [[dx, 0]] : []), ...(dy ? [[0, dy]] : []), ...(dx && dy ? [[dx, dy]] : [])];
  };
}

// The part of the table message that is about molecules, in the form that drawing needs.
export function readBodies({ discs, bodies }) {
  if (!bodies) return { discs: null, bodies: null };
  const radii = new Float64Array(2 * KINDS);
  discs.forEach(({ radius }, kind) => {
    radii[kind] = radius;
    radii[KINDS + kind] = CORE * radius;
  });
  return {
    discs: { radii, colors: discs.map((one) => one.color) },
    bodies: bodies.map((body) => ({
      ...body,
      place: Float64Array.from(body.place.flat()),
      thinnest: Math.min(...body.discs.map((disc) => discs[disc].radius)),
    })),
  };
}
