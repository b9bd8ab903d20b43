/** A small dark box of text over the picture, which keeps within it. What it says is its owner's business. */

const kMarginPx = 6; // from the picture's edge
const kRoomPx = 3; // to what should be seen
const kHardlyPx2 = 12; // as much as a line that crosses a part of the box: no reason to move

const kGlideMs = 120;

/** What a px farther from what it belongs to is worth, in px² of hidden numbers. */
export const kFartherCost = 0.1;

export class FloatingBox {
  #stage;
  #node;
  #at = [0, 0]; // where its corner was put
  #transform = "";

  /**
   * @param {HTMLElement} stage the picture's box
   * @param {HTMLElement} node the box
   */
  constructor(stage, node) {
    this.#stage = stage;
    this.#node = node;
    stage.append(node);
  }

  set shown(on) {
    this.#node.toggleAttribute("data-shown", on);
  }

  /** Its size and the picture's, in CSS pixels. */
  get size() {
    return [this.#node.offsetWidth, this.#node.offsetHeight];
  }
  get room() {
    return [this.#stage.offsetWidth, this.#stage.offsetHeight];
  }

  /** The nearest place for its corner at which all of it is in the picture. */
  within(x, y) {
    const [width, height] = this.size;
    const [roomX, roomY] = this.room;
    const clamp = (at, most) => Math.min(Math.max(at, kMarginPx), Math.max(kMarginPx, most - kMarginPx));
    return [clamp(x, roomX - width), clamp(y, roomY - height)];
  }

  place(x, y) {
    this.#at = [x, y];
    const [left, top] = this.within(x, y);
    const transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
    if (transform !== this.#transform) this.#node.style.transform = this.#transform = transform;
  }

  /**
   * Goes to the first of several places for its corner at which it hides least of what is there.
   * @param {[number, number][]} places
   * @param {(box: [number, number, number, number], i: number) => number} cost how much (px²) a box there hides, and the index of its place; Infinity where it
   *   must not be, unless all are so
   * @param {number | null} side index of the place that it has, which it keeps while another one is hardly better; null when it has none yet
   * @returns {number} index of the place that was taken
   */
  placeClear(places, cost, side) {
    const usual = side ?? 0;
    const hidden = places.map(([x, y], i) => cost(this.#covered(x, y), i));
    const best = hidden.indexOf(Math.min(...hidden));
    const taken = hidden[usual] <= hidden[best] + kHardlyPx2 ? usual : best;
    const [fromX, fromY] = this.within(...this.#at);
    this.place(...places[taken]);
    if (side !== null && taken !== side) this.#glideFrom(fromX, fromY);
    return taken;
  }

  // On its way to another side it can be followed by the eye.
  #glideFrom(fromX, fromY) {
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    const [x, y] = this.within(...this.#at);
    this.#node.animate([{ translate: `${fromX - x}px ${fromY - y}px` }, { translate: "0px 0px" }], { duration: kGlideMs, easing: "ease-out" });
  }

  /** What it covers where it is, and a little room around that: [x0, y0, x1, y1]. */
  get covered() {
    return this.#covered(...this.#at);
  }

  #covered(x, y) {
    const [width, height] = this.size;
    const [left, top] = this.within(x, y);
    return [left - kRoomPx, top - kRoomPx, left + width + kRoomPx, top + height + kRoomPx];
  }
}

/** How much of one box another one covers (px²). */
export function overlap([ax0, ay0, ax1, ay1], [bx0, by0, bx1, by1]) {
  return Math.max(0, Math.min(ax1, bx1) - Math.max(ax0, bx0)) * Math.max(0, Math.min(ay1, by1) - Math.max(ay0, by0));
}

/** Changes a node's text where it is another one. */
export function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}
