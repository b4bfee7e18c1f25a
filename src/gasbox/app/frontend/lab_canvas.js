// The NiceGUI element: hands its box to the framework-free drawing code and passes events on.
import { createLab } from "gasbox-core";

export default {
  template: '<div class="gasbox-lab"></div>',
  props: { session: String, renderer: String, guest: Boolean },
  mounted() {
    this.lab = createLab(this.$el, {
      session: this.session,
      renderer: this.renderer,
      guest: this.guest,
      onPick: (row) => this.$emit("pick", row),
      onNotice: (notice) => this.$emit("notice", notice),
    });
  },
  beforeUnmount() {
    this.lab.destroy();
  },
  methods: {
    resetView() {
      this.lab.resetView();
    },
  },
};
