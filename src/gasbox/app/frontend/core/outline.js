// The surroundings of the gas in box coordinates: where its walls are, and where those that move are now.

// A line is what is drawn of a wall: `from` and `to`, or a `center` and `radius`; `out` is the unit vector away from the
// gas for sides of the container, null for lines with gas on both sides; `wall` is the entry of the table.
export function readOutline({ container, walls, obstacles, gravity }) {
  const { shape, width, height, periodic } = container;
  const all = walls.map((wall, index) => ({ ...wall, index, normal: wall.normal ?? [0, 0] }));
  const stones = obstacles.map((one) => ({ ...one, wall: all[one.wall] }));
  return {
    shape,
    width,
    height,
    periodicX: periodic[0],
    periodicY: periodic[1],
    radius: container.radius ?? 0,
    vertices: container.vertices ?? null,
    walls: all,
    obstacles: stones,
    gravity,
    sides: sides(container, all),
    lines: stones.filter((one) => one.shape === "segment").map((one) => segment(one)),
    blocks: stones.filter((one) => one.shape !== "segment" && !isBat(one)),
    bats: stones.filter(isBat),
  };
}

// A disc that moves: it is drawn anew with each frame, where it is.
function isBat({ shape, wall }) {
  return shape === "disc" && wall.motion !== null;
}

function sides({ shape, width, height, radius, vertices }, walls) {
  if (shape === "circle") return [{ wall: walls[0], center: [radius, radius], radius, out: null }];
  if (shape === "polygon") {
    return vertices.map(([x0, y0], k) => {
      const [x1, y1] = vertices[(k + 1) % vertices.length];
      const length = Math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2);
      return { wall: walls[k], from: [x0, y0], to: [x1, y1], out: [(y1 - y0) / length, (x0 - x1) / length] };
    });
  }
  return [
    { wall: walls[0], from: [0, 0], to: [0, height], out: [-1, 0] },
    { wall: walls[1], from: [width, 0], to: [width, height], out: [1, 0] },
    { wall: walls[2], from: [0, 0], to: [width, 0], out: [0, -1] },
    { wall: walls[3], from: [0, height], to: [width, height], out: [0, 1] },
  ];
}

function segment({ wall, start, end }) {
  return { wall, from: start, to: end, out: null };
}

// How far a wall is from where it was at the start, along its normal.
export function displacementOf(wall, frame) {
  return frame?.displacement[wall.index] ?? 0;
}

// [left, bottom, right, top] of the box, with its sides where they are now.
export function extent(table, frame) {
  const moved = frame?.displacement;
  if (table.shape !== "rectangle" || !moved?.length) return [0, 0, table.width, table.height];
  return [moved[0], moved[2], table.width + moved[1], table.height + moved[3]];
}

// Where the ends of a straight line are now. Sides of a rectangle grow and shrink with their neighbours.
export function ends(line, table, frame) {
  let [x0, y0] = line.from;
  let [x1, y1] = line.to;
  if (line.out && table.shape === "rectangle") {
    const [left, bottom, right, top] = extent(table, frame);
    if (line.out[0]) x0 = x1 = line.out[0] < 0 ? left : right;
    else [x0, x1] = [left, right];
    if (line.out[1]) y0 = y1 = line.out[1] < 0 ? bottom : top;
    else [y0, y1] = [bottom, top];
    return [x0, y0, x1, y1];
  }
  const d = displacementOf(line.wall, frame);
  const [nx, ny] = line.wall.normal;
  return [x0 + nx * d, y0 + ny * d, x1 + nx * d, y1 + ny * d];
}

// All of it that will be seen as far as can be told beforehand: [left, bottom, right, top].
export function reach(table) {
  const room = [0, 0, table.width, table.height];
  for (const { wall, out } of table.sides) {
    if (wall.motion === null || !out) continue;
    const [low, high] = wall.reach ?? [0, 0];
    if (out[0] < 0) room[0] = Math.min(room[0], low);
    if (out[1] < 0) room[1] = Math.min(room[1], low);
    if (out[0] > 0) room[2] = Math.max(room[2], table.width + high);
    if (out[1] > 0) room[3] = Math.max(room[3], table.height + high);
  }
  return room;
}

// What is shown, so that sides that go beyond it stay in sight: it grows by more than is needed, and never shrinks. A box
// without sides, whose area a barostat changes, is followed instead.
export function grown(room, table, frame) {
  const now = extent(table, frame);
  if (table.periodicX && table.periodicY) return followed(room, now, frame);
  const spare = [0.15 * table.width, 0.15 * table.height];
  const beyond = [now[0] < room[0], now[1] < room[1], now[2] > room[2], now[3] > room[3]];
  if (!beyond.some(Boolean)) return room;
  return room.map((end, k) => (beyond[k] ? now[k] + (k < 2 ? -1 : 1) * spare[k % 2] : end));
}

const SPARE = 0.75; // the box fills this share of what is shown at least, as soon as the view has followed
const PACE = 0.01; // by which the view closes in with each frame

// In the middle, as large as it was until the box has become larger, or much smaller.
function followed(room, [left, bottom, right, top], frame) {
  if (!frame.displacement.length) return room;
  const [width, height] = [room[2] - room[0], room[3] - room[1]];
  const fill = Math.max((right - left) / width, (top - bottom) / height);
  const factor = 0.5 * (fill > 1 ? fill : fill < SPARE ? Math.max(fill / SPARE, 1 - PACE) : 1);
  const [x, y] = [(left + right) / 2, (bottom + top) / 2];
  const wanted = [x - factor * width, y - factor * height, x + factor * width, y + factor * height];
  return wanted.some((end, k) => Math.abs(end - room[k]) > 1e-6 * width) ? wanted : room;
}
