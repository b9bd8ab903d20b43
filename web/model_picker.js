/** The menu of models: a button that says which one is shown, and a dialog with a picture of each. */

import { make } from "./dom.js";

const kThumbnails = "assets/thumbnails";

export class ModelPicker {
  #button;
  #dialog;
  #cards;
  #pick;

  /**
   * @param {HTMLButtonElement} button opens the dialog
   * @param {HTMLDialogElement} dialog holds a list and a button with the attribute data-close
   * @param {(name: string) => void} pick a model was chosen
   */
  constructor(button, dialog, pick) {
    this.#button = button;
    this.#dialog = dialog;
    this.#cards = dialog.querySelector("ul");
    this.#pick = pick;
    button.addEventListener("click", () => this.#show());
    dialog.addEventListener("click", (event) => this.#click(event));
    dialog.addEventListener("keydown", (event) => this.#keyDown(event));
    dialog.addEventListener("close", () => button.setAttribute("aria-expanded", "false"));
    // Pictures are fetched when somebody is about to look at them.
    for (const type of ["pointerenter", "focus"]) button.addEventListener(type, () => this.#fetchPictures());
  }

  /**
   * @param {{name: string, title: string}[]} models
   * @param {string} current the name of the one that is shown
   */
  show(models, current) {
    this.#button.disabled = models.length < 2;
    if (this.#cards.children.length !== models.length) this.#cards.replaceChildren(...models.map(makeCard));
    for (const link of this.#links()) {
      if (link.dataset.model === current) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    }
  }

  #links() {
    return [...this.#cards.querySelectorAll("a")];
  }

  #fetchPictures() {
    for (const picture of this.#cards.querySelectorAll("img[data-src]")) {
      const { src } = picture.dataset;
      picture.addEventListener("error", () => (picture.dataset.src = src), { once: true }); // to be tried again
      picture.src = src;
      picture.removeAttribute("data-src");
    }
  }

  #show() {
    this.#fetchPictures();
    this.#dialog.showModal();
    this.#button.setAttribute("aria-expanded", "true");
    const current = this.#cards.querySelector("[aria-current]");
    current?.focus();
    current?.scrollIntoView({ block: "nearest" });
  }

  #click(event) {
    const link = event.target.closest("a");
    if (link) {
      // With a modifier it opens another tab, as any link does.
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      this.#dialog.close();
      this.#pick(link.dataset.model);
    } else if (event.target === this.#dialog || event.target.closest("[data-close]")) {
      this.#dialog.close();
    }
  }

  // Arrows go from card to card; up and down to the one in the next row that is straight below.
  #keyDown(event) {
    event.stopPropagation(); // the editor's own keys wait until the dialog is closed
    const links = this.#links();
    const at = links.indexOf(document.activeElement);
    if (at < 0) return;
    const { offsetTop } = links[0].parentElement;
    const columns = links.filter((link) => link.parentElement.offsetTop === offsetTop).length;
    const moves = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns, ArrowUp: -columns };
    const next =
      event.key === "Home" ? 0 : event.key === "End" ? links.length - 1 : at + (moves[event.key] ?? Number.NaN);
    if (Number.isNaN(next)) return;
    event.preventDefault();
    links[next]?.focus();
  }
}

function makeCard({ name, title }) {
  const picture = make("img", {
    "data-src": `${kThumbnails}/${encodeURIComponent(name)}.webp`,
    alt: "",
    width: 320,
    height: 240,
    decoding: "async",
    draggable: "false",
  });
  const query = new URLSearchParams({ model: name });
  return make("li", {}, make("a", { href: `?${query}`, "data-model": name }, picture, make("span", {}, title)));
}
