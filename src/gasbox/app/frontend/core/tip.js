// What is pointed at: its name and its numbers beside it, moving along with it.

const GAP = 14; // CSS pixels between a particle and its numbers

export class Tip {
  constructor(element) {
    this.element = element;
    this.node = document.createElement("div");
    this.node.className = "gasbox-tip";
    this.node.setAttribute("role", "tooltip");
    this.node.hidden = true;
    element.append(this.node);
  }

  show({ frame, table, view }) {
    const pointed = frame?.pointed;
    const seen = pointed && pointed.row < frame.count;
    this.node.hidden = !seen;
    if (!seen) return;
    const kind = frame.species[pointed.row];
    const text = wording(table.names[kind], pointed);
    if (this.text !== text) {
      this.text = text;
      this.node.textContent = text;
    }
    const [px, py] = view.toCanvas(frame.position[2 * pointed.row], frame.position[2 * pointed.row + 1]);
    const gap = GAP + (table.radii[kind] * view.scale) / view.ratio;
    this.place(px / view.ratio, py / view.ratio, gap);
  }

  // To the right of the particle, or to the left where there is no room; never outside the box.
  place(x, y, gap) {
    const { clientWidth: width, clientHeight: height } = this.element;
    const { offsetWidth: wide, offsetHeight: high } = this.node;
    const right = x + gap + wide <= width;
    const left = Math.min(Math.max(right ? x + gap : x - gap - wide, 0), Math.max(width - wide, 0));
    const top = Math.min(Math.max(y - high / 2, 0), Math.max(height - high, 0));
    this.node.style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
  }
}

function wording(name, { id, speed, angularVelocity, translational, rotational, vibrational }) {
  const turns = Number.isFinite(rotational);
  return [
    `${name} no. ${id}`,
    `speed ${short(speed)}`,
    ...(turns ? [`angular velocity ${short(angularVelocity)}`] : []),
    ...(turns ? ["energy"] : []),
    `${turns ? "  of flight" : "energy"} ${short(translational)}`,
    ...(turns ? [`  of rotation ${short(rotational)}`] : []),
    ...(Number.isFinite(vibrational) ? [`  of vibration ${short(vibrational)}`] : []),
  ].join("\n");
}

function short(value) {
  return String(Number(value.toPrecision(3))).replace("-", "\u2212");
}
