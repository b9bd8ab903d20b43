/**
 * The WebAssembly core as JavaScript uses it: one document, one camera, one frame loop (src/app/editor.h is its manual).
 * Nothing here decides anything; values are checked, JSON becomes objects, and the core's sentences become Errors.
 *
 * Works in node too, where nothing is drawn and fields are measured on the CPU:
 *
 *     const core = await createCore();
 *     core.setModel("house");
 *     core.resize(1000, 1000, 1);
 *     while (core.frame(performance.now()) || !core.atRest) {}
 *     core.layout();
 *     core.dispose();
 */

// Each file's address stands here whole, because bundlers look for that form: they copy what it names, and put its new address there. What is not known
// before it runs must not look like that, or they warn.
const kHere = import.meta.url;
const kCore = { script: new URL("./build/dimline.js", import.meta.url), wasm: new URL("./build/dimline.wasm", import.meta.url) };
const kGltf = { script: new URL("./build/dimline_gltf.js", import.meta.url), wasm: new URL("./build/dimline_gltf.wasm", import.meta.url) };

/**
 * Loads the module and gives a core of its own, which must be disposed of. Each call is a WebAssembly instance by itself:
 * when one fails or goes, no other is touched, and its memory goes with it.
 *
 * @param {object} [options]
 * @param {string | URL} [options.url] where dimline.js lies, seen from this file, with the three other files of the build beside it; in build/ by default
 * @param {number} [options.attempt] how often that has failed before
 */
export async function createCore({ url, attempt = 0 } = {}) {
  const custom = url === undefined ? null : new URL(url, kHere);
  const beside = (name) => new URL(name, custom);
  const core = custom ? { script: custom, wasm: beside("dimline.wasm") } : kCore;
  const gltf = custom ? { script: beside("dimline_gltf.js"), wasm: beside("dimline_gltf.wasm") } : kGltf;
  return new Core(await startModule(core, attempt, "Editor"), gltf);
}

/**
 * An instance of one of the modules that the build makes; `entry` is what it must have. A browser may remember that a module's address
 * failed: another attempt asks by a new one.
 */
async function startModule({ script, wasm }, attempt, entry) {
  const url = new URL(script);
  if (attempt > 0) url.searchParams.set("attempt", attempt);
  const name = (address) => address.pathname.split("/").pop();
  let createModule;
  try {
    ({ default: createModule } = await import(/* @vite-ignore */ /* webpackIgnore: true */ String(url)));
  } catch (cause) {
    throw new Error(`${name(url)} could not be loaded from ${url}. Is it there, and the network up?`, { cause });
  }
  const isNoModule = () => new Error(`${url} is not the module of the Dimline core that should be there: it has no ${entry}.`);
  if (typeof createModule !== "function") throw isNoModule();
  let module;
  try {
    module = await createModule({ locateFile: () => String(wasm) });
  } catch (cause) {
    const refused = cause instanceof WebAssembly.CompileError || /Content Security Policy/i.test(cause?.message);
    const advice = refused ? "Does the page's policy allow 'wasm-unsafe-eval' (script-src)?" : "Is it there, and the network up?";
    throw new Error(`${name(wasm)} could not be loaded from ${wasm}, or not be started. ${advice}`, { cause });
  }
  if (!module[entry]) throw isNoModule();
  return module;
}

export class Core {
  #module;
  #editor;
  #contextHandle = 0;
  #models = null;
  #gltf;
  #gltfFailures = 0;

  /** By createCore() alone. */
  constructor(module, gltf) {
    this.#module = module;
    this.#editor = new module.Editor();
    this.#gltf = gltf;
  }

  /** Frees the document, and the GL objects when a context is attached. Nothing may be called afterwards. */
  dispose() {
    if (!this.#editor) return;
    this.detachContext();
    this.#editor.delete();
    this.#editor = null;
    this.#module = null;
  }

  // --- Document ---

  /** The built-in models, in the order in which a menu shows them: [{name, title}]. */
  models() {
    return (this.#models ??= JSON.parse(this.#module.modelsJson()));
  }

  setModel(name) {
    check(this.#editor.setModel(String(name)));
  }

  /**
   * Reads a glTF file, and changes nothing: `core.setScene(await core.readGltf("chair.glb", { bytes }))` shows it.
   *
   * What reads it, dimline_gltf.js and dimline_gltf.wasm beside dimline.js, is fetched with the first file: most visitors open none. Each file has
   * an instance to itself, so that what it does to it, and the memory that it takes, goes with it.
   *
   * @param {string} name for messages
   * @param {{bytes: Uint8Array, files?: Record<string, Uint8Array>} | Promise} document the .gltf or .glb, and what a .gltf names by relative URI, or a
   *   promise of both, as gltf_files.js gives it
   * @param {(sentence: string) => void} [noted] is told of each thing in the file that the scene leaves out, such as a picture that cannot be read; the
   *   console is, without it
   * @returns {Promise<Uint8Array>} the scene; rejects with an Error that says what is wrong with the file
   */
  async readGltf(name, document, noted = (sentence) => console.warn(`${name}: ${sentence}`)) {
    const [reader, { bytes, files }] = await Promise.all([this.#startGltfReader(), document]);
    let result;
    try {
      result = reader.importGltf(String(name), bytes, files);
    } catch (cause) {
      throw new Error(`${name} could not be read, perhaps for want of memory: ${cause.message}.`, { cause });
    }
    check(result.error);
    result.notes.forEach((sentence) => noted(sentence));
    return result.scene;
  }

  async #startGltfReader() {
    try {
      return await startModule(this.#gltf, this.#gltfFailures, "importGltf");
    } catch (error) {
      ++this.#gltfFailures;
      throw error;
    }
  }

  /** Replaces the document by a scene that readGltf() gave. */
  setScene(scene) {
    check(this.#editor.setScene(scene));
  }

  parameters() {
    return JSON.parse(this.#editor.parametersJson());
  }

  /** One undo step for all values together. */
  setParameters(values) {
    check(this.#editor.setParametersJson(jsonOf(values)));
  }

  /** The document begins anew, with these values in place of its defaults: its camera too, and there is nothing to undo. */
  beginWith(values) {
    check(this.#editor.beginWithJson(jsonOf(values)));
  }

  /** As setParameters for one value in motion: repeated calls are one undo step until endContinuous(). */
  setParameterContinuous(name, value) {
    checkValue(name, value);
    check(this.#editor.setParameterContinuous(String(name), JSON.stringify(value)));
  }

  endContinuous() {
    this.#editor.endContinuous();
  }

  /** The default value again, as one undo step. */
  resetParameter(name) {
    check(this.#editor.resetParameter(String(name)));
  }

  /**
   * The value that a visitor's text means, in the parameter's own unit; neither clamped to its range nor snapped to its step. Arithmetic,
   * units and decimal commas are read: src/editing/value_text.h is the manual. Throws an Error with a sentence for the visitor.
   */
  parseValue(name, text) {
    const { value, error } = JSON.parse(this.#editor.parseValueJson(String(name), String(text)));
    check(error);
    return value;
  }

  /** The text with which an edit field starts: the present value to its last digit, with its unit. Empty for no such parameter. */
  inputText(name) {
    return this.#editor.inputText(String(name));
  }

  /** How numbers are written in labels and texts: decimal is "." or ",". */
  setNumberFormat({ decimal }) {
    check(this.#editor.setDecimalMark(String(decimal)));
  }

  /** Values that follow from others and are only read: [{name, title, help, unit, value, text}]. */
  measures() {
    return JSON.parse(this.#editor.measuresJson());
  }

  /** Whether the measures' lines are shown too. At the start they are not. */
  get measuresShown() {
    return this.#editor.measuresShown();
  }
  set measuresShown(on) {
    this.#editor.setMeasuresShown(Boolean(on));
  }

  undo() {
    this.#editor.undo();
  }
  redo() {
    this.#editor.redo();
  }
  get canUndo() {
    return this.#editor.canUndo();
  }
  get canRedo() {
    return this.#editor.canRedo();
  }

  // --- Viewport and camera ---

  resize(widthCss, heightCss, devicePixelRatio) {
    this.#editor.resize(widthCss, heightCss, devicePixelRatio);
  }

  camera() {
    return JSON.parse(this.#editor.cameraJson());
  }

  setCamera(camera) {
    if (camera === null || typeof camera !== "object" || Array.isArray(camera)) {
      throw new Error('A camera is an object such as {"eye": [10, 8, 14], "target": [0, 3, 0], "fovDeg": 35}.');
    }
    check(this.#editor.setCameraJson(JSON.stringify(camera)));
  }

  fitToView() {
    this.#editor.fitToView();
  }

  /** @param {"three-quarter" | "front" | "back" | "left" | "right" | "top"} name */
  setStandardView(name) {
    check(this.#editor.setStandardView(String(name)));
  }

  get orthographic() {
    return this.#editor.isOrthographic();
  }
  set orthographic(on) {
    this.#editor.setOrthographic(Boolean(on));
  }

  // --- Input; positions in CSS pixels from the canvas's top left. What it takes hold of: "handle", "camera" or "". Modifiers are the sum of
  // 1 for shift, 2 for control, 4 for alt and 8 for command ---

  pointerDown(id, kind, button, x, y, modifiers) {
    return this.#editor.pointerDown(id, kind, button, x, y, modifiers);
  }
  /** Values follow with the next frame, or when a pointer goes up. */
  pointerMove(id, kind, button, x, y, modifiers) {
    return this.#editor.pointerMove(id, kind, button, x, y, modifiers);
  }
  pointerUp(id, kind, button, x, y, modifiers) {
    this.#editor.pointerUp(id, kind, button, x, y, modifiers);
  }
  /**
   * The handles that are being dragged, one by each pointer, in the order in which they were taken hold of: [{id: the pointer's, parameter,
   * kind: "line" | "arc", value, text, difference, limit: null | "min" | "max", handle: [x, y], direction: [dx, dy],
   * pointer: "mouse" | "touch" | "pen", snap: "step" | "fine" | "none"}]. Shift makes steps fine, alt takes them away; when a key changes while the
   * pointer rests, call pointerMove with the pointer where it is.
   */
  gestures() {
    return JSON.parse(this.#editor.gesturesJson());
  }

  /** The name of the parameter whose handle or label is there, or null. */
  handleAt(x, y, kind = "mouse") {
    return this.#editor.handleAt(x, y, kind) || null;
  }

  /** How much of the last frame a box over the picture would hide, in px² of written numbers: src/app/cover_cost.h is the manual. */
  coverCost([x0, y0, x1, y1]) {
    return this.#editor.coverCost(x0, y0, x1, y1);
  }

  hover(id, kind, button, x, y, modifiers) {
    return this.#editor.hover(id, kind, button, x, y, modifiers);
  }
  endHover() {
    this.#editor.endHover();
  }
  cancelGesture() {
    this.#editor.cancelGesture();
  }
  /** The browser took this pointer away: what it was doing is undone; what others do goes on. */
  cancelPointer(id) {
    this.#editor.cancelPointer(id);
  }
  wheel(x, y, deltaPx, modifiers) {
    this.#editor.wheel(x, y, deltaPx, modifiers);
  }

  // --- Frames ---

  /** Draws into this context from now on. A context that was attached before is let go. */
  attachContext(gl) {
    this.detachContext();
    const { GL } = this.#module;
    // The renderer needs nothing beyond WebGL 2. Emscripten would switch on every extension that it has heard of, and wait for the driver at each.
    this.#contextHandle = GL.registerContext(gl, { majorVersion: 2, minorVersion: 0, enableExtensionsByDefault: false });
    GL.makeContextCurrent(this.#contextHandle);
    const sentence = this.#editor.attachContext(this.#contextHandle);
    if (sentence) this.#forgetContext();
    check(sentence);
  }

  /** The context lives and is about to go: its objects are deleted. */
  detachContext() {
    if (!this.#contextHandle) return;
    this.#editor.detachContext();
    this.#forgetContext();
  }

  /** The context died, and its objects with it. */
  contextLost() {
    if (!this.#contextHandle) return;
    this.#editor.contextLost();
    this.#forgetContext();
  }

  #forgetContext() {
    this.#module.GL.deleteContext(this.#contextHandle);
    this.#contextHandle = 0;
  }

  /** Why the last frame could not be drawn as it should, in a sentence; empty when all is well. */
  get problem() {
    return this.#editor.problem();
  }

  /** Advances to the time and draws; true when another frame is wanted. */
  frame(nowMs) {
    return this.#editor.frame(nowMs);
  }
  /** Nothing moves any more, and the lines have settled: when a pointer let go of the camera, or a third of a second after it was moved otherwise. */
  get atRest() {
    return this.#editor.atRest();
  }

  /** For people who asked their system for less motion: lines change place at once. */
  set reducedMotion(on) {
    this.#editor.setReducedMotion(Boolean(on));
  }

  /** Whether lines and other handles are drawn over the picture. */
  get linesShown() {
    return this.#editor.linesShown();
  }
  set linesShown(on) {
    this.#editor.setLinesShown(Boolean(on));
  }

  /** While true, parameters that are hidden as occluded, too short, foreshortened or crowded are shown as well. */
  get hiddenShown() {
    return this.#editor.hiddenShown();
  }
  set hiddenShown(on) {
    this.#editor.setHiddenShown(Boolean(on));
  }

  layout() {
    return JSON.parse(this.#editor.layoutJson());
  }

  /** What the DOM shows over the picture, as the last frame has it. */
  labels() {
    return JSON.parse(this.#editor.labelsJson());
  }

  /** The switches and choices that the DOM shows over the picture, as the last frame has them. */
  pills() {
    return JSON.parse(this.#editor.pillsJson());
  }

  /** What happened since the last call, in order: "input", "change", "camera-change", "load". An "input" or a "camera-change" that is followed by another stands for both. */
  takeEvents() {
    return JSON.parse(this.#editor.eventsJson());
  }

  // --- For tests and measurements ---

  /** Which producer measures the fields: "auto", "cpu" or "gpu". */
  get fieldsFrom() {
    return this.#editor.fieldsFrom();
  }
  set fieldsFrom(producer) {
    check(this.#editor.setFieldsFrom(String(producer)));
  }

  /** The four fields of the camera at hand, measured now by "cpu" or "gpu"; blocks. Null when that producer is not to be had. */
  measureFields(producer) {
    return JSON.parse(this.#editor.fieldsJson(String(producer)));
  }

  timings() {
    return JSON.parse(this.#editor.timingsJson());
  }
}

function check(sentence) {
  if (sentence) throw new Error(sentence);
}

function jsonOf(values) {
  // Of a Map, an array or a promise the entries are not the names and values.
  const kind = Object.prototype.toString.call(values).slice(8, -1);
  if (kind !== "Object") {
    throw new Error(`Parameters are set by an object of names and values, as in {"Width": 9}, not by ${kind}.`);
  }
  for (const [name, value] of Object.entries(values)) checkValue(name, value);
  return JSON.stringify(values);
}

// JSON has no NaN and no undefined: they are caught here, where the name is known.
function checkValue(name, value) {
  const usable =
    typeof value === "string" || typeof value === "boolean" || (typeof value === "number" && Number.isFinite(value));
  if (!usable) {
    const shown = typeof value === "object" && value !== null ? "an object" : String(value);
    throw new Error(
      `Parameter "${name}" cannot be ${shown}: give a finite number, true or false, or the name of a choice.`,
    );
  }
}
