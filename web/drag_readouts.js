/** While handles are dragged: the value that comes of each, and how it differs from the old one, in a box beside the handle or above the finger. */

import { make } from "./dom.js";
import { FloatingBox, setText } from "./floating_box.js";

// px. From the handle to the box's edge, clear of the arrow; and on a touch screen to its middle, clear of the finger.
const kClearMousePx = 20;
const kClearTouchPx = 74;
const kLeastClearPx = 14; // where the picture's edge pushes it

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
  #sides = null; // unit vectors from the handle to where the box may stand; null between drags
  #side = 0;
  #limitShown = null;

  constructor(stage) {
    this.#node.append(make("div", {}, this.#title, this.#value, this.#difference, this.#limit), this.#hint);
    this.#box = new FloatingBox(stage, this.#node);
  }

  show({ title, text, difference, handle, direction, pointer, limit }, hint, others) {
    const touch = pointer === "touch";
    const begins = this.#sides === null;
    this.#sides ??= this.#freeSides(handle, direction);
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
    if (touch) this.#box.placeMiddle(handle[0], handle[1] - kClearTouchPx, handle[1] + kClearTouchPx);
    else this.#placeOff(handle, begins ? others : null);
  }

  hide() {
    this.#sides = this.#limitShown = null;
    this.#side = 0;
    this.#node.removeAttribute("data-limit");
    this.#box.shown = false;
  }

  // Best across the line, on the side that looks away from the picture's middle, where the model is; else beyond the handle.
  #freeSides([x, y], [dx, dy]) {
    const [width, height] = this.#box.room;
    const outwards = ([vx, vy]) => (vx * (x - width / 2) + vy * (y - height / 2) < 0 ? [-vx, -vy] : [vx, vy]);
    const across = outwards([-dy, dx]);
    return [across, outwards([dx, dy]), [-across[0], -across[1]]];
  }

  // At the beginning of the drag it takes the side where it hides least. There it stays until the picture's edge would push it onto the handle.
  #placeOff([x, y], others) {
    const [width, height] = this.#box.size;
    const boxAt = ([sx, sy]) => {
      const clear = kClearMousePx + Math.abs(sx) * (width / 2) + Math.abs(sy) * (height / 2);
      return this.#box.within(x + sx * clear - width / 2, y + sy * clear - height / 2);
    };
    const isClear = (side) => {
      const [left, top] = boxAt(side);
      const away = Math.hypot(Math.max(left - x, x - left - width, 0), Math.max(top - y, y - top - height, 0));
      return away >= kLeastClearPx;
    };
    if (others) {
      const hidden = this.#sides.map((side) => (isClear(side) ? this.#box.hides(boxAt(side), others) : Infinity));
      this.#side = hidden.indexOf(Math.min(...hidden));
    }
    if (!isClear(this.#sides[this.#side])) this.#side = Math.max(0, this.#sides.findIndex(isClear));
    this.#box.place(...boxAt(this.#sides[this.#side]));
  }
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
   * @param {[number, number, number, number][]} others what should not be hidden: numbers of other lines, switches and choices
   */
  update(gestures, others) {
    for (const [id, readout] of this.#shown) {
      if (gestures.some((gesture) => gesture.id === id && gesture.parameter === readout.parameter)) continue;
      readout.hide();
      this.#shown.delete(id);
      this.#spare.push(readout);
      if (id === this.#hinted) [this.#hintDue, this.#hinted] = [false, null];
    }
    for (const gesture of gestures) {
      if (!this.#shown.has(gesture.id)) {
        const readout = this.#spare.pop() ?? new DragReadout(this.#stage);
        readout.parameter = gesture.parameter;
        this.#shown.set(gesture.id, readout);
        if (this.#hintDue && gesture.pointer !== "touch" && gesture.canBeFine) this.#hinted = gesture.id;
      }
      const hint = gesture.id === this.#hinted ? "Shift: finer · Alt: any value" : "";
      this.#shown.get(gesture.id).show(gesture, hint, others);
    }
  }
}
