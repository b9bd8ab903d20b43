/** What the picture says of the pointer's business while nothing is dragged: the name of what it rests on, and after some acts a sentence for a moment. */

import { make } from "./dom.js";
import { FloatingBox, setText } from "./floating_box.js";

const kSentenceMs = 4000;
const kAwayPx = 12; // from the edge of what it belongs to
const kAboveFingerPx = 40;

export class Readout {
  #title = make("span", { class: "title" });
  #box;
  #sentence = null; // {text, at, untilMs}
  #text = ""; // what it says
  #side = 0; // where, of the places that there are

  /** @param {HTMLElement} stage the picture's box */
  constructor(stage) {
    const node = make("div", { class: "readout", "aria-hidden": "true" }, make("div", {}, this.#title));
    this.#box = new FloatingBox(stage, node);
  }

  /**
   * Shows what there is to say now, the most important alone.
   * @param {string} name of what the pointer rests on, or ""
   * @param {{x: number, y: number, touch: boolean}} pointer
   * @param {[number, number, number, number]} [box] what it belongs to instead, when that is not the pointer
   * @param {[number, number, number, number][]} [others] what should not be hidden: numbers, switches and choices
   */
  update(name, pointer, box, others = []) {
    if (this.#sentence && performance.now() > this.#sentence.untilMs) this.#sentence = null;
    const text = (box && this.#sentence?.text) || name || this.#sentence?.text || "";
    this.#box.shown = Boolean(text);
    if (!text) return; // what fades away keeps its text
    if (text !== this.#text) this.#side = 0;
    this.#text = text;
    setText(this.#title, text);
    const besidePointer = text === name && !box;
    const places = besidePointer ? this.#besidePointer(pointer) : this.#around(text === name ? box : this.#sentence.at);
    const { x, y } = pointer;
    this.#side = this.#box.placeClear(places, others, this.#side, besidePointer ? [x - 1, y - 1, x + 1, y + 1] : undefined);
  }

  /** Says a sentence beside a place in the picture. Gives the time (ms) after which update() takes it away. */
  say(text, at) {
    this.#sentence = { text, at, untilMs: performance.now() + kSentenceMs };
    return kSentenceMs;
  }

  /** Takes a sentence back. */
  silence() {
    this.#sentence = null;
  }

  /** The sentence goes along with its line; null: that is not shown. */
  moveSentence(box) {
    if (this.#sentence && box) this.#sentence.at = box;
  }

  // Beside a mouse's arrow, but above a finger.
  #besidePointer({ x, y, touch }) {
    const [width, height] = this.#box.size;
    if (touch) return [[x - width / 2, y - height - kAboveFingerPx]];
    const [right, below, left, above, level] = [x + 14, y + 20, x - width - 10, y - height - 12, y - height / 2];
    const near = [[right, below], [right, above], [left, below], [left, above]];
    const farther = [[right + 12, level], [left - 12, level], [right, below + height], [left, below + height], [right, above - height], [left, above - height]];
    return [...near, ...farther];
  }

  #around([x0, y0, x1, y1]) {
    const [width, height] = this.#box.size;
    const [x, y] = [(x0 + x1 - width) / 2, (y0 + y1 - height) / 2];
    const up = (y1 - y0 + height) / 2 + kAwayPx;
    const aside = (x1 - x0 + width) / 2 + kAwayPx;
    const places = [[x, y - up], [x, y + up], [x + aside, y], [x - aside, y], [x + aside, y - up], [x - aside, y - up], [x + aside, y + up], [x - aside, y + up]];
    // Where the picture's edge would push it onto what it belongs to, it does not stand.
    const free = places.filter(([left, top]) => this.#box.within(left, top).every((at, i) => at === [left, top][i]));
    return free.length > 0 ? free : places;
  }
}
