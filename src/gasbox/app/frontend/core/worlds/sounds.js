// Short tones, made by an oscillator. Off until somebody switches them on: a browser waits for a gesture anyway, and a classroom
// is full of pages. What was chosen is kept; buttons with data-gasbox-sound show it, and change it.

const KEY = "gasbox-sound";
const LOUDNESS = 0.12;
const APART = 0.03; // s between two tones of a kind

// [Hz at the start, Hz at the end, seconds, form]
const TONES = {
  paddle: [470, 470, 0.07, "square"],
  wall: [235, 235, 0.05, "square"],
  brick: [880, 660, 0.08, "triangle"],
  goal: [330, 110, 0.45, "sawtooth"],
};

function stored() {
  try {
    return localStorage.getItem(KEY) === "on";
  } catch {
    return false; // storage is forbidden
  }
}

export class Sounds {
  constructor() {
    this.on = stored();
    this.counts = null;
    this.played = {}; // kind -> how many tones, for those who want to know
    this.last = {};
    this.ender = new AbortController();
    const { signal } = this.ender;
    document.addEventListener("click", (event) => this.clicked(event), { signal });
    for (const type of ["pointerdown", "keydown"]) {
      window.addEventListener(type, () => this.wake(), { signal, capture: true });
    }
    this.tell();
  }

  clicked(event) {
    if (event.target.closest?.("[data-gasbox-sound]")) this.toggle();
  }

  toggle() {
    this.on = !this.on;
    try {
      localStorage.setItem(KEY, this.on ? "on" : "off");
    } catch {
      // it holds for this page only
    }
    this.wake();
    if (this.on) this.audio?.resume().then(() => this.play("paddle"), () => {});
    this.tell();
  }

  // Browsers let a page sound only after a gesture.
  wake() {
    if (!this.on || typeof AudioContext === "undefined") return;
    this.audio ??= new AudioContext({ latencyHint: "interactive" });
    if (this.audio.state === "suspended") this.audio.resume().catch(() => {});
  }

  // Buttons come and go with the controls around them.
  tell() {
    for (const button of document.querySelectorAll("[data-gasbox-sound]")) {
      const pressed = String(this.on);
      if (button.getAttribute("aria-pressed") !== pressed) button.setAttribute("aria-pressed", pressed);
    }
  }

  // counts: kind -> how many there were since the start of the game; each that has grown is heard once.
  hear(counts) {
    const before = this.counts;
    this.counts = { ...counts };
    if (before) for (const kind of Object.keys(TONES)) if (counts[kind] > (before[kind] ?? 0)) this.play(kind);
  }

  play(kind) {
    if (!this.on || this.audio?.state !== "running") return;
    const now = this.audio.currentTime;
    if (now - (this.last[kind] ?? -1) < APART) return;
    this.last[kind] = now;
    this.played[kind] = (this.played[kind] ?? 0) + 1;
    tone(this.audio, now, ...TONES[kind]);
  }

  destroy() {
    this.ender.abort();
    this.audio?.close().catch(() => {});
  }
}

function tone(audio, now, from, to, seconds, form) {
  const oscillator = audio.createOscillator();
  const gain = audio.createGain();
  oscillator.type = form;
  oscillator.frequency.setValueAtTime(from, now);
  oscillator.frequency.exponentialRampToValueAtTime(to, now + seconds);
  gain.gain.setValueAtTime(0, now);
  gain.gain.linearRampToValueAtTime(LOUDNESS, now + 0.004); // neither end clicks
  gain.gain.setTargetAtTime(0, now + 0.5 * seconds, 0.15 * seconds);
  oscillator.connect(gain).connect(audio.destination);
  oscillator.start(now);
  oscillator.stop(now + 1.5 * seconds);
}
