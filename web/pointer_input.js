/**
 * Turns pointer and wheel events into the core's calls. What a gesture means is the core's business; here are only the
 * browser's peculiarities: capture, coordinates, wheel units, cursors.
 */

/** The core's bits for the modifier keys of an event. */
function modifierBits(event) {
  return (event.shiftKey ? 1 : 0) | (event.ctrlKey ? 2 : 0) | (event.altKey ? 4 : 0) | (event.metaKey ? 8 : 0);
}

/** Whether an event is on a control over the picture, which handles it by itself. */
const onControl = (event) => Boolean(event.target.closest?.("[data-control]"));

// A mouse wheel's notch is 100 px in one browser and three lines in another.
const kWheelLinePx = 100 / 3;

export class PointerInput {
  #stage;
  #canvas;
  #host;
  #held = new Map(); // pointer id -> what it holds, "handle" or "camera"

  /** Where the pointer was last (CSS px in the stage) and whether it was a finger: for the tip. */
  last = { x: 0, y: 0, touch: false };

  /**
   * @param {HTMLElement} stage fills the viewport and holds canvas and labels
   * @param {HTMLCanvasElement} canvas
   * @param {{core: () => object | null, changed: () => void, guard: (call: () => void) => void}} host
   *   core: null while there is none; changed: a frame is wanted; guard: runs a call into the core
   * @param {AbortSignal} signal ends all listening
   */
  constructor(stage, canvas, host, signal) {
    this.#stage = stage;
    this.#canvas = canvas;
    this.#host = host;
    const listen = (type, listener, options) => stage.addEventListener(type, listener, { ...options, signal });
    listen("pointerdown", (event) => this.#down(event));
    listen("pointermove", (event) => this.#move(event));
    listen("pointerup", (event) => this.#up(event));
    listen("pointercancel", (event) => this.#cancelPointer(event));
    listen("lostpointercapture", (event) => this.#cancelPointer(event));
    listen("pointerleave", (event) => this.#leave(event));
    listen("wheel", (event) => this.#wheel(event), { passive: false });
    listen("contextmenu", (event) => event.preventDefault()); // the secondary button pans
    listen("mousedown", (event) => this.#mouseDown(event));
    listen("dragstart", (event) => event.preventDefault());
    listen("gesturestart", (event) => event.preventDefault()); // Safari's pinch would zoom the page
    window.addEventListener("keydown", (event) => this.#escape(event), { signal, capture: true });
  }

  /** Whether a pointer is down on the picture. */
  get active() {
    return this.#held.size > 0;
  }

  /** Lets go of everything, as when the document is replaced. */
  reset() {
    for (const id of this.#held.keys()) {
      if (this.#stage.hasPointerCapture(id)) this.#stage.releasePointerCapture(id);
    }
    this.#held.clear();
    this.#showCursor("");
  }

  #call(method, event) {
    let target = "";
    this.#host.guard(() => {
      const core = this.#host.core();
      if (!core) return;
      const [x, y] = this.#position(event);
      const kind = event.pointerType === "touch" || event.pointerType === "pen" ? event.pointerType : "mouse";
      const button = event.button > 0 && event.button < 3 ? event.button : 0;
      this.last = { x, y, touch: kind === "touch" };
      target = core[method](event.pointerId, kind, button, x, y, modifierBits(event)) ?? "";
    });
    this.#host.changed();
    return target;
  }

  // In the stage, in CSS pixels: the element may be shown scaled by a transform of the page around it.
  #position(event) {
    const rect = this.#stage.getBoundingClientRect();
    return [
      (event.clientX - rect.left) * (this.#stage.offsetWidth / rect.width || 1),
      (event.clientY - rect.top) * (this.#stage.offsetHeight / rect.height || 1),
    ];
  }

  #down(event) {
    if (onControl(event)) return;
    if (event.button > 2) return; // the mouse's back and forward
    const target = this.#call("pointerDown", event);
    this.#held.set(event.pointerId, target);
    // A pointer that a script invented cannot be captured; its gesture works without.
    try {
      this.#stage.setPointerCapture(event.pointerId);
    } catch {}
    this.#showCursor(target && `${target}-held`);
  }

  #move(event) {
    if (this.#held.has(event.pointerId)) {
      this.#call("pointerMove", event);
    } else if (onControl(event)) {
      const [x, y] = this.#position(event);
      this.last = { x, y, touch: event.pointerType === "touch" };
      this.#leave(event);
    } else if (event.pointerType !== "touch") {
      this.#showCursor(this.#call("hover", event));
    }
  }

  #up(event) {
    if (!this.#held.delete(event.pointerId)) return;
    this.#call("pointerUp", event);
    this.#showCursor(event.pointerType === "touch" ? "" : this.#call("hover", event));
  }

  #cancelPointer(event) {
    if (!this.#held.has(event.pointerId)) return;
    this.#cancelGesture();
  }

  #cancelGesture() {
    this.reset();
    this.#host.guard(() => this.#host.core()?.cancelGesture());
    this.#host.changed();
  }

  #leave(event) {
    if (this.#held.has(event.pointerId)) return;
    this.#host.guard(() => this.#host.core()?.endHover());
    this.#showCursor("");
    this.#host.changed();
  }

  #escape(event) {
    if (event.key !== "Escape" || !this.active) return;
    event.preventDefault();
    event.stopPropagation();
    this.#cancelGesture();
  }

  // A drag that begins on a label turns the view; only a double click selects its text. The middle button would scroll.
  #mouseDown(event) {
    if (onControl(event)) return;
    const onLabel = event.target !== this.#canvas;
    if (event.button === 1 || (onLabel && event.detail < 2)) {
      event.preventDefault();
      this.#canvas.focus({ preventScroll: true });
    }
  }

  #wheel(event) {
    event.preventDefault();
    const unit = event.deltaMode === 1 ? kWheelLinePx : event.deltaMode === 2 ? this.#stage.offsetHeight : 1;
    this.#host.guard(() => {
      const [x, y] = this.#position(event);
      this.#host.core()?.wheel(x, y, event.deltaY * unit, modifierBits(event));
    });
    this.#host.changed();
  }

  #showCursor(name) {
    if (name === "camera") name = "";
    if (this.#stage.dataset.cursor !== name) this.#stage.dataset.cursor = name;
  }
}
