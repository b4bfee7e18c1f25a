// Neighbours that are joined by lines: pairs of discs nearer to each other than the mean of their reaches.
import { extent } from "./outline.js";

export const BOND_WIDTH = 1.5; // CSS pixels
const MOST = 10_000; // discs; with more, lines would be too thin to see and too many to draw
const SHRUNK = 0.6; // of their radius: discs between lines are drawn smaller

// What of its radius a disc is drawn with.
export function shareOf(frame) {
  return frame.bonds && frame.count <= MOST ? SHRUNK : 1;
}

// Ends of the lines in box coordinates, [x, y, x, y] for each; found once for each frame. A line through a periodic side
// is there twice, at both ends.
export function bondsOf(frame, table) {
  if (!frame.bonds || frame.count > MOST) return NONE;
  frame.lines ??= find(frame, table);
  return frame.lines;
}

const NONE = new Float32Array(0);
let room = new Float32Array(1 << 12); // grows as needed, and is used again

function find(frame, table) {
  const grid = new Grid(frame, table);
  const { position, species, count } = frame;
  const { reaches } = table;
  let used = 0;
  const add = (x0, y0, x1, y1) => {
    if (used + 4 > room.length) {
      const wider = new Float32Array(2 * room.length);
      wider.set(room);
      room = wider;
    }
    room[used++] = x0;
    room[used++] = y0;
    room[used++] = x1;
    room[used++] = y1;
  };
  for (let i = 0; i < count; i++) {
    const x = position[2 * i];
    const y = position[2 * i + 1];
    const own = reaches[species[i]];
    grid.near(i, x, y, (j) => {
      const dx = grid.shortX(position[2 * j] - x);
      const dy = grid.shortY(position[2 * j + 1] - y);
      const reach = 0.5 * (own + reaches[species[j]]);
      if (dx * dx + dy * dy > reach * reach) return;
      add(x, y, x + dx, y + dy);
      const farX = position[2 * j];
      const farY = position[2 * j + 1];
      if (Math.abs(farX - x - dx) > reach || Math.abs(farY - y - dy) > reach) add(farX - dx, farY - dy, farX, farY);
    });
  }
  return room.slice(0, used);
}

// Discs in square cells as wide as the longest reach; along a periodic direction with fewer than three cells, in one.
class Grid {
  constructor(frame, table) {
    const { position, count } = frame;
    const [left, bottom, right, top] = extent(table, frame);
    const size = Math.max(1e-9, ...table.reaches);
    const cells = (length, periodic) => {
      const fit = Math.min(Math.max(1, Math.floor(length / size)), 2000);
      return periodic && fit < 3 ? 1 : fit;
    };
    this.width = right - left;
    this.height = top - bottom;
    this.left = left;
    this.bottom = bottom;
    this.periodicX = table.periodicX;
    this.periodicY = table.periodicY;
    this.columns = cells(this.width, table.periodicX);
    this.rows = cells(this.height, table.periodicY);
    this.first = new Int32Array(this.columns * this.rows).fill(-1);
    this.next = new Int32Array(count);
    for (let i = 0; i < count; i++) {
      const cell = this.row(position[2 * i + 1]) * this.columns + this.column(position[2 * i]);
      this.next[i] = this.first[cell];
      this.first[cell] = i;
    }
  }

  column(x) {
    return Math.min(Math.max(Math.floor(((x - this.left) / this.width) * this.columns), 0), this.columns - 1);
  }

  row(y) {
    return Math.min(Math.max(Math.floor(((y - this.bottom) / this.height) * this.rows), 0), this.rows - 1);
  }

  shortX(d) {
    return this.periodicX ? d - this.width * Math.round(d / this.width) : d;
  }

  shortY(d) {
    return this.periodicY ? d - this.height * Math.round(d / this.height) : d;
  }

  // Calls back with each later disc that may be near.
  near(i, x, y, visit) {
    const { columns, rows, first, next } = this;
    const column = this.column(x);
    const row = this.row(y);
    const [fromX, toX] = columns === 1 ? [0, 0] : [-1, 1];
    const [fromY, toY] = rows === 1 ? [0, 0] : [-1, 1];
    for (let b = fromY; b <= toY; b++) {
      let at = row + b;
      if (at < 0 || at >= rows) {
        if (!this.periodicY) continue;
        at = (at + rows) % rows;
      }
      for (let a = fromX; a <= toX; a++) {
        let across = column + a;
        if (across < 0 || across >= columns) {
          if (!this.periodicX) continue;
          across = (across + columns) % columns;
        }
        for (let j = first[at * columns + across]; j >= 0; j = next[j]) if (j > i) visit(j);
      }
    }
  }
}
