// The frame socket: keeps the newest frames, acknowledges cumulatively, connects again by itself.
import { Backlog } from "./backlog.js";
import { encodeAck, encodeHidden } from "./protocol.js";

const GONE = 4404;
const BUSY = 4503;
const REPLACED = 4409;
const KEY = "gasbox-session";
const RELOADED = "gasbox-reloaded";

export class FrameSocket {
  // onFrame() is called when there is something in the backlog; onText(message) for the rest. The session of a guest is
  // not the one that a page comes back to when it is loaded again.
  constructor(session, { onFrame, onText, guest = false }) {
    this.session = session;
    this.guest = guest;
    this.onFrame = onFrame;
    this.onText = onText;
    this.backlog = new Backlog(); // of ArrayBuffers
    this.received = 0;
    this.acked = 0;
    this.drawn = 0;
    this.delay = 250;
    this.onVisibility = () => this.send(encodeHidden(document.hidden));
    document.addEventListener("visibilitychange", this.onVisibility);
    this.connect();
  }

  connect() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const previous = this.guest ? null : sessionStorage.getItem(KEY);
    const query = previous && previous !== this.session ? `?previous=${encodeURIComponent(previous)}` : "";
    this.socket = new WebSocket(`${scheme}://${location.host}/gasbox/frames/${this.session}${query}`);
    this.socket.binaryType = "arraybuffer";
    this.received = this.acked = 0;
    this.socket.onopen = () => {
      if (document.hidden) this.onVisibility();
    };
    this.socket.onmessage = (event) => this.hear(event.data);
    this.socket.onclose = (event) => this.closed(event.code);
  }

  hear(data) {
    if (typeof data === "string") {
      const message = JSON.parse(data);
      if (message.kind === "table") {
        this.delay = 250;
        this.backlog.clear(); // it relies on the table before
        if (!this.guest) this.remember();
      }
      this.onText(message);
      return;
    }
    this.received++;
    this.backlog.put(data);
    this.onFrame();
  }

  remember() {
    sessionStorage.setItem(KEY, this.session);
    sessionStorage.removeItem(RELOADED);
  }

  // Cumulative, so that dropped frames and lost acks cannot use up the window.
  ack() {
    if (this.acked === this.received) return;
    this.acked = this.received;
    this.send(encodeAck(this.received, this.drawn));
  }

  send(text) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(text);
  }

  closed(code) {
    if (this.ended || code === REPLACED) return;
    if (code === GONE && !this.guest) return this.reload();
    if (code !== BUSY) this.onText({ kind: "lost" });
    this.delay = code === BUSY ? 5000 : Math.min(2 * this.delay, 3000);
    this.timer = setTimeout(() => this.connect(), this.delay);
  }

  // The server no longer knows this page; once is enough, so that no loop can arise.
  reload() {
    if (sessionStorage.getItem(RELOADED)) {
      this.onText({ kind: "gone" });
      return;
    }
    sessionStorage.setItem(RELOADED, "1");
    location.reload();
  }

  close() {
    this.ended = true;
    clearTimeout(this.timer);
    document.removeEventListener("visibilitychange", this.onVisibility);
    this.socket.close();
  }
}
