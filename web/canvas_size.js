/**
 * Keeps a canvas at exactly as many pixels as the screen shows of it, whatever the page's zoom and the device's pixel ratio.
 */
export class CanvasSize {
  #stage;
  #canvas;
  #device = null; // [width, height] in device pixels
  #ratio = 1; // device pixels per CSS pixel, with what CSS zoom adds
  #applied = "";

  /**
   * @param {HTMLElement} stage the box that the canvas fills
   * @param {HTMLCanvasElement} canvas
   * @param {{resized: () => void, stale: () => void}} host resized: draw before this frame is shown, or the emptied canvas
   *   would flash; stale: a frame is wanted
   * @param {AbortSignal} signal ends all listening
   */
  constructor(stage, canvas, host, signal) {
    this.#stage = stage;
    this.#canvas = canvas;
    const observer = new ResizeObserver((entries) => {
      // The first call tells what the constructor has found out already.
      if (this.#measure(entries.at(-1))) host.resized();
    });
    try {
      observer.observe(stage, { box: "device-pixel-content-box" });
    } catch {
      observer.observe(stage);
    }
    signal.addEventListener("abort", () => observer.disconnect());
    const watchRatio = () => {
      const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
      const follow = () => {
        this.#measure(null);
        host.stale();
        watchRatio();
      };
      query.addEventListener("change", follow, { once: true, signal });
    };
    watchRatio();
    this.#measure(null);
    // A context that is made for these pixels need not be given others.
    [canvas.width, canvas.height] = this.#device;
  }

  // Whether the size is another one than before.
  #measure(entry) {
    const before = this.#device;
    const { clientWidth, clientHeight } = this.#stage;
    this.#ratio = devicePixelRatio * (this.#stage.currentCSSZoom ?? 1);
    const rounded = [Math.round(clientWidth * this.#ratio), Math.round(clientHeight * this.#ratio)];
    const box = entry?.devicePixelContentBoxSize?.[0];
    const exact = box ? [box.inlineSize, box.blockSize] : rounded;
    // A browser that plays another device reports the pixels of the real one here.
    const sound = exact.every((size, i) => Math.abs(size - rounded[i]) <= Math.ceil(this.#ratio));
    this.#device = sound ? exact : rounded;
    return !before?.every((size, i) => size === this.#device[i]);
  }

  /**
   * Gives the canvas its pixels and tells `resize` the CSS size that goes with them; does nothing when both are as before.
   * @param {WebGL2RenderingContext} gl of that canvas
   * @param {(widthCss: number, heightCss: number, devicePixelRatio: number) => void} resize
   */
  apply(gl, resize) {
    let [width, height] = this.#device;
    let ratio = this.#ratio;
    const limit = gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) || 4096;
    const shrink = Math.max(1, width / limit, height / limit);
    if (shrink > 1) [width, height, ratio] = [Math.floor(width / shrink), Math.floor(height / shrink), ratio / shrink];
    const size = `${width} ${height} ${ratio}`;
    if (size === this.#applied) return;
    this.#applied = size;
    // To set either empties the canvas, even if it stays as it is.
    if (this.#canvas.width !== width) this.#canvas.width = width;
    if (this.#canvas.height !== height) this.#canvas.height = height;
    resize(width / ratio, height / ratio, ratio);
  }
}
