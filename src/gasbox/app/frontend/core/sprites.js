// Small discs, rasterised once for each place within a pixel and then stamped.

export const PHASES = 4; // places per pixel and direction: a stamp is at most an eighth of a pixel off
const SAMPLES = 8; // per pixel and direction, for the coverage of pixels

// Share of the pixel [i, i+1] x [j, j+1] that a disc of radius r at (cx, cy) covers.
function coverage(i, j, cx, cy, r) {
  let inside = 0;
  for (let b = 0; b < SAMPLES; b++) {
    const dy = j + (b + 0.5) / SAMPLES - cy;
    for (let a = 0; a < SAMPLES; a++) {
      const dx = i + (a + 0.5) / SAMPLES - cx;
      if (dx * dx + dy * dy <= r * r) inside++;
    }
  }
  return inside / (SAMPLES * SAMPLES);
}

// For radius r in pixels, and rows of `stride` pixels: [phaseY * PHASES + phaseX] -> stamp.
// A stamp has offsets into the pixels for fully covered ones, and offsets with an alpha (1 to 255) for the edge.
export function makeSprites(r, stride) {
  const sprites = [];
  const reach = Math.ceil(r) + 1;
  for (let phaseY = 0; phaseY < PHASES; phaseY++) {
    for (let phaseX = 0; phaseX < PHASES; phaseX++) {
      sprites.push(makeStamp(r, reach, phaseX / PHASES, phaseY / PHASES, stride));
    }
  }
  return sprites;
}

function makeStamp(r, reach, cx, cy, stride) {
  const solid = [];
  const edge = [];
  const alpha = [];
  for (let j = -reach; j <= reach; j++) {
    for (let i = -reach; i <= reach; i++) {
      const covered = Math.round(256 * coverage(i, j, cx, cy, r));
      if (covered >= 256) solid.push([i, j]);
      else if (covered > 0) {
        edge.push([i, j]);
        alpha.push(covered);
      }
    }
  }
  const offsets = (cells) => Int32Array.from(cells, ([i, j]) => j * stride + i);
  return { reach, solid: offsets(solid), edge: offsets(edge), alpha: Uint16Array.from(alpha), cells: [solid, edge] };
}
