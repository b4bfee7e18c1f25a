// What is written over the court: score, centre line, and what is to be done next.
import { font, plate } from "./ink.js";

// What the court says in the middle: [large, small] lines, or none.
export function words({ view, time, paused, humans, touch }) {
  const again = touch ? "Tap for a new game" : "Space or Enter: new game";
  if (view.phase === "over") return [verdict(view, humans), humans.length ? again : "New game: the button below"];
  if (paused && !view.last && !view.score.some(Boolean)) return ["Ready?", touch ? "Play starts" : "Space starts"];
  if (paused) return ["Paused", touch ? "" : "P or Space goes on"];
  if (view.phase !== "serve") return null;
  const wait = view.serve_at - time;
  const large = Number.isFinite(view.serve_at) ? `Serve in ${Math.max(wait, 0).toFixed(1)}` : "Get ready";
  return [large, humans.length ? (touch ? "Tap to serve" : "Space serves at once") : ""];
}

function verdict({ winner, players }, humans) {
  if (winner === null) return "A draw";
  if (!players.right) return winner === "left" ? "Not a brick is left" : "No ball is left";
  if (humans.length !== 1) return winner === "left" ? "Left wins" : "Right wins";
  return humans[0] === winner ? "You win" : "The computer wins";
}

// How a bat is moved, for the half of each human: side -> lines.
export function hints({ humans, touch }) {
  if (touch) return Object.fromEntries(humans.map((side) => [side, ["Your bat", "slide a finger here"]]));
  const keys = { left: "W and S", right: "\u2191 and \u2193" };
  if (humans.length === 1) return { [humans[0]]: ["Your bat", "mouse, \u2191 \u2193 or W S"] };
  return Object.fromEntries(humans.map((side) => [side, [keys[side], "or the mouse in this half"]]));
}

// state: { view, time, paused, humans, touch, moved }; time: of the frame
export function drawBoard(context, { table, view, theme }, state) {
  const { width, height } = table;
  const pen = new Pen(context, view, theme, height * view.scale);
  if (state.view.players.right === null) alone(pen, state.view, ...view.toCanvas(0.25 * width, height));
  else {
    net(context, table, view, theme);
    state.view.score.forEach((points, k) => score(pen, points, ...view.toCanvas(width * (k ? 0.75 : 0.25), height)));
  }
  const said = words(state);
  if (said) lines(pen, said, ...view.toCanvas(width / 2, 0.27 * height), 0.07);
  if (state.moved || state.view.phase === "over") return;
  for (const [side, text] of Object.entries(hints(state))) {
    const [x, y] = view.toCanvas(width * (side === "left" ? 0.27 : 0.73), 0.55 * height);
    lines(pen, text, x, y, 0.05, state.view.phase !== "play");
  }
}

function score(pen, points, x, top) {
  pen.write(String(points), x, top + pen.size(0.13), pen.size(0.17), 700, 0.6);
}

// Bricks that were hit, and how many balls may still be lost.
function alone(pen, { score: [bricks, lost], points }, x, top) {
  score(pen, bricks, x, top);
  const left = points - lost;
  pen.write(`${left} ${left === 1 ? "ball" : "balls"} left`, x, top + pen.size(0.265), pen.size(0.045), 600, 0.85);
}

function net(context, { width, height }, view, theme) {
  const [x, top] = view.toCanvas(width / 2, height);
  const [, bottom] = view.toCanvas(width / 2, 0);
  const dash = (bottom - top) / 41;
  context.strokeStyle = theme.obstacle;
  context.globalAlpha = 0.55;
  context.lineWidth = Math.max(1, Math.round(2 * view.ratio));
  context.lineCap = "butt";
  context.setLineDash([dash, dash]);
  context.beginPath();
  context.moveTo(Math.round(x), top);
  context.lineTo(Math.round(x), bottom);
  context.stroke();
  context.setLineDash([]);
}

// Two lines, on a plate so that they can be read over a gas; but no plate may hide the ball in play.
function lines(pen, [large, small], x, y, share, plated = true) {
  const size = pen.size(share);
  const less = Math.max(0.62 * size, 10 * pen.view.ratio);
  const gap = small ? 1.15 * size : 0;
  const wide = Math.max(pen.width(large, size, 650), small ? pen.width(small, less, 500) : 0);
  if (plated) plate(pen.context, pen.theme, x, y + 0.45 * gap, wide + 1.4 * size, gap + 1.7 * size);
  pen.write(large, x, y, size, 650, 1);
  if (small) pen.write(small, x, y + gap, less, 500, 0.85);
}

class Pen {
  constructor(context, view, theme, court) {
    Object.assign(this, { context, view, theme, court });
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineJoin = "round";
  }

  // A share of the height of the court, but not too small to be read.
  size(share) {
    return Math.max(share * this.court, 11 * this.view.ratio);
  }

  width(text, size, weight) {
    this.context.font = font(size, weight);
    return this.context.measureText(text).width;
  }

  write(text, x, y, size, weight, alpha) {
    const { context, theme } = this;
    context.font = font(size, weight);
    context.globalAlpha = 0.7;
    context.strokeStyle = `rgb(${theme.box})`;
    context.lineWidth = 0.12 * size;
    context.strokeText(text, x, y);
    context.globalAlpha = alpha;
    context.fillStyle = theme.ring;
    context.fillText(text, x, y);
  }
}
