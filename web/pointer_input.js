/**
 * Turns pointer and wheel events into the core's calls. What a gesture means is the core's business; here are only the
 * browser's peculiarities: capture, coordinates, wheel units, cursors, and what is a tap or a double one.
 */

import { cursorAlong } from "./cursors.js";

/** The core's bits for the modifier keys of an event. */
function modifierBits(event) {
  return (event.shiftKey ? 1 : 0) | (event.ctrlKey ? 2 : 0) | (event.altKey ? 4 : 0) | (event.metaKey ? 8 : 0);
}

// What `buttons` says of each button while it is down.
const kDown = [1, 4, 2];

const kindOf = ({ pointerType }) => (pointerType === "touch" || pointerType === "pen" ? pointerType : "mouse");

/** Whether an event is on a control over the picture, which handles it by itself. */
const onControl = (event) => Boolean(event.target.closest?.("[data-control]"));

/** Whether it is a finger's on one that takes nothing but taps: what else the finger does there, it does to the picture. */
const onTapControl = (event) => event.pointerType === "touch" && Boolean(event.target.closest?.('[data-control="tap"]'));

// A mouse wheel's notch is 100 px in one browser and three lines in another.
const kWheelLinePx = 100 / 3;

// How far a pointer may stray (px) and how long it may stay (ms) for a press to be a tap, and how soon and how near a second tap
// makes it a double one. Fingers tremble and come back beside where they were.
const kTap = { strayPx: 4, ms: 700, doubleMs: 450, doublePx: 6 };
const kFingerTap = { strayPx: 10, ms: 500, doubleMs: 450, doublePx: 28 };

export class PointerInput {
  #stage;
  #canvas;
  #host;
  #held = new Map(); // pointer id -> {target: "handle" | "camera" | "", kind, button, at: [x, y], x, y, ms, still}: what it holds, by which button, where it is, and where that began
  #resting = new Map(); // pointer id -> the event with which a finger came down on a control that takes taps, and may yet be the picture's
  #taken = new Set(); // ids of those that have become the picture's since a finger came down alone: they click nothing
  #tapped = null; // {x, y, ms, touch, target}: the press that has just ended, if it was a tap
  #before = null; // the tap before it

  /** Where the pointer was last (CSS px in the stage) and whether it was a finger: for the tip. */
  last = { x: 0, y: 0, touch: false };

  /**
   * @param {HTMLElement} stage fills the viewport and holds canvas and labels
   * @param {HTMLCanvasElement} canvas
   * @param {object} host
   *   core(): null while there is none
   *   changed(): a frame is wanted
   *   guard(call): runs a call into the core
   *   wheelZooms(event): whether a turn of the wheel is the picture's, not the page's
   *   pointed(): the mouse was moved over the picture or away from it; whether what it points at shall be marked
   *   cursorAt(x, y, onHandle): the cursor for a mouse that rests there
   *   tapped(tap), doubleTapped(tap): {x, y, touch, target} in the stage, and clientX, clientY in the window
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
    listen("click", (event) => this.#taken.has(event.pointerId) && event.stopPropagation(), { capture: true });
    listen("click", (event) => this.#click(event));
    listen("wheel", (event) => this.#wheel(event), { passive: false });
    listen("touchmove", (event) => this.#touchMove(event), { passive: false });
    listen("contextmenu", (event) => event.preventDefault()); // the secondary button pans
    listen("mousedown", (event) => this.#mouseDown(event));
    listen("dragstart", (event) => event.preventDefault());
    listen("gesturestart", (event) => event.preventDefault()); // Safari's pinch would zoom the page
    window.addEventListener("keydown", (event) => this.#escape(event), { signal, capture: true });
    window.addEventListener("keydown", (event) => this.#typed(event), { signal, capture: true });
    for (const type of ["keydown", "keyup"]) {
      window.addEventListener(type, (event) => this.#modifierKey(event), { signal, capture: true });
    }
  }

  /** Whether a pointer is down on the picture. */
  get active() {
    return this.#held.size > 0;
  }

  /** While a handle is dragged: the direction of its line on screen, which the cursor shows. */
  set dragDirection(direction) {
    if (direction && this.active) this.#showCursor(cursorAlong(direction));
  }

  /** Lets go of everything, as when the document is replaced. */
  reset() {
    for (const id of this.#held.keys()) {
      if (this.#stage.hasPointerCapture(id)) this.#stage.releasePointerCapture(id);
    }
    this.#held.clear();
    this.#resting.clear();
    this.#tapped = this.#before = null;
    this.#showCursor("");
  }

  #call(method, event) {
    let target = "";
    this.#host.guard(() => {
      const core = this.#host.core();
      if (!core) return;
      const [x, y] = this.#position(event);
      const kind = kindOf(event);
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
    // A first finger: whatever the last ones have left behind is over.
    if (event.isPrimary) {
      this.#taken.clear();
      this.#resting.clear();
    }
    if (onTapControl(event)) this.#resting.set(event.pointerId, event);
    if (onControl(event)) return;
    if (event.button > 2) return; // the mouse's back and forward
    // Two fingers pinch, wherever the first one came down.
    if (event.pointerType === "touch") for (const id of [...this.#resting.keys()]) this.#take(id);
    this.#press(event);
  }

  #press(event) {
    const target = this.#call("pointerDown", event);
    this.#tapped = null;
    const alone = this.#held.size === 0 && event.button === 0 && !event.ctrlKey && !event.metaKey;
    for (const other of this.#held.values()) other.still = false;
    const { x, y } = this.last;
    this.#held.set(event.pointerId, { target, kind: kindOf(event), button: event.button, at: [x, y], x, y, ms: event.timeStamp, still: alone });
    this.#capture(event.pointerId);
    if (target === "camera") this.#showCursor("camera-held");
  }

  #capture(id) {
    // A pointer that a script invented cannot be captured; its gesture works without.
    try {
      this.#stage.setPointerCapture(id);
    } catch {}
  }

  /** A finger that rests on a control begins what it would have begun on the picture. */
  #take(id) {
    const event = this.#resting.get(id);
    this.#resting.delete(id);
    this.#taken.add(id);
    this.#press(event);
    this.#held.get(id).still = false;
  }

  #move(event) {
    const resting = this.#resting.get(event.pointerId);
    if (resting && Math.hypot(event.clientX - resting.clientX, event.clientY - resting.clientY) > kFingerTap.strayPx) this.#take(event.pointerId);
    const held = this.#held.get(event.pointerId);
    // Of a mouse with two buttons down, one that is let go of is told as a movement.
    if (held && event.button === held.button && !(event.buttons & kDown[held.button])) return this.#up(event);
    if (held) {
      this.#call("pointerMove", event);
      held.at = [this.last.x, this.last.y];
      const { strayPx } = event.pointerType === "touch" ? kFingerTap : kTap;
      if (Math.hypot(this.last.x - held.x, this.last.y - held.y) > strayPx) held.still = false;
    } else if (onControl(event)) {
      const [x, y] = this.#position(event);
      this.last = { x, y, touch: event.pointerType === "touch" };
      this.#leave(event);
    } else if (event.pointerType !== "touch") {
      this.#hover(event);
    }
  }

  #hover(event) {
    const marks = this.#host.pointed();
    if (!marks) {
      const [x, y] = this.#position(event);
      this.last = { x, y, touch: false };
    }
    const onHandle = marks && this.#call("hover", event) === "handle";
    this.#showCursor(this.#host.cursorAt(this.last.x, this.last.y, onHandle));
  }

  #up(event) {
    this.#resting.delete(event.pointerId);
    const held = this.#held.get(event.pointerId);
    if (!held) return;
    this.#held.delete(event.pointerId);
    this.#call("pointerUp", event);
    const touch = event.pointerType === "touch";
    const { ms } = touch ? kFingerTap : kTap;
    if (held.still && event.timeStamp - held.ms <= ms) {
      this.#tapped = { x: held.x, y: held.y, ms: event.timeStamp, touch, target: held.target };
    }
    if (touch) this.#showCursor("");
    else this.#hover(event);
  }

  // A tap counts when the browser is through with it: what opens earlier would get the mouse events that follow a touch.
  #click(event) {
    const tap = this.#tapped;
    this.#tapped = null;
    if (!tap || onControl(event)) return;
    const { doubleMs, doublePx } = tap.touch ? kFingerTap : kTap;
    const first = this.#before;
    const double = first && tap.ms - first.ms <= doubleMs && Math.hypot(tap.x - first.x, tap.y - first.y) <= doublePx;
    this.#before = double ? null : tap;
    const { clientX, clientY } = event;
    this.#host.guard(() => this.#host[double ? "doubleTapped" : "tapped"]({ ...tap, clientX, clientY }));
    this.#host.changed();
  }

  #cancelPointer(event) {
    if (event.type === "pointercancel") this.#resting.delete(event.pointerId);
    else if (this.#stage.hasPointerCapture(event.pointerId)) return; // it was a control's before
    // A browser lets go of a mouse with any of its buttons; the one that drags is still down.
    else if (event.buttons & kDown[this.#held.get(event.pointerId)?.button]) return this.#capture(event.pointerId);
    if (!this.#held.delete(event.pointerId)) return;
    this.#host.guard(() => this.#host.core()?.cancelPointer(event.pointerId));
    this.#showCursor("");
    this.#host.changed();
  }

  #cancelGesture() {
    this.reset();
    this.#host.guard(() => this.#host.core()?.cancelGesture());
    this.#host.changed();
  }

  #leave(event) {
    if (this.#held.has(event.pointerId)) return;
    if (this.#host.pointed()) this.#host.guard(() => this.#host.core()?.endHover());
    this.#showCursor("");
    this.#host.changed();
  }

  #escape(event) {
    if (event.key !== "Escape" || !this.active) return;
    event.preventDefault();
    event.stopPropagation();
    this.#cancelGesture();
  }

  // Two clicks on a number are no double one when a value was typed and accepted in between. A key that is held down types nothing.
  #typed(event) {
    if (!event.repeat) this.#before = null;
  }

  // Shift and Alt change how a drag snaps, at once and not only with the pointer's next movement.
  #modifierKey(event) {
    if (event.key !== "Shift" && event.key !== "Alt") return;
    const dragging = [...this.#held].filter(([, { target }]) => target === "handle");
    if (dragging.length === 0) return;
    event.preventDefault(); // Alt alone would open the browser's menu
    for (const [id, { kind, at }] of dragging) {
      this.#host.guard(() => this.#host.core()?.pointerMove(id, kind, 0, ...at, modifierBits(event)));
    }
    this.#host.changed();
  }

  // A press on a label is one on the picture: nothing is selected, and the focus is the canvas's. The middle button would scroll.
  #mouseDown(event) {
    if (onControl(event)) return;
    const onLabel = event.target !== this.#canvas;
    if (event.button === 1 || onLabel) {
      event.preventDefault();
      this.#canvas.focus({ preventScroll: true });
    }
  }

  // What goes sideways is the page's: it scrolls, or goes back in its history.
  #wheel(event) {
    if (Math.abs(event.deltaX) > Math.abs(event.deltaY) || !this.#host.wheelZooms(event)) return;
    event.preventDefault();
    const unit = event.deltaMode === 1 ? kWheelLinePx : event.deltaMode === 2 ? this.#stage.offsetHeight : 1;
    this.#host.guard(() => {
      const [x, y] = this.#position(event);
      this.#host.core()?.wheel(x, y, event.deltaY * unit, modifierBits(event));
    });
    this.#host.changed();
  }

  // Where fingers may scroll the page (touch-action), one that holds an arrow does not, nor do two. It is told here and not as they come down: that would
  // take the click from a tap.
  #touchMove(event) {
    const holdsHandle = [...this.#held.values()].some(({ target }) => target === "handle");
    if (event.cancelable && (holdsHandle || event.touches.length > 1)) event.preventDefault();
  }

  #showCursor(name) {
    if (this.#stage.dataset.cursor !== name) this.#stage.dataset.cursor = name;
  }
}
