import { cameraMoveOf } from "./camera_keys.js";
import { CanvasSize } from "./canvas_size.js";
import { createCore } from "./core.js";
import { make } from "./dom.js";
import { commandOf, isTyped } from "./editor_keys.js";
import { EditorMessage } from "./editor_message.js";
import { kEditorCss } from "./editor_style.js";
import { absoluteUrl, fetchGltf, isGltfUrl } from "./gltf_files.js";
import { makeContext, watchContext } from "./graphics_context.js";
import { loadLabelFont } from "./label_font.js";
import { decimalMark } from "./numbers.js";
import { Overlay } from "./overlay.js";
import { PointerInput } from "./pointer_input.js";
import { changeSentence, hiddenSentence } from "./spoken.js";
import { makeDeferred, Waiting } from "./waiting.js";

// In node there is no DOM: the module can be imported there, and the element not be made.
const Base = globalThis.HTMLElement ?? class {};

// Two frames of most screens.
const kLateMs = 34;

/** The context, or else the core that is coming is let go when it comes. */
function makeContextBefore(coming, canvas) {
  try {
    return makeContext(canvas);
  } catch (error) {
    coming.then((core) => core.dispose(), () => {});
    throw error;
  }
}

/**
 * `<dimline-editor model="house">`: a parametric model with dimension lines that can be dragged.
 *
 * Fills the box that the page gives it. Everything it holds (a WebAssembly instance, a WebGL context, listeners) goes when it
 * leaves the document.
 *
 * Attributes, the first four with a property of the same meaning:
 * - `model`: the name of a built-in model, or the URL of a .gltf or .glb
 * - `initial-values` (`initialValues`): what a model begins with where that is not its defaults, as in '{"Width": 9}'; read when a model is loaded, so for
 *   another model it is given anew, before or after `model` but in the same task
 * - `core-url` (`coreUrl`): where dimline.js lies, seen from the page, when not in build/ beside this file; read when the element enters a document
 * - `lang`: the language in whose manner numbers are written, as in "9,40 m"; the visitor's own by default
 * - `wheel`: "ctrl" makes the wheel zoom only while Ctrl or the command key is held (a pinch on a track pad counts as that) and scroll the page otherwise;
 *   without it, it always zooms
 * - `touch-action`: "pan-y" lets a finger that moves up or down scroll the page, when it comes down on no arrow; sideways it turns the model, and two
 *   fingers are the picture's. Without it, all fingers are
 *
 * Events; all but `error` bubble and leave the shadow tree:
 * - `load`: another document is shown; `error`: it could not be, and the old one stays, or not with its initial values (an ErrorEvent, which
 *   stays with the element: at the window it would count as a fault of the page's scripts)
 * - `input`: a value changes; `change`: once at the end of each gesture, undo or scripted change
 * - `camera-change`
 */
export class DimlineEditor extends Base {
  static observedAttributes = ["model", "lang"];

  #root;
  #internals;
  #core = null;
  #parts = null; // what #build() made
  #listening = null; // AbortController: everything that must end with the element
  #loading = null; // {controller, done}: how to abort the model under way, which was asked for last, and the promise of its end
  #shown = null; // the name of the model that is shown
  #refusal = null; // why the model that was asked for last could not be had
  #initialValues = null; // as the property was given
  #resuming = null; // {model, values, camera}: what another attempt goes on with
  #input = null;
  #overlay = null;
  #peeking = false; // the key that shows hidden lines is down
  #hiddenShown = false;
  #linesShown = true;
  #measuresShown = false;
  #mark = ".";
  #ready = makeDeferred();
  #settling = new Waiting();
  #frameRequest = 0;
  #lastFrameMs = 0;
  #size = null; // CanvasSize
  #failures = 0; // of the core to start, one after the other
  #problem = null; // the core's, as it is shown; null before the first picture
  #error = null;

  constructor() {
    super();
    this.#root = this.attachShadow({ mode: "open" });
    this.#dress();
    this.#internals = this.attachInternals();
    this.#internals.role = "group";
  }

  // --- The contract ---

  /**
   * Resolves when the core is loaded and the first frame is drawn; rejects with an Error that says why that cannot be, as when the model that was asked for
   * cannot be had. The element can still be given another one then: `load` tells when it is shown.
   */
  get ready() {
    return this.#ready.promise;
  }

  get model() {
    return this.getAttribute("model") ?? "";
  }
  set model(name) {
    if (name === null || name === undefined) this.removeAttribute("model");
    else this.setAttribute("model", String(name));
  }

  /**
   * What a model begins with when it is loaded, in place of its defaults: saved values, say. An object of names and values, a function that makes
   * one of the new model's getParameters(), or null. Where a value cannot be had, the model is shown with its defaults, and an `error` event says why.
   * What is set here comes before the attribute.
   */
  get initialValues() {
    if (this.#initialValues !== null) return this.#initialValues;
    try {
      return JSON.parse(this.getAttribute("initial-values") ?? "null");
    } catch (cause) {
      throw new Error(`The attribute initial-values is not JSON, as in '{"Width": 9}': ${cause.message}.`, { cause });
    }
  }
  set initialValues(values) {
    this.#initialValues = values ?? null;
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
   *   value: number | boolean | string, default: number | boolean | string, min: number | null, max: number | null, step: number | null,
   *   unit: "m" | "deg" | "m2" | "", choices: string[], group: string, annotation: string}[]}
   */
  getParameters() {
    return this.#need().parameters();
  }

  /** Sets values by name, clamped to their ranges, as one undo step. Throws an Error on an unknown name or a wrong type. */
  setParameters(values) {
    this.#act((core) => core.setParameters(values));
  }

  /** {eye, target, up, fovDeg} or, orthographic, {eye, target, up, orthoHeight}: points and directions as [x, y, z], in metres. */
  getCamera() {
    return this.#need().camera();
  }
  setCamera(camera) {
    this.#act((core) => core.setCamera(camera));
  }

  /** Resolves when fields, placement and animation have come to rest and that is drawn. After a camera that `setCamera()`, a wheel or keys moved that is a third of a second later at least: only then do the lines settle. */
  settled() {
    if (this.#error) return Promise.reject(this.#error);
    const settled = this.#settling.join();
    this.#requestFrame();
    return settled;
  }

  /** The frame as it is drawn now, in CSS pixels from the picture's top left. */
  layout() {
    return this.#need().layout();
  }

  undo() {
    this.#travel("Undone", (core) => core.undo());
  }
  redo() {
    this.#travel("Redone", (core) => core.redo());
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
    return this.#linesShown;
  }
  set linesShown(on) {
    this.#linesShown = Boolean(on);
    this.#showLines();
  }

  /**
   * Handles a key that was pressed outside the element, for a page in which the editor is the main thing. What is typed into the page's own fields is left alone,
   * and while a handle is dragged so is all that would move the picture under the hand.
   * @returns {boolean} whether the key meant something; the event's default is prevented then
   */
  handleKey(event) {
    if (!this.#core || event.defaultPrevented || (isTyped(event) && !this.contains(event.target))) return false;
    const escape = event.key === "Escape" && this.#overlay.giveUpTyping();
    const command = escape ? () => {} : commandOf(event, this, () => this.#peek(true));
    if (!command) return false;
    event.preventDefault();
    command();
    return true;
  }

  /** Whether lines that are hidden for want of room, or because their feature is, are shown too. */
  get hiddenShown() {
    return this.#hiddenShown;
  }
  set hiddenShown(on) {
    this.#hiddenShown = Boolean(on);
    this.#showHidden();
  }

  /**
   * Marks the line of a parameter and what it drives, as a mouse on it would, for a control outside the picture that sets it; until another call, or until a
   * mouse is moved over the picture. Null for none.
   */
  pointAt(name) {
    this.#overlay?.pointAt(name);
  }

  /** What follows from the parameters and is measured, not set: [{name, title, help, unit, value, text}]. */
  getMeasures() {
    return this.#core?.measures() ?? [];
  }

  /** Whether measures are shown in the picture, as lines without handles. */
  get measuresShown() {
    return this.#measuresShown;
  }
  set measuresShown(on) {
    this.#measuresShown = Boolean(on);
    this.#showLines();
  }

  /** The mark between whole numbers and fractions: "." or ",". */
  get decimalMark() {
    return this.#mark;
  }

  /** What a visitor means by a text such as 10'6" or 3*1.2m, a number in the parameter's unit, or by the name of a choice; throws an Error for the visitor. */
  parseValue(name, text) {
    return this.#need().parseValue(name, text);
  }

  /** The drags of handles that are under way: see Core.gestures(). */
  get gestures() {
    return this.#core?.gestures() ?? [];
  }

  /** Back to its default, as one undo step. */
  resetParameter(name) {
    this.#act((core) => core.resetParameter(name));
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
    this.#upgradeProperties();
    if (!this.#listening) this.#start();
  }

  // What a page has set before this class was known lies before its accessors. Some of it needs the core.
  #upgradeProperties() {
    const forCore = ["orthographic", "fieldsFrom"];
    for (const name of ["model", "coreUrl", "initialValues", "linesShown", "measuresShown", "hiddenShown", ...forCore]) {
      if (!Object.hasOwn(this, name)) continue;
      const value = this[name];
      delete this[name];
      const assign = () => (this[name] = value);
      if (forCore.includes(name)) this.ready.then(() => this.#try(assign), () => {});
      else assign();
    }
  }

  // Another document, as of a frame: style sheets, fonts and listeners belong to the one before.
  adoptedCallback() {
    this.#dispose();
    this.#dress();
  }

  #dress() {
    const { CSSStyleSheet: Sheet } = this.ownerDocument.defaultView ?? globalThis;
    const sheet = new Sheet();
    sheet.replaceSync(kEditorCss);
    this.#root.adoptedStyleSheets = [sheet];
  }

  disconnectedCallback() {
    // Moving the element within a document takes it out for a moment; only what stays out is disposed of.
    queueMicrotask(() => {
      if (!this.isConnected) this.#dispose();
    });
  }

  attributeChangedCallback(name) {
    if (name === "model") this.#resuming = null; // that was another one
    if (!this.#core || !this.#size) return; // #start() comes to it
    if (name === "model") this.#load(this.model);
    if (name === "lang") this.#act(() => this.#applyLanguage());
  }

  async #start() {
    const listening = (this.#listening = new AbortController());
    this.#build(listening.signal);
    try {
      const url = this.#coreAddress();
      // Making a context can take long, and the core's files come in meanwhile.
      const coming = createCore({ url, attempt: this.#failures });
      const font = loadLabelFont(this.ownerDocument);
      const size = new CanvasSize(
        this.#parts.stage,
        this.#parts.canvas,
        { resized: () => this.#drawNow(), stale: () => this.#requestFrame() },
        listening.signal,
      );
      const gl = makeContextBefore(coming, this.#parts.canvas);
      const core = await coming;
      this.#failures = 0;
      if (listening.signal.aborted) {
        core.dispose();
        return;
      }
      this.#core = core;
      if (!gl.isContextLost()) core.attachContext(gl); // or else when it comes back
      await font;
      if (listening.signal.aborted) return;
      this.#size = size;
      this.#watchMotion(listening.signal);
      this.#applyLanguage();
      this.#showHidden();
      this.#showLines();
      window.addEventListener("languagechange", () => this.#guard(() => this.#applyLanguage()), listening);
      this.#load(this.#resuming?.model ?? this.model);
      while (this.#loading) await this.#loading.done;
      this.#drawNow();
      if (this.#core?.problem) throw new Error(this.#core.problem);
      this.#problem = "";
      if (listening.signal.aborted) return;
      if (this.#shown === null && this.#refusal) this.#ready.reject(this.#refusal);
      else this.#ready.resolve();
    } catch (error) {
      if (listening.signal.aborted) return;
      if (!this.#core) ++this.#failures;
      this.#fail(error);
    }
  }

  #coreAddress() {
    const given = this.coreUrl;
    return given ? absoluteUrl(given, document.baseURI, `The attribute core-url is no address: "${given}".`) : undefined;
  }

  #build(signal) {
    const canvas = make("canvas", {
      tabindex: "0",
      role: "application",
      "aria-label": "3D view. Drag or press arrow keys to turn it, with Shift to move it; wheel, plus and minus zoom, F fits.",
      part: "canvas",
    });
    const stage = make("div", { class: "stage" }, canvas, make("div", { class: "ring" }));
    const message = new EditorMessage(() => this.#restart(), signal);
    this.#root.replaceChildren(stage, message.node);
    this.#parts = { canvas, stage, message };

    const host = {
      core: () => this.#core,
      act: (call) => this.#act(call),
      changed: () => this.#requestFrame(),
      guard: (call) => this.#guard(call),
      wheelZooms: (event) => this.getAttribute("wheel") !== "ctrl" || event.ctrlKey || event.metaKey,
      pointed: () => this.#overlay.pointed(),
      cursorAt: (x, y, onHandle) => this.#overlay.cursorAt(x, y, onHandle),
      tapped: (tap) => this.#overlay.tapped(tap),
      doubleTapped: (tap) => this.#overlay.doubleTapped(tap),
    };
    this.#input = new PointerInput(stage, canvas, host, signal);
    this.#overlay = new Overlay(stage, host, signal);
    this.addEventListener("keydown", (event) => this.handleKey(event), { signal });
    canvas.addEventListener("keydown", (event) => this.#turnByKey(event), { signal });
    const endPeeking = (event) => (event.type === "blur" || event.key?.toLowerCase() === "h") && this.#peek(false);
    window.addEventListener("keyup", endPeeking, { signal, capture: true });
    window.addEventListener("blur", endPeeking, { signal });
    watchContext(
      canvas,
      {
        lost: () => this.#guard(() => this.#core?.contextLost()),
        missed: () =>
          this.#parts?.message.show("The picture is gone.", "The graphics device went away and has not come back.", true),
        restored: () => this.#contextRestored(),
      },
      signal,
    );
    // Only the keyboard's way here shows a ring: a browser would draw one too when Shift is pressed during a drag.
    canvas.addEventListener("focus", () => canvas.toggleAttribute("data-ring", canvas.matches(":focus-visible")), { signal });
    canvas.addEventListener("blur", () => canvas.removeAttribute("data-ring"), { signal });
    stage.addEventListener("pointerdown", () => canvas.removeAttribute("data-ring"), { signal });
  }

  #turnByKey(event) {
    const move = cameraMoveOf(event, this.#parts.stage);
    if (!move || this.#input.active) return;
    event.preventDefault();
    this.#act(move);
  }

  #dispose() {
    const listening = this.#listening;
    if (!listening) return;
    this.#listening = null;
    listening.abort();
    this.#abortLoading();
    cancelAnimationFrame(this.#frameRequest);
    this.#frameRequest = 0;
    this.#core?.dispose();
    this.#core = null;
    // Browsers allow a page a few contexts only: this one is given back now, not when memory is next cleaned up.
    this.#parts.canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext();
    this.#root.replaceChildren();
    this.#parts = this.#input = this.#overlay = null;
    this.#peeking = false;
    this.#size = null;
    this.#shown = null;
    this.#error = this.#refusal = this.#problem = null;
    const gone = new Error("The editor left the document.");
    this.#ready.reject(gone);
    this.#ready = makeDeferred();
    this.#settling.reject(gone);
  }

  // A core that has lost its picture goes on where it was; after a fault nobody knows what that is worth.
  #restart() {
    const core = this.#shown === null ? null : this.#core;
    const valuesOf = (parameters) => Object.fromEntries(parameters.map(({ name, value }) => [name, value]));
    this.#resuming = core && { model: this.#shown, values: valuesOf(core.parameters()), camera: core.camera() };
    this.#dispose();
    this.#start();
  }

  // --- Model ---

  // Without a name there is nothing to load, and what is shown stays.
  #load(name) {
    this.#abortLoading();
    if (!name) return;
    const controller = new AbortController();
    const done = this.#loadModel(name, controller.signal).finally(() => {
      if (controller.signal.aborted) return;
      this.#loading = null;
      this.#requestFrame(); // who waits until all is settled waits for this too
    });
    this.#loading = { controller, done };
  }

  #abortLoading() {
    this.#loading?.controller.abort();
    this.#loading = null;
  }

  async #loadModel(name, signal) {
    await null; // who sets the model may go on to say what it begins with
    if (signal.aborted || !this.#core) return;
    try {
      if (isGltfUrl(name)) {
        const scene = await this.#core.readGltf(name, fetchGltf(absoluteUrl(name, document.baseURI, `"${name}" is no address of a glTF file.`).href, signal));
        if (signal.aborted || !this.#core) return;
        this.#core.setScene(scene);
      } else {
        this.#core.setModel(name);
      }
      this.#shown = name;
      this.#refusal = null;
      this.#input.reset();
      this.#overlay.clear();
      if (!this.#contextIsLost()) this.#parts.message.hide();
      this.#requestFrame();
      this.#begin();
    } catch (cause) {
      if (signal.aborted) return;
      const error = cause instanceof Error ? cause : new Error(`The model could not be loaded: ${cause}.`, { cause });
      if (error instanceof WebAssembly.RuntimeError) return this.#fail(error);
      this.#refusal = error;
      if (this.#shown === null) this.#parts?.message.show("The model cannot be shown.", error.message);
      this.#tellError(error);
    }
  }

  // Before the first frame, so that nothing else is seen.
  #begin() {
    const resuming = this.#resuming;
    this.#resuming = null;
    if (resuming?.model === this.#shown) {
      this.#core.beginWith(resuming.values);
      this.#core.setCamera(resuming.camera);
      return;
    }
    const first = this.initialValues;
    const values = typeof first === "function" ? first(this.#core.parameters()) : first;
    if (values !== null && values !== undefined) this.#core.beginWith(values);
  }

  #watchMotion(signal) {
    const query = matchMedia("(prefers-reduced-motion: reduce)");
    const tell = () => this.#core && (this.#core.reducedMotion = query.matches);
    query.addEventListener("change", tell, { signal });
    tell();
  }

  // --- Frames ---

  #requestFrame() {
    if (this.#frameRequest || !this.#core || !this.#size) return;
    this.#frameRequest = requestAnimationFrame((frameMs) => {
      this.#frameRequest = 0;
      // The browser's time of a frame lies far back when something has kept it waiting, and what is timed by it would be over at once.
      const nowMs = performance.now();
      this.#frame(nowMs - frameMs < kLateMs ? frameMs : nowMs);
    });
  }

  #drawNow() {
    if (this.#core && this.#size) this.#frame(performance.now());
  }

  #frame(nowMs) {
    this.#guard(() => {
      // A frame drawn out of turn may bear a later time than the browser's next one.
      this.#lastFrameMs = nowMs = Math.max(nowMs, this.#lastFrameMs);
      const gl = this.#parts.canvas.getContext("webgl2");
      this.#size.apply(gl, (width, height, ratio) => this.#core.resize(width, height, ratio));
      const more = this.#core.frame(nowMs);
      this.#showProblem(this.#core.problem);
      if (this.#shown !== null) this.#parts.canvas.toggleAttribute("data-drawn", true);
      const rests = !more && this.#core.atRest;
      const events = this.#core.takeEvents();
      if (events.some((type) => type !== "camera-change")) this.#describe();
      this.#overlay.update(this.#core, this.#input, rests);
      // What the overlay has asked for, such as the mark of a line, comes with another frame.
      const isSettled = rests && !this.#loading && this.#frameRequest === 0;
      if (isSettled) this.#settling.resolve();
      if (more || (!rests && this.#settling.any)) this.#requestFrame();
      for (const type of events) this.dispatchEvent(new Event(type, { bubbles: true, composed: true }));
    });
  }

  // The driver may refuse a picture at any time, as when it has become too large, and take the next one.
  #showProblem(problem) {
    if (this.#problem === null || problem === this.#problem) return;
    this.#problem = problem;
    if (!problem) return this.#parts.message.hide();
    this.#parts.message.show("The picture cannot be drawn.", problem);
    this.#tellError(new Error(problem));
  }

  #describe() {
    this.#overlay.describe(this.#core.parameters(), this.#core.measures(), this.#mark);
    const title = this.#core.models().find((model) => model.name === this.#shown)?.title ?? this.#shown;
    this.#internals.ariaLabel = `${title}, with dimension lines`;
  }

  // --- What is shown, and in whose manner ---

  #peek(on) {
    if (this.#peeking === on) return;
    this.#peeking = on;
    this.#showHidden();
  }

  #showHidden() {
    const shown = this.#peeking || this.#hiddenShown;
    if (!this.#core || this.#core.hiddenShown === shown) return;
    this.#act((core) => {
      if (shown && this.#shown !== null) this.#sayWhatIsHidden(core.layout().hidden);
      core.hiddenShown = shown;
    });
  }

  #sayWhatIsHidden(hidden) {
    const count = hidden.filter(({ reason }) => reason !== "out-of-view" && reason !== "no-scope").length;
    // What comes into view is seen by those who see.
    if (count > 0) this.#overlay.announce(hiddenSentence(count));
    else this.#overlay.say(null, hiddenSentence(count));
  }

  #showLines() {
    if (!this.#core) return;
    this.#act((core) => {
      core.linesShown = this.#linesShown;
      core.measuresShown = this.#measuresShown;
    });
  }

  #applyLanguage() {
    this.#mark = decimalMark([...(this.lang ? [this.lang] : []), ...navigator.languages]);
    this.#core.setNumberFormat({ decimal: this.#mark });
    if (this.#shown !== null) this.#describe();
    this.#requestFrame();
  }

  // --- Context ---

  #contextIsLost() {
    return this.#parts.canvas.getContext("webgl2")?.isContextLost() ?? false;
  }

  #contextRestored() {
    this.#guard(() => {
      this.#core?.attachContext(this.#parts.canvas.getContext("webgl2"));
      this.#parts.message.hide();
      this.#requestFrame();
    });
  }

  // --- Errors ---

  #need() {
    if (this.#error) throw this.#error;
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

  // Through the history, and tells those who cannot see it what that has changed.
  #travel(word, call) {
    this.#act((core) => {
      const before = core.parameters();
      call(core);
      this.#overlay.announce(changeSentence(word, before, core.parameters(), this.#mark));
    });
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
    this.#settling.reject(error);
    this.#ready.reject(error);
    if (!listening) return;
    if (error instanceof WebAssembly.RuntimeError) {
      console.error(error);
      this.#parts.message.show("The editor had to stop.", "There was a fault in its core.", true);
    } else {
      this.#parts.message.show("The editor cannot be shown.", error.message, true);
    }
    this.#tellError(error);
  }

  // What nobody waits for has nobody to throw to.
  #try(call) {
    try {
      call();
    } catch (error) {
      this.#tellError(error);
    }
  }

  #tellError(error) {
    this.dispatchEvent(new ErrorEvent("error", { error, message: error.message }));
  }
}

if (globalThis.customElements && !customElements.get("dimline-editor")) {
  customElements.define("dimline-editor", DimlineEditor);
}
