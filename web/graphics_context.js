/** The WebGL 2 context of a canvas, which a browser may take away and give back at any time. */

// How long a lost context may stay away before the visitor is told.
const kPatienceMs = 4000;

/** The context; throws an Error that a visitor can act on where there is none. */
export function makeContext(canvas) {
  // The renderer multisamples by itself and copies the finished picture here.
  const gl = canvas.getContext("webgl2", {
    alpha: false,
    antialias: false,
    depth: false,
    stencil: false,
    powerPreference: "high-performance",
  });
  if (!gl) {
    throw new Error(
      "This browser offers no WebGL 2, which the picture needs. A current browser with hardware acceleration switched on has it.",
    );
  }
  return gl;
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{lost: () => void, missed: () => void, restored: () => void}} host missed: it has been away for some seconds
 * @param {AbortSignal} signal ends all listening
 */
export function watchContext(canvas, host, signal) {
  let timer = 0;
  const lost = (event) => {
    event.preventDefault(); // or it is never restored
    host.lost();
    timer = setTimeout(host.missed, kPatienceMs);
  };
  const restored = () => {
    clearTimeout(timer);
    host.restored();
  };
  canvas.addEventListener("webglcontextlost", lost, { signal });
  canvas.addEventListener("webglcontextrestored", restored, { signal });
  signal.addEventListener("abort", () => clearTimeout(timer));
}
