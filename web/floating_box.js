/** A small dark box of text over the picture, which keeps within it. What it says is its owner's business. */

const kMarginPx = 6; // from the picture's edge

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

  /** Beside a mouse's arrow, but above a finger. */
  placeBeside({ x, y, touch }) {
    const [width, height] = this.size;
    if (touch) return this.place(x - width / 2, y - height - 40);
    const below = y + 20;
    this.place(x + 14, below + height + kMarginPx <= this.room[1] ? below : y - height - 12);
  }
}

/** Changes a node's text where it is another one. */
export function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}
