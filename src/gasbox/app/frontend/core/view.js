// Where the box is on the canvas: fitted with its aspect ratio kept, zoomed and moved. All in device pixels; y up.

const MARGIN = 6; // CSS pixels around the box, room for its boundary
const ROOMY = 16; // the same where sides have handles
const MOST = 400; // times

export class View {
  constructor() {
    this.zoom = 1;
    this.centerX = 0.5; // what is in the middle, as a share of the room
    this.centerY = 0.5;
    this.margin = MARGIN;
    this.room = [0, 0, 1, 1];
    this.resize(1, 1, 1);
  }

  resize(width, height, ratio) {
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    this.update();
  }

  // room: [left, bottom, right, top] of what is seen at zoom 1
  setRoom(room, handles) {
    this.room = room;
    this.margin = handles ? ROOMY : MARGIN;
    this.update();
  }

  get boxWidth() {
    return this.room[2] - this.room[0];
  }

  get boxHeight() {
    return this.room[3] - this.room[1];
  }

  update() {
    const margin = 2 * this.margin * this.ratio;
    const fit = Math.min((this.width - margin) / this.boxWidth, (this.height - margin) / this.boxHeight);
    this.scale = Math.max(fit, 1e-9) * this.zoom;
    this.centerX = this.clamp(this.centerX, this.width / (this.boxWidth * this.scale));
    this.centerY = this.clamp(this.centerY, this.height / (this.boxHeight * this.scale));
    // pixel of the origin of the box
    this.originX = this.width / 2 - (this.room[0] + this.centerX * this.boxWidth) * this.scale;
    this.originY = this.height / 2 + (this.room[1] + this.centerY * this.boxHeight) * this.scale;
  }

  // A box that is smaller than the canvas is centred; a larger one cannot be pushed out of sight.
  clamp(center, seen) {
    if (seen >= 1) return 0.5;
    return Math.min(Math.max(center, 0.5 * seen), 1 - 0.5 * seen);
  }

  toBox(px, py) {
    return [(px - this.originX) / this.scale, (this.originY - py) / this.scale];
  }

  toCanvas(x, y) {
    return [this.originX + x * this.scale, this.originY - y * this.scale];
  }

  zoomAt(factor, px, py) {
    const [x, y] = this.toBox(px, py);
    this.zoom = Math.min(Math.max(this.zoom * factor, 1), MOST);
    this.update();
    const [nowX, nowY] = this.toBox(px, py);
    this.centerX += (x - nowX) / this.boxWidth;
    this.centerY += (y - nowY) / this.boxHeight;
    this.update();
  }

  pan(dx, dy) {
    this.centerX -= dx / (this.boxWidth * this.scale);
    this.centerY += dy / (this.boxHeight * this.scale);
    this.update();
  }

  reset() {
    this.zoom = 1;
    this.centerX = this.centerY = 0.5;
    this.update();
  }
}
