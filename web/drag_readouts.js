/** While handles are dragged: the value that comes of each, and how it differs from the old one, in a box beside the handle or above the finger. */

import { make } from "./dom.js";
import { FloatingBox, kFartherCost, overlap, setText } from "./floating_box.js";

// px. From the handle to the box: beside a mouse's arrow, and clear of a finger and of the hand behind it.
const kClearMousePx = 20;
const kClearFingerPx = 56;
// The least of that where the picture's edge pushes it.
const kLeastClearMousePx = 14;
const kLeastClearFingerPx = 40;
const kFartherPx = [0, 32, 72]; // than that, where all near places are taken
const kFarFromFingerPx = [130, 210];

const kNudgeMs = 12; // a phone's buzz where a limit is reached

/** The box of one drag. */
class DragReadout {
  parameter = ""; // whose handle is dragged
  #node = make("div", { class: "readout", "aria-hidden": "true" });
  #box;
  #title = make("span", { class: "title" });
  #value = make("b");
  #difference = make("span", { class: "difference" });
  #limit = make("span", { class: "limit" });
  #hint = make("small");
  #sides = null; // where it may stand: unit vectors from the handle, and how far beyond the nearest place; null between drags
  #side = null;
  #limitShown = null;

  constructor(stage) {
    this.#node.append(make("div", {}, this.#title, this.#value, this.#difference, this.#limit), this.#hint);
    this.#box = new FloatingBox(stage, this.#node);
  }

  /** Where the box is, with a little room around it. */
  get covered() {
    return this.#box.covered;
  }

  show({ title, text, difference, handle, direction, pointer, limit }, hint, cost) {
    const touch = pointer === "touch";
    this.#sides ??= touch ? sidesOfFinger() : this.#sidesOfArrow(handle, direction);
    setText(this.#title, title);
    setText(this.#value, text);
    setText(this.#difference, difference);
    setText(this.#limit, limit ?? "");
    setText(this.#hint, hint);
    this.#box.shown = true;
    if (limit !== this.#limitShown) {
      this.#limitShown = limit;
      this.#node.toggleAttribute("data-limit", Boolean(limit));
      if (limit && touch) navigator.vibrate?.(kNudgeMs);
    }
    this.#place(handle, touch ? [kClearFingerPx, kLeastClearFingerPx] : [kClearMousePx, kLeastClearMousePx], cost);
  }

  hide() {
    this.#sides = this.#limitShown = null;
    this.#side = null;
    this.#node.removeAttribute("data-limit");
    this.#box.shown = false;
  }

  // Best across the line, on the side that looks away from the picture's middle, where the model is; else beyond the handle.
  #sidesOfArrow([x, y], [dx, dy]) {
    const [width, height] = this.#box.room;
    const outwards = ([vx, vy]) => (vx * (x - width / 2) + vy * (y - height / 2) < 0 ? [-vx, -vy] : [vx, vy]);
    const [ax, ay] = outwards([-dy, dx]);
    const [bx, by] = outwards([dx, dy]);
    const between = (sense, beyond) => [(sense * ax + beyond * bx) * Math.SQRT1_2, (sense * ay + beyond * by) * Math.SQRT1_2];
    const near = [[ax, ay], [bx, by], [-ax, -ay], between(1, 1), between(-1, 1), between(1, -1), between(-1, -1)];
    return kFartherPx.flatMap((farther) => near.map(([sx, sy]) => [sx, sy, farther]));
  }

  // It keeps the side that it has taken for as long as another one would hide hardly less.
  #place([x, y], [clearPx, leastPx], cost) {
    const [width, height] = this.#box.size;
    const places = this.#sides.map(([sx, sy, farther]) => {
      const clear = clearPx + farther + Math.abs(sx) * (width / 2) + Math.abs(sy) * (height / 2);
      return [x + sx * clear - width / 2, y + sy * clear - height / 2];
    });
    const away = ([x0, y0, x1, y1]) => Math.hypot(Math.max(x0 - x, x - x1, 0), Math.max(y0 - y, y - y1, 0));
    const costs = (covered, i) => (away(covered) < leastPx ? Infinity : cost(covered) + kFartherCost * this.#sides[i][2]);
    this.#side = this.#box.placeClear(places, costs, this.#side);
  }
}

// Above a finger, else beside it; below it is the hand. A phone's picture may have no other room than at its upper or lower edge, where the picture's edge
// holds it.
function sidesOfFinger() {
  const above = [[0, -1], [-0.8, -0.6], [0.8, -0.6]];
  const beside = [[-1, 0], [1, 0], [0, 1]];
  const near = [...kFartherPx.flatMap((farther) => above.map(([sx, sy]) => [sx, sy, farther])), ...beside.map(([sx, sy]) => [sx, sy, 0])];
  return [...near, ...kFarFromFingerPx.flatMap((farther) => [[0, -1, farther], [0, 1, farther]])];
}

export class DragReadouts {
  #stage;
  #shown = new Map(); // pointer id -> DragReadout
  #spare = []; // so that one that fades away can do so
  #hintDue = true; // the modifiers are explained during a visitor's first drag
  #hinted = null; // the id of the pointer whose drag explains them

  /** @param {HTMLElement} stage the picture's box */
  constructor(stage) {
    this.#stage = stage;
  }

  /**
   * @param {object[]} gestures as Core.gestures() gives them, with `title` and `canBeFine`: whether keys change its steps
   * @param {(box: [number, number, number, number]) => number} cost how much a box over the picture would hide (px²)
   */
  update(gestures, cost) {
    for (const [id, readout] of this.#shown) {
      if (gestures.some((gesture) => gesture.id === id && gesture.parameter === readout.parameter)) continue;
      readout.hide();
      this.#shown.delete(id);
      this.#spare.push(readout);
      if (id === this.#hinted) [this.#hintDue, this.#hinted] = [false, null];
    }
    const taken = []; // by the boxes of other pointers
    for (const gesture of gestures) {
      if (!this.#shown.has(gesture.id)) {
        const readout = this.#spare.pop() ?? new DragReadout(this.#stage);
        readout.parameter = gesture.parameter;
        this.#shown.set(gesture.id, readout);
        if (this.#hintDue && gesture.pointer !== "touch" && gesture.canBeFine) this.#hinted = gesture.id;
      }
      const hint = gesture.id === this.#hinted ? "Shift: finer · Alt: any value" : "";
      const readout = this.#shown.get(gesture.id);
      readout.show(gesture, hint, (box) => taken.reduce((sum, other) => sum + overlap(box, other), cost(box)));
      taken.push(readout.covered);
    }
  }
}
