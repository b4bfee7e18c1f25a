// The game of pong on the page: the board over the court, keys, mouse and fingers for the bats, and its sounds.
import { drawBoard } from "./pong_board.js";
import { Hands } from "./pong_hands.js";
import { Sounds } from "./sounds.js";

const GRACE = 700; // ms after a serve or the end of a game in which another press is one too many
const LETTERS = { KeyW: "w", KeyS: "s", KeyM: "m" };
const NEIGHBOURS = ["d", "e"]; // beside W and S; in the heat of a game they must not take walls away or open a panel
const EMPTY = { score: [0, 0], phase: "play", winner: null, players: {}, bats: {}, sounds: {} };

// Letters by what is on the key; by where it is on keyboards without Latin letters.
function nameOf({ key, code }) {
  return /^[^\x00-\x7f]$/.test(key) ? (LETTERS[code] ?? key) : key.toLowerCase();
}

const busy = (target) => target?.closest?.("button, a, [role=button], [role=slider], [role=radio], [role=switch], [role=tab]");

export class PongWorld {
  constructor(lab, send) {
    this.lab = lab;
    this.view = EMPTY;
    this.since = 0;
    this.touch = matchMedia("(hover: none)").matches;
    this.hands = new Hands(send, () => this.go());
    this.sounds = new Sounds();
    this.send = send;
    this.ender = new AbortController();
    const { signal } = this.ender;
    const letGo = () => this.hands.release();
    window.addEventListener("blur", letGo, { signal });
    document.addEventListener("visibilitychange", letGo, { signal });
    const still = (event) => this.held && event.preventDefault();
    lab.element.addEventListener("touchstart", still, { signal, passive: false });
    lab.element.addEventListener("touchmove", still, { signal, passive: false });
  }

  get paused() {
    return this.lab.frame ? !this.lab.frame.playing : false;
  }

  // Whether fingers belong to bats, and not to the page.
  get held() {
    return this.hands.humans.length > 0 && !this.paused;
  }

  hear(view) {
    if (!view?.score) return;
    if (view.phase !== this.view.phase) {
      this.since = performance.now();
      this.hands.outbox.said.clear(); // bats may be elsewhere now
    }
    this.view = view;
    this.hands.know(view.players, view.bats);
    this.sounds.hear(view.sounds ?? {});
    this.sounds.tell();
  }

  draw(context, scene) {
    const { view, paused, touch } = this;
    const { humans, moved } = this.hands;
    drawBoard(context, scene, { view, time: scene.frame?.time ?? 0, paused, touch, humans, moved });
  }

  key(event, down) {
    const name = nameOf(event);
    if (name === " " || name === "enter") return down && !busy(event.target) && this.confirm(name, event.repeat);
    if (name === "m") {
      if (down && !event.repeat) this.sounds.toggle();
      return true;
    }
    if (down && name.startsWith("arrow") && event.target?.closest?.("[role=slider], [role=radio]")) return false;
    // While it is paused, keys mean what they mean in any gas.
    if (down && this.paused) return false;
    return this.hands.key(name, down, event.repeat) || (down && this.held && NEIGHBOURS.includes(name));
  }

  // Space and Enter serve, or begin again. In play Space is left to the page, which pauses, unless it comes just after a serve.
  confirm(name, repeated) {
    if (this.paused && name === " ") return false;
    if (this.view.phase === "play") return performance.now() - this.since < GRACE;
    if (!repeated) this.go();
    return true;
  }

  go() {
    if (this.view.phase === "serve") this.send("serve", true);
    else if (this.view.phase === "over" && performance.now() - this.since > GRACE) this.send("restart", true);
  }

  // While it is paused, particles can be pointed at and picked as in any gas.
  pointer(x, y, event) {
    if (event.type === "pointerdown") {
      if (event.button !== 0) return false;
      this.touch = event.pointerType === "touch";
    }
    if (this.paused) {
      this.hands.fingers.clear();
      return false;
    }
    const took = this.hands.pointer(x, y, event, this.lab.table.width / 2);
    if (took) {
      this.lab.element.style.cursor = "";
      this.lab.point(null);
    }
    return took;
  }

  destroy() {
    this.ender.abort();
    this.sounds.destroy();
  }
}
