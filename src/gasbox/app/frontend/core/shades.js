// Colours of discs: those of their species, or shades that say their phase, number of neighbours or speed.
import { mix, parse } from "./color.js";
import { KINDS } from "./molecules.js";

const PALE = 0.55; // share of the background in the full size of the atoms of molecules
const DIMMED = 0.8; // share of the background in discs that are not highlighted
const PHASES = ["gas", "liquid", "solid"];
const NEIGHBOURS = 8;
const LEVELS = 256;

// One palette { strong, dim: [r, g, b] each } for each way of colouring, in the order of their numbers on the wire.
export function palettes(table, theme) {
  const all = [
    (table.discs ?? table).colors.map((color) => parse(color)),
    PHASES.map((name) => theme.shade(name)),
    Array.from({ length: NEIGHBOURS }, (_, k) => theme.shade(`neighbours-${k}`)),
    ramp(theme.shade("slow"), theme.shade("medium"), theme.shade("fast")),
  ];
  return all.map((plain) => {
    const strong = table.bodies ? withPale(plain, theme) : plain;
    return { strong, dim: strong.map((color) => mix(color, theme.box, DIMMED)) };
  });
}

function withPale(plain, theme) {
  const room = Array.from({ length: KINDS }, (_, k) => plain[k] ?? plain[0]);
  return [...room, ...room.map((color) => mix(color, theme.box, PALE))];
}

function ramp(low, middle, high) {
  return Array.from({ length: LEVELS }, (_, k) => {
    const share = (2 * k) / (LEVELS - 1);
    return share < 1 ? mix(low, middle, share) : mix(middle, high, share - 1);
  });
}

// What picks a disc's colour from the palette; `discs` as in molecules.js.
export function shadesOf(discs) {
  return discs.shades ?? discs.species;
}
