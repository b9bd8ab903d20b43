import { createCore } from "./core.js";
import { kEditorCss } from "./editor_style.js";
import { fetchGltf, isGltfUrl } from "./gltf_files.js";
import { LabelLayer } from "./label_layer.js";
import { PillLayer } from "./pill_layer.js";
import { PointerInput } from "./pointer_input.js";

const kLabelFont = "Dimline Label";
const kLabelFontUrl = new URL("./assets/fonts/barlow-500.woff2", import.meta.url).href;

// How long a lost graphics context may stay away before the visitor is told.
const kContextPatienceMs = 4000;

const kViewKeys = { 0: "three-quarter", 1: "front", 3: "right", 7: "top" };

// In node there is no DOM: the module can be imported there, and the element not be made.
const Base = globalThis.HTMLElement ?? class {};

/**
 * `<dimline-editor model="house">`: a parametric model with dimension lines that can be dragged.
 *
 * Fills the box that the page gives it. Everything it holds (a WebAssembly instance, a WebGL context, listeners) goes when it
 * leaves the document.
 *
 * Attributes, each with a property of the same meaning:
 * - `model`: the name of a built-in model, or the URL of a .gltf or .glb
 * - `core-url` (`coreUrl`): where dimline.js lies, when not in build/ beside this file; read when the element enters a document
 *
 * Events; all bubble and leave the shadow tree:
 * - `load`: another document is shown; `error`: it could not be (an ErrorEvent; the old document stays)
 * - `input`: a value changes; `change`: once at the end of each gesture, undo or scripted change
 * - `camera-change`
 */
export class DimlineEditor extends Base {
  static observedAttributes = ["model"];

  #root;
  #internals;
  #core = null;
  #parts = null; // what #build() made
  #listening = null; // AbortController: everything that must end with the element
  #loading = null; // AbortController of the model under way
  #hasModel = false;
  #input = null;
  #labels = null;
  #pills = null;
  #ready = null; // {promise, resolve, reject}
  #settling = []; // who waits in settled()
  #frameRequest = 0;
  #lastFrameMs = 0;
  #deviceSize = null; // [width, height] in device pixels
  #drawnSize = "";
  #contextTimer = 0;
  #attempt = 0;
  #error = null;

  constructor() {
    super();
    this.#root = this.attachShadow({ mode: "open" });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(kEditorCss);
    this.#root.adoptedStyleSheets = [sheet];
    this.#internals = this.attachInternals();
    this.#internals.role = "group";
    this.#ready = makeReady();
  }

  // --- The contract ---

  /** Resolves when the core is loaded and the first frame is drawn; rejects with an Error that says why that cannot be. */
  get ready() {
    return this.#ready.promise;
  }

  get model() {
    return this.getAttribute("model") ?? "";
  }
  set model(name) {
    this.setAttribute("model", String(name));
  }

  get coreUrl() {
    return this.getAttribute("core-url") ?? "";
  }
  set coreUrl(url) {
    this.setAttribute("core-url", String(url));
  }

  /**
   * The parameters and their values. Angles are in degrees; the value of a choice is its name.
   * @returns {{name: string, title: string, help: string, type: "float" | "int" | "angle" | "bool" | "choice",
   *   value: number | boolean | string, default: number | boolean | string, min: number, max: number, step: number,
   *   unit: "m" | "deg" | "m2" | "", choices: string[], group: string, annotation: string}[]}
   */
  getParameters() {
    return this.#need().parameters();
  }

  /** Sets values by name, clamped to their ranges, as one undo step. Throws an Error on an unknown name or a wrong type. */
  setParameters(values) {
    this.#act((core) => core.setParameters(values));
  }

  /** One entry of CAMS.json: {eye, target, up, fovDeg} or, orthographic, {eye, target, up, orthoHeight}. */
  getCamera() {
    return this.#need().camera();
  }
  setCamera(camera) {
    this.#act((core) => core.setCamera(camera));
  }

  /** Resolves when fields, placement and animation have come to rest and that is drawn. */
  settled() {
    return new Promise((resolve, reject) => {
      this.#settling.push({ resolve, reject });
      this.#requestFrame();
    });
  }

  /** The frame as it is drawn now, in CSS pixels from the picture's top left. */
  layout() {
    return this.#need().layout();
  }

  undo() {
    this.#act((core) => core.undo());
  }
  redo() {
    this.#act((core) => core.redo());
  }

  // --- Beyond the contract: what a page around the element needs ---

  /** Why the editor cannot go on, which it shows by itself; null while all is well. */
  get error() {
    return this.#error;
  }

  get canUndo() {
    return this.#core?.canUndo ?? false;
  }
  get canRedo() {
    return this.#core?.canRedo ?? false;
  }

  /** The built-in models: [{name, title}]. */
  getModels() {
    return this.#need().models();
  }

  /** For sliders in motion: repeated calls are one undo step, until endContinuous(). */
  setParameterContinuous(name, value) {
    this.#act((core) => core.setParameterContinuous(name, value));
  }
  endContinuous() {
    this.#act((core) => core.endContinuous());
  }

  /** Moves the camera so that the model fills the picture. */
  fitToView() {
    this.#act((core) => core.fitToView());
  }

  /** @param {"three-quarter" | "front" | "back" | "left" | "right" | "top"} name */
  setView(name) {
    this.#act((core) => core.setStandardView(name));
  }

  get orthographic() {
    return this.#core?.orthographic ?? false;
  }
  set orthographic(on) {
    this.#act((core) => (core.orthographic = on));
  }

  /** Whether dimension lines and other handles are shown; without them there is only the picture. */
  get linesShown() {
    return this.#core?.linesShown ?? true;
  }
  set linesShown(on) {
    this.#act((core) => (core.linesShown = on));
  }

  /**
   * Handles a key that was pressed outside the element, for a page in which the editor is the main thing.
   * @returns {boolean} whether the key meant something; the event's default is prevented then
   */
  handleKey(event) {
    if (!this.#core || event.defaultPrevented || event.altKey) return false;
    const command = event.ctrlKey || event.metaKey ? this.#chord(event) : this.#plainKey(event);
    if (!command) return false;
    event.preventDefault();
    command();
    return true;
  }

  // --- For tests and measurements ---

  /** Which producer measures the fields: "auto", "cpu" or "gpu". */
  get fieldsFrom() {
    return this.#need().fieldsFrom;
  }
  set fieldsFrom(producer) {
    this.#act((core) => (core.fieldsFrom = producer));
  }
  /** The four fields, measured now: {width, height, left, right, top, bottom}, null where there is no silhouette. */
  measureFields(producer) {
    return this.#need().measureFields(producer);
  }
  timings() {
    return this.#need().timings();
  }

  // --- Life ---

  connectedCallback() {
    if (!this.#listening) this.#start();
  }

  disconnectedCallback() {
    // Moving the element within a document takes it out for a moment; only what stays out is disposed of.
    queueMicrotask(() => {
      if (!this.isConnected) this.#dispose();
    });
  }

  attributeChangedCallback(name) {
    if (name === "model" && this.#core) this.#loadModel();
  }

  async #start() {
    const listening = (this.#listening = new AbortController());
    this.#build(listening.signal);
    try {
      const gl = this.#makeContext();
      const font = loadLabelFont();
      const url = this.#coreAddress();
      const core = await createCore(url ? { url } : {});
      if (listening.signal.aborted) {
        core.dispose();
        return;
      }
      this.#core = core;
      core.attachContext(gl);
      await font;
      if (listening.signal.aborted) return;
      this.#watchSize(listening.signal);
      this.#watchMotion(listening.signal);
      if (this.model) await this.#loadModel();
      this.#drawNow();
      if (!listening.signal.aborted) this.#ready.resolve();
    } catch (error) {
      if (!listening.signal.aborted) this.#fail(error);
    }
  }

  // A browser may remember that a module's address failed; another attempt asks by a new one.
  #coreAddress() {
    const attempt = this.#attempt++;
    if (!this.coreUrl && attempt === 0) return null;
    const url = new URL(this.coreUrl || "./build/dimline.js", this.coreUrl ? document.baseURI : import.meta.url);
    if (attempt > 0) url.searchParams.set("attempt", attempt);
    return url;
  }

  #build(signal) {
    const make = (tag, className, ...children) => {
      const node = document.createElement(tag);
      if (className) node.className = className;
      node.append(...children);
      return node;
    };
    const canvas = make("canvas");
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "3D view. Drag to turn it, use the wheel to zoom, press F to fit.");
    canvas.setAttribute("part", "canvas");
    const labels = make("div", "labels");
    const pills = make("div", "pills");
    const tip = make("div", "tip");
    tip.setAttribute("aria-hidden", "true");
    const stage = make("div", "stage", canvas, make("div", "ring"), labels, pills, tip);
    const text = make("p", "heading");
    const why = make("p");
    const retry = make("button", "", "Try again");
    retry.type = "button";
    const message = make("div", "message", text, why, retry);
    message.setAttribute("role", "alert");
    message.hidden = true;
    this.#root.replaceChildren(stage, message);
    this.#parts = { canvas, stage, message, text, why, retry };

    const host = {
      core: () => this.#core,
      changed: () => this.#requestFrame(),
      guard: (call) => this.#guard(call),
      adjust: (name, value) => this.setParameterContinuous(name, value),
      endAdjusting: () => this.#core && this.endContinuous(),
      set: (name, value) => this.setParameters({ [name]: value }),
    };
    this.#input = new PointerInput(stage, canvas, host, signal);
    this.#labels = new LabelLayer(labels, tip, host, signal);
    this.#pills = new PillLayer(pills, host, signal);
    this.addEventListener("keydown", (event) => this.handleKey(event), { signal });
    canvas.addEventListener("webglcontextlost", (event) => this.#contextLost(event), { signal });
    canvas.addEventListener("webglcontextrestored", () => this.#contextRestored(), { signal });
    retry.addEventListener("click", () => this.#restart(), { signal });
  }

  #makeContext() {
    // The renderer multisamples by itself and copies the finished picture here.
    const gl = this.#parts.canvas.getContext("webgl2", {
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

  #dispose() {
    const listening = this.#listening;
    if (!listening) return;
    this.#listening = null;
    listening.abort();
    this.#loading?.abort();
    cancelAnimationFrame(this.#frameRequest);
    clearTimeout(this.#contextTimer);
    this.#frameRequest = 0;
    this.#core?.dispose();
    this.#core = null;
    // Browsers allow a page a few contexts only: this one is given back now, not when memory is next cleaned up.
    this.#parts.canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext();
    this.#root.replaceChildren();
    this.#parts = this.#input = this.#labels = this.#pills = null;
    this.#deviceSize = null;
    this.#drawnSize = "";
    this.#hasModel = false;
    this.#error = null;
    const gone = new Error("The editor left the document.");
    this.#ready.reject(gone);
    this.#ready = makeReady();
    for (const waiting of this.#settling.splice(0)) waiting.reject(gone);
  }

  #restart() {
    this.#dispose();
    this.#start();
  }

  // --- Model ---

  async #loadModel() {
    const name = this.model;
    this.#loading?.abort();
    const { signal } = (this.#loading = new AbortController());
    try {
      if (isGltfUrl(name)) {
        const { bytes, files } = await fetchGltf(new URL(name, document.baseURI).href, signal);
        if (signal.aborted || !this.#core) return;
        this.#core.setGltf(name, bytes, files);
      } else {
        this.#core.setModel(name);
      }
      this.#hasModel = true;
      this.#input.reset();
      this.#showMessage(null);
      this.#requestFrame();
    } catch (error) {
      if (signal.aborted) return;
      if (error instanceof WebAssembly.RuntimeError) return this.#fail(error);
      if (!this.#hasModel) this.#showMessage("The model cannot be shown.", error.message);
      this.dispatchEvent(
        new ErrorEvent("error", { error, message: error.message, bubbles: true, composed: true, cancelable: true }),
      );
    }
  }

  // --- Size ---

  #watchSize(signal) {
    const { stage } = this.#parts;
    const measure = (entry) => {
      const rounded = [
        Math.round(stage.clientWidth * devicePixelRatio),
        Math.round(stage.clientHeight * devicePixelRatio),
      ];
      const box = entry?.devicePixelContentBoxSize?.[0];
      const exact = box ? [box.inlineSize, box.blockSize] : rounded;
      // A browser that plays another device reports the pixels of the real one here.
      const sound = exact.every((size, i) => Math.abs(size - rounded[i]) <= Math.ceil(devicePixelRatio));
      this.#deviceSize = sound ? exact : rounded;
    };
    const observer = new ResizeObserver((entries) => {
      measure(entries.at(-1));
      // Before this frame is shown, or the emptied canvas would flash.
      this.#drawNow();
    });
    try {
      observer.observe(stage, { box: "device-pixel-content-box" });
    } catch {
      observer.observe(stage);
    }
    signal.addEventListener("abort", () => observer.disconnect());
    const watchRatio = () => {
      const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
      query.addEventListener(
        "change",
        () => {
          measure(null);
          this.#requestFrame();
          watchRatio();
        },
        { once: true, signal },
      );
    };
    watchRatio();
    measure(null);
  }

  #watchMotion(signal) {
    const query = matchMedia("(prefers-reduced-motion: reduce)");
    const tell = () => this.#core && (this.#core.reducedMotion = query.matches);
    query.addEventListener("change", tell, { signal });
    tell();
  }

  // The canvas has exactly as many pixels as the screen shows; the core is told the CSS size that goes with them.
  #applySize() {
    const { canvas } = this.#parts;
    const gl = canvas.getContext("webgl2");
    let [width, height] = this.#deviceSize;
    let ratio = devicePixelRatio;
    const limit = gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) || 4096;
    const shrink = Math.max(1, width / limit, height / limit);
    if (shrink > 1) [width, height, ratio] = [Math.floor(width / shrink), Math.floor(height / shrink), ratio / shrink];
    const size = `${width} ${height} ${ratio}`;
    if (size === this.#drawnSize) return;
    this.#drawnSize = size;
    canvas.width = width;
    canvas.height = height;
    this.#core.resize(width / ratio, height / ratio, ratio);
  }

  // --- Frames ---

  #requestFrame() {
    if (this.#frameRequest || !this.#core || !this.#deviceSize) return;
    this.#frameRequest = requestAnimationFrame((nowMs) => {
      this.#frameRequest = 0;
      this.#frame(nowMs);
    });
  }

  #drawNow() {
    if (this.#core && this.#deviceSize) this.#frame(performance.now());
  }

  #frame(nowMs) {
    this.#guard(() => {
      // A frame drawn out of turn may bear a later time than the browser's next one.
      this.#lastFrameMs = nowMs = Math.max(nowMs, this.#lastFrameMs);
      this.#applySize();
      const more = this.#core.frame(nowMs);
      if (this.#hasModel) this.#parts.canvas.toggleAttribute("data-drawn", true);
      const rests = !more && this.#core.atRest;
      const events = this.#core.takeEvents();
      if (events.some((type) => type !== "camera-change")) this.#describe();
      this.#pills.update(this.#core.pills(), devicePixelRatio);
      this.#labels.update(this.#core.labels(), devicePixelRatio, this.#input.last, this.#pills.hovered);
      if (rests) for (const waiting of this.#settling.splice(0)) waiting.resolve();
      if (more || this.#settling.length > 0) this.#requestFrame();
      for (const type of events) this.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
    });
  }

  #describe() {
    const parameters = this.#core.parameters();
    this.#labels.setParameters(parameters);
    this.#pills.setParameters(parameters);
    const title = this.#core.models().find((model) => model.name === this.model)?.title ?? this.model;
    this.#internals.ariaLabel = `${title}, with dimension lines`;
  }

  // --- Context ---

  #contextLost(event) {
    event.preventDefault(); // or it is never restored
    this.#guard(() => this.#core?.contextLost());
    this.#contextTimer = setTimeout(() => {
      this.#showMessage("The picture is gone.", "The graphics device went away and has not come back.", true);
    }, kContextPatienceMs);
  }

  #contextRestored() {
    clearTimeout(this.#contextTimer);
    this.#guard(() => {
      this.#core?.attachContext(this.#parts.canvas.getContext("webgl2"));
      this.#showMessage(null);
      this.#requestFrame();
    });
  }

  // --- Keys ---

  #plainKey(event) {
    if (event.key.toLowerCase() === "f" && !event.shiftKey) return () => this.fitToView();
    if (event.key === "5") return () => (this.orthographic = !this.orthographic);
    const view = kViewKeys[event.key];
    return view && (() => this.setView(view));
  }

  #chord(event) {
    const key = event.key.toLowerCase();
    if (key === "z") return event.shiftKey ? () => this.redo() : () => this.undo();
    if (key === "y") return () => this.redo();
    return null;
  }

  // --- Errors ---

  #need() {
    if (!this.#core) throw new Error("The editor is not ready: wait for its promise `ready` first.");
    return this.#core;
  }

  // An Error of the core is the caller's; a trap means that the core cannot go on.
  #act(call) {
    const core = this.#need();
    try {
      call(core);
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) this.#fail(error);
      throw error;
    } finally {
      this.#requestFrame();
    }
  }

  #guard(call) {
    if (!this.#core) return;
    try {
      call();
    } catch (error) {
      this.#fail(error);
    }
  }

  #fail(error) {
    const listening = this.#listening;
    this.#error = error;
    this.#core = null; // after a trap not even disposing is safe; the instance goes as a whole
    cancelAnimationFrame(this.#frameRequest);
    this.#frameRequest = 0;
    for (const waiting of this.#settling.splice(0)) waiting.reject(error);
    this.#ready.reject(error);
    if (!listening) return;
    if (error instanceof WebAssembly.RuntimeError) {
      console.error(error);
      this.#showMessage("The editor had to stop.", "There was a fault in its core.", true);
    } else {
      this.#showMessage("The editor cannot be shown.", error.message, true);
    }
    this.dispatchEvent(new ErrorEvent("error", { error, message: error.message, bubbles: true, composed: true }));
  }

  #showMessage(heading, reason = "", canRetry = false) {
    if (!this.#parts) return;
    const { message, text, why, retry } = this.#parts;
    message.hidden = !heading;
    text.textContent = heading ?? "";
    why.textContent = reason;
    retry.hidden = !canRetry;
  }
}

function makeReady() {
  const ready = {};
  ready.promise = new Promise((resolve, reject) => Object.assign(ready, { resolve, reject }));
  ready.promise.catch(() => {}); // whoever awaits it hears of it; nobody has to
  return ready;
}

// The layout measures text by the font's advance table, so that very font is loaded before the first label shows. It is added to
// the document because a shadow tree's own @font-face rules count for nothing.
async function loadLabelFont() {
  const known = [...document.fonts].find((face) => face.family.replaceAll('"', "") === kLabelFont);
  const face = known ?? new FontFace(kLabelFont, `url("${kLabelFontUrl}") format("woff2")`, { weight: "500" });
  if (!known) document.fonts.add(face);
  try {
    await face.load();
  } catch (error) {
    console.warn(`The label font could not be loaded from ${kLabelFontUrl}; labels are shown in another one.`, error);
  }
}

if (globalThis.customElements && !customElements.get("dimline-editor")) {
  customElements.define("dimline-editor", DimlineEditor);
}
