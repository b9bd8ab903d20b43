/** What the picture says of the pointer's business while nothing is dragged: the name of what it rests on, and after some acts a sentence for a moment. */

import { make } from "./dom.js";
import { FloatingBox, kFartherCost, overlap, setText } from "./floating_box.js";

const kSentenceMs = 4000;
const kAwayPx = 12; // from the edge of what it belongs to
const kClosePx = 4; // to that, beside the little room that the box itself keeps: they look like one
const kAboveFingerPx = 40;
const kFartherPx = [0, 24, 56]; // from a mouse's arrow, where all near places are taken

export class Readout {
  #title = make("span", { class: "title" });
  #box;
  #sentence = null; // {text, at, untilMs}
  #text = ""; // what it says
  #side = null; // where, of the places that there are

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
   * @param {(box: [number, number, number, number]) => number} cost how much a box over the picture would hide (px²)
   */
  update(name, pointer, box, cost) {
    if (this.#sentence && performance.now() > this.#sentence.untilMs) this.#sentence = null;
    const text = (box && this.#sentence?.text) || name || this.#sentence?.text || "";
    this.#box.shown = Boolean(text);
    if (text !== this.#text) this.#side = null;
    this.#text = text;
    if (!text) return; // what fades away keeps its text in the picture
    setText(this.#title, text);
    const besidePointer = text === name && !box;
    const { x, y } = pointer;
    const whose = besidePointer ? [x - 1, y - 1, x + 1, y + 1] : text === name ? box : this.#sentence.at;
    const places = besidePointer ? this.#besidePointer(pointer) : this.#around(whose);
    // Where the picture's edge would push it onto what it belongs to, or close to it, it does not stand.
    const [x0, y0, x1, y1] = whose;
    const pushed = (covered) => overlap(covered, [x0 - kClosePx, y0 - kClosePx, x1 + kClosePx, y1 + kClosePx]) > 0;
    const costs = (covered, i) => (pushed(covered) ? Infinity : cost(covered) + kFartherCost * places[i][2]);
    this.#side = this.#box.placeClear(places, costs, this.#side);
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

  // Places for its corner, and how much farther than the nearest they are (px): beside a mouse's arrow, but above a finger.
  #besidePointer({ x, y, touch }) {
    const [width, height] = this.#box.size;
    if (touch) return [[x - width / 2, y - height - kAboveFingerPx, 0]];
    return kFartherPx.flatMap((farther) => {
      const [left, right, middle] = [x - width - 10 - farther, x + 14 + farther, x - width / 2];
      const [above, below, level] = [y - height - 12 - farther, y + 20 + farther, y - height / 2];
      const aside = [[right, below], [right, above], [left, below], [left, above], [right + 12, level], [left - 12, level]];
      return [...aside, [middle, above], [middle, below]].map(([px, py]) => [px, py, farther]);
    });
  }

  #around([x0, y0, x1, y1]) {
    const [width, height] = this.#box.size;
    const [x, y] = [(x0 + x1 - width) / 2, (y0 + y1 - height) / 2];
    const up = (y1 - y0 + height) / 2 + kAwayPx;
    const aside = (x1 - x0 + width) / 2 + kAwayPx;
    return kFartherPx.flatMap((farther) => {
      const [above, below, left, right] = [y - up - farther, y + up + farther, x - aside - farther, x + aside + farther];
      const places = [[x, above], [x, below], [right, y], [left, y], [right, above], [left, above], [right, below], [left, below]];
      return places.map(([px, py]) => [px, py, farther]);
    });
  }
}
