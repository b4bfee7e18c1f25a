// A small round pad: the arrow in it is gravity. Drag it, or turn it with the arrow keys.
export default {
  template: `
    <div class="gravity-pad" role="slider" tabindex="0" aria-label="Direction and strength of gravity"
         :aria-valuetext="text" aria-valuemin="0" aria-valuemax="100" :aria-valuenow="Math.round(100 * Math.hypot(x, y))"
         @pointerdown="grab" @pointermove="drag" @pointerup="drop" @pointercancel="drop" @keydown="key">
      <svg viewBox="-50 -50 100 100" aria-hidden="true">
        <circle class="rim" r="46" /><circle class="half" r="23" /><circle class="hub" r="4" />
        <line v-if="x || y" class="shaft" x1="0" y1="0" :x2="46 * x" :y2="-46 * y" />
        <circle class="tip" r="11" :cx="46 * x" :cy="-46 * y" />
      </svg>
    </div>`,
  props: { x: Number, y: Number, text: String },
  methods: {
    grab(event) {
      this.$el.setPointerCapture(event.pointerId);
      this.held = event.pointerId;
      this.tell(event);
    },
    drag(event) {
      if (event.pointerId === this.held) this.tell(event);
    },
    drop(event) {
      if (event.pointerId === this.held) this.held = undefined;
    },
    tell(event) {
      const frame = this.$el.getBoundingClientRect();
      const reach = 0.46 * frame.width;
      const x = (event.clientX - frame.left - frame.width / 2) / reach;
      const y = (frame.top + frame.height / 2 - event.clientY) / reach;
      this.send(x, y);
    },
    send(x, y) {
      const size = Math.max(1, Math.hypot(x, y));
      this.$emit("tilt", { x: x / size, y: y / size });
    },
    key(event) {
      const turn = { ArrowLeft: -15, ArrowRight: 15 }[event.key];
      const pull = { ArrowUp: -0.05, ArrowDown: 0.05, Home: -1, End: 1 }[event.key];
      if (turn === undefined && pull === undefined) return;
      event.preventDefault();
      const size = Math.hypot(this.x, this.y);
      const angle = (size ? Math.atan2(this.y, this.x) : -Math.PI / 2) + ((turn ?? 0) * Math.PI) / 180;
      const wanted = Math.min(Math.max(size + (pull ?? 0), 0), 1);
      this.send(wanted * Math.cos(angle), wanted * Math.sin(angle));
    },
  },
};
