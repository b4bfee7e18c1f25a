// Which renderer: WebGL2 on real graphics hardware, else the CPU rasteriser, which beats WebGL in software by far.

const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

export function hasHardwareGl() {
  const gl = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  if (!gl) return false;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER) || "";
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return !SOFTWARE.test(name);
}

// `wish` is "cpu", "gl" or anything else for a probe; ?renderer= in the address comes first.
export function chooseRenderer(wish) {
  const asked = new URLSearchParams(location.search).get("renderer") || wish;
  if (asked === "cpu" || asked === "gl") return asked;
  return hasHardwareGl() ? "gl" : "cpu";
}
