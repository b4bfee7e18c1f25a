export function createLab(element, options) {
  return { destroy() {}, resetView() {} };
}
