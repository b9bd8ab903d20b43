/**
 * What the picture says of the pointer's business: the name of what it rests on, while a handle is dragged the value that comes
 * of it, and after some acts a sentence for a moment. One small dark box; for screen readers there is a live region beside it.
 */

import { make } from "./dom.js";

// px. From the handle to the box's edge, clear of the arrow; and on a touch screen to its middle, clear of the finger.
const kClearMousePx = 20;
const kClearTouchPx = 74;
const kLeastClearPx = 14; // where the picture's edge pushes it
const kMarginPx = 6; // from the picture's edge

const kSentenceMs = 4000;
const kNudgeMs = 12; // a phone's buzz where a limit is reached

export class Readout {
  #stage;
  #node;
  #title = make("span", { class: "title" });
  #value = make("b");
  #difference = make("span", { class: "difference" });
  #limit = make("span", { class: "limit" });
  #hint = make("small");
  #live;
  #gesture = null; // {sides, side, limit}: of the drag under way; sides: unit vectors from the handle to where the box may stand
  #sentence = null; // {text, at, untilMs}
  #hintDue = true; // the modifiers are explained during a visitor's first drag
  #transform = "";

  /**
   * @param {HTMLElement} stage the picture's box
   * @param {HTMLElement} node the box, empty
   * @param {HTMLElement} live role status
   */
  constructor(stage, node, live) {
    this.#stage = stage;
    this.#node = node;
    this.#live = live;
    node.append(make("div", {}, this.#title, this.#value, this.#difference, this.#limit), this.#hint);
  }

  /**
   * Shows what there is to say now, the most important alone.
   * @param {object | null} gesture as Core.gesture() gives it, with `title` and `canBeFine`: whether keys change its steps
   * @param {string} name of what the pointer rests on, or ""
   * @param {{x: number, y: number, touch: boolean}} pointer
   * @param {[number, number, number, number]} [box] what it belongs to instead, when that is not the pointer
   */
  update(gesture, name, pointer, box) {
    if (gesture) return this.#showGesture(gesture);
    if (this.#gesture) this.#endGesture();
    if (this.#sentence && performance.now() > this.#sentence.untilMs) this.#sentence = null;
    const text = (box && this.#sentence?.text) || name || this.#sentence?.text || "";
    this.#fill({ title: text });
    this.#node.toggleAttribute("data-shown", Boolean(text));
    if (!text) return;
    if (text === name && !box) this.#placeBeside(pointer);
    else this.#placeAt(text === name ? box : this.#sentence.at);
  }

  /** Says a sentence beside a place in the picture, and to screen readers. Gives the time (ms) after which update() takes it away. */
  say(text, at) {
    this.#sentence = { text, at, untilMs: performance.now() + kSentenceMs };
    this.#live.textContent = text;
    return kSentenceMs;
  }

  /** Takes a sentence back. */
  silence() {
    this.#sentence = null;
    this.#live.textContent = "";
  }

  /** The sentence goes along with its line; null: that is not shown. */
  moveSentence(box) {
    if (this.#sentence && box) this.#sentence.at = box;
  }

  #showGesture(gesture) {
    const { handle, direction, pointer, limit } = gesture;
    const touch = pointer === "touch";
    if (!this.#gesture) {
      this.#sentence = null;
      this.#gesture = { sides: this.#freeSides(handle, direction), side: 0, hinted: !touch && gesture.canBeFine, limit: null };
    }
    const hinted = this.#hintDue && this.#gesture.hinted;
    this.#fill({
      title: gesture.title,
      value: gesture.text,
      difference: gesture.difference,
      limit: limit ?? "",
      hint: hinted ? "Shift: finer · Alt: any value" : "",
    });
    this.#node.toggleAttribute("data-shown", true);
    if (limit !== this.#gesture.limit) {
      this.#gesture.limit = limit;
      this.#node.toggleAttribute("data-limit", Boolean(limit));
      if (limit && touch) navigator.vibrate?.(kNudgeMs);
    }
    if (touch) this.#placeMiddle(handle[0], handle[1] - kClearTouchPx, handle[1] + kClearTouchPx);
    else this.#placeOff(handle);
  }

  #endGesture() {
    if (this.#gesture.hinted) this.#hintDue = false;
    this.#gesture = null;
    this.#node.removeAttribute("data-limit");
  }

  // Best across the line, on the side that looks away from the picture's middle, where the model is; else beyond the handle.
  #freeSides([x, y], [dx, dy]) {
    const { offsetWidth, offsetHeight } = this.#stage;
    const outwards = ([vx, vy]) => (vx * (x - offsetWidth / 2) + vy * (y - offsetHeight / 2) < 0 ? [-vx, -vy] : [vx, vy]);
    const across = outwards([-dy, dx]);
    return [across, outwards([dx, dy]), [-across[0], -across[1]]];
  }

  #fill({ title = "", value = "", difference = "", limit = "", hint = "" }) {
    for (const [node, text] of [
      [this.#title, title],
      [this.#value, value],
      [this.#difference, difference],
      [this.#limit, limit],
      [this.#hint, hint],
    ]) {
      if (node.textContent !== text) node.textContent = text;
    }
  }

  // It stays on its side of the handle until the picture's edge would push it onto the handle there.
  #placeOff([x, y]) {
    const { offsetWidth: width, offsetHeight: height } = this.#node;
    const { sides } = this.#gesture;
    const boxAt = ([sx, sy]) => {
      const clear = kClearMousePx + Math.abs(sx) * (width / 2) + Math.abs(sy) * (height / 2);
      return this.#within(x + sx * clear - width / 2, y + sy * clear - height / 2);
    };
    const isClear = (side) => {
      const [left, top] = boxAt(side);
      const away = Math.hypot(Math.max(left - x, x - left - width, 0), Math.max(top - y, y - top - height, 0));
      return away >= kLeastClearPx;
    };
    if (!isClear(sides[this.#gesture.side])) this.#gesture.side = Math.max(0, sides.findIndex(isClear));
    this.#place(...boxAt(sides[this.#gesture.side]));
  }

  #placeAt([x0, y0, x1, y1]) {
    const { offsetHeight: height } = this.#node;
    const away = (y1 - y0) / 2 + height / 2 + 12;
    this.#placeMiddle((x0 + x1) / 2, (y0 + y1) / 2 - away, (y0 + y1) / 2 + away);
  }

  // The box's middle, or the other height where the first would leave the picture.
  #placeMiddle(x, y, otherY) {
    const { offsetWidth: width, offsetHeight: height } = this.#node;
    const { offsetHeight: stageHeight } = this.#stage;
    const fits = (middle) => middle - height / 2 >= kMarginPx && middle + height / 2 <= stageHeight - kMarginPx;
    this.#place(x - width / 2, (fits(y) || !fits(otherY) ? y : otherY) - height / 2);
  }

  // Beside a mouse's arrow, but above a finger.
  #placeBeside(pointer) {
    const { offsetWidth: width, offsetHeight: height } = this.#node;
    if (pointer.touch) return this.#place(pointer.x - width / 2, pointer.y - height - 40);
    const below = pointer.y + 20;
    const fits = below + height + kMarginPx <= this.#stage.offsetHeight;
    this.#place(pointer.x + 14, fits ? below : pointer.y - height - 12);
  }

  // The nearest place for the box's corner at which it is all in the picture.
  #within(x, y) {
    const { offsetWidth: width, offsetHeight: height } = this.#node;
    const { offsetWidth: stageWidth, offsetHeight: stageHeight } = this.#stage;
    const clamp = (at, most) => Math.min(Math.max(at, kMarginPx), Math.max(kMarginPx, most - kMarginPx));
    return [clamp(x, stageWidth - width), clamp(y, stageHeight - height)];
  }

  #place(x, y) {
    const [left, top] = this.#within(x, y);
    const transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
    if (transform !== this.#transform) this.#node.style.transform = this.#transform = transform;
  }
}
