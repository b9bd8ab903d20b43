/** What the element shows in place of the picture when it has none: what is wrong, why, and a button to try again where that may help. */

import { make } from "./dom.js";

export class EditorMessage {
  #heading = make("p", { class: "heading" });
  #reason = make("p");
  #retry = make("button", { type: "button" }, "Try again");

  /** To be put over the picture. */
  node = make("div", { class: "message", role: "alert", hidden: true }, this.#heading, this.#reason, this.#retry);

  /**
   * @param {() => void} retry what the button does
   * @param {AbortSignal} signal ends all listening
   */
  constructor(retry, signal) {
    this.#retry.addEventListener("click", retry, { signal });
  }

  show(heading, reason, canRetry = false) {
    this.node.hidden = false;
    this.#heading.textContent = heading;
    this.#reason.textContent = reason;
    this.#retry.hidden = !canRetry;
  }

  hide() {
    this.node.hidden = true;
    this.#heading.textContent = this.#reason.textContent = "";
  }
}
