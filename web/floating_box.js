/** A small dark box of text over the picture, which keeps within it. What it says is its owner's business. */

const kMarginPx = 6; // from the picture's edge
const kRoomPx = 3; // to what should be seen
const kHardlyPx2 = 30; // a corner of a number, which can be read all the same

export class FloatingBox {
  #stage;
  #node;
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
    const [left, top] = this.within(x, y);
    const transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
    if (transform !== this.#transform) this.#node.style.transform = this.#transform = transform;
  }

  /** Its middle there, or at the other height where the first would leave the picture. */
  placeMiddle(x, y, otherY) {
    const [width, height] = this.size;
    const fits = (middle) => middle - height / 2 >= kMarginPx && middle + height / 2 <= this.room[1] - kMarginPx;
    this.place(x - width / 2, (fits(y) || !fits(otherY) ? y : otherY) - height / 2);
  }

  /**
   * The first of several places for its corner at which it hides least of what is there.
   * @param {[number, number][]} places
   * @param {[number, number, number, number][]} boxes what should be seen
   * @param {number} usual index of the place that it keeps while another one is hardly better
   * @param {[number, number, number, number]} [never] what it covers only where all places do, as the picture's edge pushes it there
   * @returns {number} index of the place that was taken
   */
  placeClear(places, boxes, usual, never) {
    const hidden = places.map((place) => (never && this.hides(place, [never]) > 0 ? Infinity : this.hides(place, boxes)));
    const best = hidden.indexOf(Math.min(...hidden));
    const taken = hidden[usual] <= hidden[best] + kHardlyPx2 ? usual : best;
    this.place(...places[taken]);
    return taken;
  }

  /** How much (px²) of these boxes it hides with its corner there. */
  hides([x, y], boxes) {
    const [width, height] = this.size;
    const [left, top] = this.within(x, y);
    const own = [left - kRoomPx, top - kRoomPx, left + width + kRoomPx, top + height + kRoomPx];
    return boxes.reduce((sum, box) => sum + overlap(own, box), 0);
  }
}

function overlap([ax0, ay0, ax1, ay1], [bx0, by0, bx1, by1]) {
  return Math.max(0, Math.min(ax1, bx1) - Math.max(ax0, bx0)) * Math.max(0, Math.min(ay1, by1) - Math.max(ay0, by0));
}

/** Changes a node's text where it is another one. */
export function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}
