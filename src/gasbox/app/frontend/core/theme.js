// Colours of the box, from CSS variables, so that a page or a style sheet can set them:
// --gasbox-box (inside), --gasbox-outside, --gasbox-wall, --gasbox-obstacle (edges), --gasbox-ring (followed particle), --gasbox-stick (in molecules),
// --gasbox-accent, -heat, -cool (of worlds), and
// those of shades: --gasbox-gas, -liquid, -solid; --gasbox-neighbours-0 to -7; --gasbox-slow, -medium, -fast.
// The three phases differ in brightness and between blue and orange, so that all kinds of eyes can tell them apart.
// Light or dark follows the system, unless data-theme="light|dark" on <html> or NiceGUI's body--dark says otherwise.
import { mix, parse } from "./color.js";

const LIGHT =
  "--gasbox-box:#ffffff;--gasbox-outside:#f2f4f7;--gasbox-wall:#3d4756;--gasbox-obstacle:#3d4756;--gasbox-ring:#111827;--gasbox-stick:#333d4d;" +
  "--gasbox-gas:#e69500;--gasbox-liquid:#3d9be9;--gasbox-solid:#35297a;" +
  neighbours("#dcc31c #9ccb35 #4fba68 #21a084 #29788e #365a8c #45317c #c01f5a") +
  "--gasbox-accent:#2457d6;--gasbox-heat:#c2410c;--gasbox-cool:#0369a1;" +
  "--gasbox-slow:#2c3a94;--gasbox-medium:#c2468a;--gasbox-fast:#f5a300;";
const DARK =
  "--gasbox-box:#12161d;--gasbox-outside:#0b0e13;--gasbox-wall:#a9b4c4;--gasbox-obstacle:#a9b4c4;--gasbox-ring:#ffffff;--gasbox-stick:#e8edf4;" +
  "--gasbox-gas:#ffab3d;--gasbox-liquid:#2f8fe8;--gasbox-solid:#e4defc;" +
  neighbours("#6a5bc4 #4d76b8 #2f93a0 #21a886 #4fc36b #9fda3c #f5e12d #ff6c95") +
  "--gasbox-accent:#86a9ff;--gasbox-heat:#ff9a5c;--gasbox-cool:#6cc4f5;" +
  "--gasbox-slow:#5263e8;--gasbox-medium:#d3579d;--gasbox-fast:#ffd061;";
const STYLE = `
:where(:root){${LIGHT}}
@media (prefers-color-scheme: dark){:where(:root:not([data-theme="light"])){${DARK}}}
:where([data-theme="light"]),:where(body.body--light){${LIGHT}}
:where([data-theme="dark"]),:where(body.body--dark){${DARK}}
.gasbox-lab{position:relative;overflow:hidden;touch-action:pan-y;user-select:none;-webkit-user-select:none}
.gasbox-lab canvas{position:absolute;inset:0;width:100%;height:100%;display:block}
.gasbox-lab canvas.gasbox-overlay{pointer-events:none}
.gasbox-tip{position:absolute;left:0;top:0;padding:.4em .6em;border-radius:.4em;white-space:pre;pointer-events:none;
font-size:12px;line-height:1.35;font-variant-numeric:tabular-nums;background:var(--gasbox-outside);
color:var(--gasbox-ring);border:1px solid var(--gasbox-wall);opacity:.94}
.gasbox-tip[hidden]{display:none}
.gasbox-message{position:absolute;left:50%;top:50%;transform:translate(-50%,-50%);max-width:80%;padding:.8em 1.2em;
border-radius:.6em;text-align:center;background:var(--gasbox-outside);color:var(--gasbox-wall);
border:1px solid var(--gasbox-wall)}
.gasbox-message[hidden]{display:none}`;

function neighbours(colors) {
  return colors.split(" ").map((color, k) => `--gasbox-neighbours-${k}:${color};`).join("");
}

export function installStyle() {
  if (document.getElementById("gasbox-style")) return;
  const style = document.createElement("style");
  style.id = "gasbox-style";
  style.textContent = STYLE;
  document.head.prepend(style);
}

export function readTheme(element) {
  const style = getComputedStyle(element);
  const read = (name) => style.getPropertyValue(`--gasbox-${name}`).trim();
  const box = parse(read("box"), [255, 255, 255]);
  return {
    box,
    stone: mix(box, parse(read("obstacle"), [61, 71, 86]), 0.22), // the inside of obstacles
    outside: parse(read("outside"), [242, 244, 247]),
    wall: read("wall") || "#3d4756",
    obstacle: read("obstacle") || "#3d4756",
    ring: read("ring") || "#111827",
    accent: read("accent") || "#2457d6",
    heat: read("heat") || "#c2410c",
    cool: read("cool") || "#0369a1",
    bond: mix(box, parse(read("obstacle"), [61, 71, 86]), 0.7),
    stick: parse(read("stick"), [51, 61, 77]),
    shade: (name) => parse(read(name)),
  };
}

// Calls back whenever light or dark may have changed; returns a function that ends this.
export function watchTheme(callback) {
  const media = matchMedia("(prefers-color-scheme: dark)");
  media.addEventListener("change", callback);
  const observer = new MutationObserver(callback);
  for (const node of [document.documentElement, document.body]) {
    observer.observe(node, { attributes: true, attributeFilter: ["class", "data-theme", "style"] });
  }
  return () => {
    media.removeEventListener("change", callback);
    observer.disconnect();
  };
}
