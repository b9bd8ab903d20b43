/** What the picture says of the pointer's business while nothing is dragged: the name of what it rests on, and after some acts a sentence for a moment. */

import { make } from "./dom.js";
import { FloatingBox, setText } from "./floating_box.js";

const kSentenceMs = 4000;
const kAwayPx = 12; // from the edge of what it belongs to

export class Readout {
  #title = make("span", { class: "title" });
  #box;
  #sentence = null; // {text, at, untilMs}

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
   */
  update(name, pointer, box) {
    if (this.#sentence && performance.now() > this.#sentence.untilMs) this.#sentence = null;
    const text = (box && this.#sentence?.text) || name || this.#sentence?.text || "";
    if (text) setText(this.#title, text); // or else what fades away keeps its text
    this.#box.shown = Boolean(text);
    if (!text) return;
    if (text === name && !box) this.#box.placeBeside(pointer);
    else this.#placeAt(text === name ? box : this.#sentence.at);
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

  #placeAt([x0, y0, x1, y1]) {
    const away = (y1 - y0) / 2 + this.#box.size[1] / 2 + kAwayPx;
    this.#box.placeMiddle((x0 + x1) / 2, (y0 + y1) / 2 - away, (y0 + y1) / 2 + away);
  }
}
