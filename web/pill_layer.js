/**
 * Switches and choices over the picture (paper 5, boolean and range handles): buttons at the boxes that the core gives
 * them. Which one is where, and what it says, is the core's; here is only what a form control does by itself in a page.
 */

import { make } from "./dom.js";
import { choiceTitle } from "./numbers.js";

// px. A row of a choice's list, and the distance that the list keeps from the picture's edge, where a finger chooses.
const kTouchRowPx = 44;
const kListMarginPx = 6;

const kSvg = "http://www.w3.org/2000/svg";

function makeIcon(className, d) {
  const svg = document.createElementNS(kSvg, "svg");
  svg.setAttribute("class", className);
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(kSvg, "path");
  path.setAttribute("d", d);
  svg.append(path);
  return svg;
}

export class PillLayer {
  #layer;
  #host;
  #entries = new Map(); // the parameter's name, with "~" while it fades -> {node, ...what it shows}
  #parameters = [];
  #open = null; // {entry, list}: the choice that shows its options
  #hovered = null; // entry
  #touched = false; // the last press was a finger's
  #round = 0;

  /**
   * @param {HTMLElement} layer may hold other things too
   * @param {{set: (name: string, value: boolean | string) => void, changed: () => void}} host
   * @param {AbortSignal} signal
   */
  constructor(layer, host, signal) {
    this.#layer = layer;
    this.#host = host;
    layer.addEventListener("click", (event) => this.#click(event), { signal });
    layer.addEventListener("keydown", (event) => this.#keyDown(event), { signal });
    layer.addEventListener("pointerdown", ({ pointerType }) => (this.#touched = pointerType === "touch"), { signal });
    layer.addEventListener("pointerover", (event) => this.#hover(event), { signal });
    layer.addEventListener("pointerout", (event) => this.#hover(event), { signal });
    layer.addEventListener("focusout", (event) => this.#focusOut(event), { signal });
    const elsewhere = (event) => this.#open && !this.#isOfOpen(event.composedPath()[0]) && this.#close();
    window.addEventListener("pointerdown", elsewhere, { signal, capture: true });
  }

  /** The parameter of the choice under the pointer, whose pill says what is chosen but not of what; null for none. */
  get hovered() {
    return this.#hovered && !this.#open ? (this.#parameters[this.#hovered.parameter] ?? null) : null;
  }

  /** The parameters as getParameters() gives them. */
  describe(parameters) {
    this.#parameters = parameters;
    for (const entry of this.#entries.values()) this.#describe(entry);
  }

  /**
   * Shows these pills and no others.
   * @param {object[]} pills as Core.pills() gives them
   * @param {number} devicePixelRatio
   */
  update(pills, devicePixelRatio) {
    const round = ++this.#round;
    for (const pill of pills) {
      const key = pill.fading ? `${pill.name}~` : pill.name;
      const entry = this.#entries.get(key) ?? this.#add(key, pill);
      entry.round = round;
      this.#show(entry, pill, devicePixelRatio);
    }
    for (const [key, entry] of this.#entries) {
      if (entry.round === round) continue;
      this.#entries.delete(key);
      if (this.#open?.entry === entry) this.#close();
      if (this.#hovered === entry) this.#hovered = null;
      entry.node.remove();
    }
  }

  #add(key, pill) {
    const choice = pill.options.length > 0;
    const text = make("span");
    const sign = choice ? makeIcon("chevron", "m4 6.5 4 4 4-4") : make("span", { class: "track" });
    const node = make("button", { class: "pill", type: "button", part: "pill", "data-control": "tap" }, text, sign);
    if (pill.fading) node.inert = true;
    if (choice) {
      node.setAttribute("aria-haspopup", "listbox");
      node.setAttribute("aria-expanded", "false");
    }
    const entry = { node, text, choice, parameter: pill.parameter, options: [], box: pill.box, value: undefined, style: "", round: 0 };
    this.#entries.set(key, entry);
    this.#layer.append(node);
    this.#describe(entry);
    return entry;
  }

  #show(entry, pill, devicePixelRatio) {
    entry.options = pill.options;
    entry.box = pill.box;
    if (entry.parameter !== pill.parameter || entry.value !== pill.value) {
      entry.parameter = pill.parameter;
      entry.value = pill.value;
      this.#describe(entry);
    }
    place(entry, entry.node, pill.box, devicePixelRatio);
    const opacity = pill.opacity >= 1 ? "" : String(pill.opacity);
    if (entry.node.style.opacity !== opacity) entry.node.style.opacity = opacity;
    if (this.#open?.entry === entry) this.#placeList(devicePixelRatio);
  }

  #describe(entry) {
    const parameter = this.#parameters[entry.parameter];
    if (!parameter) return;
    const { node, text } = entry;
    node.dataset.name = parameter.name;
    if (entry.choice) {
      text.textContent = choiceTitle(String(entry.value ?? ""));
      node.setAttribute("aria-label", `${parameter.title}: ${text.textContent}`);
    } else {
      text.textContent = parameter.title;
      node.setAttribute("aria-pressed", String(Boolean(entry.value)));
    }
    if (this.#open?.entry === entry) this.#markChosen();
  }

  // --- What a click or a key does ---

  #entryOf(node) {
    const button = node.closest?.(".pill");
    return button && [...this.#entries.values()].find((entry) => entry.node === button);
  }

  #hover(event) {
    const entry = event.type === "pointerover" && event.pointerType !== "touch" ? this.#entryOf(event.target) : null;
    const hovered = entry?.choice ? entry : null;
    if (hovered === this.#hovered) return;
    this.#hovered = hovered;
    this.#host.changed();
  }

  #click(event) {
    const option = event.target.closest?.(".option");
    if (option) return this.#choose(option);
    const entry = this.#entryOf(event.target);
    const parameter = entry && this.#parameters[entry.parameter];
    if (!parameter) return;
    if (!entry.choice) return this.#host.set(parameter.name, !parameter.value);
    if (this.#open) this.#close();
    else this.#openList(entry, this.#touched);
  }

  /** Buttons with their middles, for the order of the Tab key. */
  stops() {
    return [...this.#entries.values()]
      .filter(({ node }) => !node.inert)
      .map(({ node, box: [x0, y0, x1, y1] }) => ({ node, x: (x0 + x1) / 2, y: (y0 + y1) / 2 }));
  }

  #isOfOpen(node) {
    return this.#open.list.contains(node) || this.#open.entry.node.contains(node);
  }

  #openList(entry, touch = false) {
    const parameter = this.#parameters[entry.parameter];
    const options = entry.options.map(({ value }) =>
      make(
        "div",
        { class: "option", role: "option", tabindex: "-1", "data-value": value },
        make("span", {}, choiceTitle(value)),
        makeIcon("tick", "m3.5 8.5 3 3 6-7"),
      ),
    );
    const list = make(
      "div",
      { class: "options", role: "listbox", part: "options", "data-control": true, "aria-label": parameter.title },
      ...options,
    );
    list.addEventListener("pointermove", (event) => event.target.closest(".option")?.focus({ preventScroll: true }));
    this.#open = { entry, list, touch, style: "" };
    list.toggleAttribute("data-touch", touch);
    entry.node.setAttribute("aria-expanded", "true");
    this.#layer.append(list);
    this.#placeList(devicePixelRatio);
    this.#markChosen();
    (list.querySelector('[aria-selected="true"]') ?? options[0])?.focus({ preventScroll: true });
    this.#host.changed();
  }

  #placeList(devicePixelRatio) {
    const { entry, list } = this.#open;
    const boxes = entry.options.map(({ box }) => box);
    if (boxes.length === 0) return;
    const least = (i) => Math.min(...boxes.map((box) => box[i]));
    const most = (i) => Math.max(...boxes.map((box) => box[i]));
    const box = [least(0), least(1), most(2), most(3)];
    place(this.#open, list, this.#roomyBox(box, boxes.length), devicePixelRatio);
  }

  // The layout leaves room for rows that a mouse can hit; under a finger they are higher, and the list stays in the picture.
  #roomyBox([x0, y0, x1, y1], rows) {
    const height = Math.max(y1 - y0, this.#open.touch ? rows * kTouchRowPx : 0);
    const top = (y0 + y1 - height) / 2;
    const lowest = Math.max(kListMarginPx, this.#layer.offsetHeight - height - kListMarginPx);
    const y = height > y1 - y0 ? Math.min(Math.max(top, kListMarginPx), lowest) : y0;
    return [x0, y, x1, y + height];
  }

  #markChosen() {
    const { entry, list } = this.#open;
    for (const option of list.children) option.setAttribute("aria-selected", String(option.dataset.value === entry.value));
  }

  #choose(option) {
    const { entry } = this.#open;
    const { name } = this.#parameters[entry.parameter];
    const value = option.dataset.value;
    this.#close(true);
    if (value !== entry.value) this.#host.set(name, value);
  }

  #close(takeFocus = false) {
    const { entry, list } = this.#open;
    this.#open = null;
    entry.node.setAttribute("aria-expanded", "false");
    if (takeFocus) entry.node.focus({ preventScroll: true });
    list.remove();
    this.#host.changed();
  }

  #focusOut(event) {
    const { relatedTarget } = event;
    if (this.#open && relatedTarget && !this.#isOfOpen(relatedTarget)) this.#close();
  }

  #keyDown(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.#open && !this.#isOfOpen(event.target)) return;
    if (this.#open ? this.#listKey(event) : this.#pillKey(event)) {
      event.preventDefault();
      event.stopPropagation();
    }
  }

  #pillKey(event) {
    const entry = this.#entryOf(event.target);
    this.#touched = false;
    if (!entry?.choice || !["ArrowDown", "ArrowUp"].includes(event.key)) return false;
    this.#openList(entry);
    return true;
  }

  #listKey(event) {
    const options = [...this.#open.list.children];
    const at = options.indexOf(event.target);
    const go = (index) => options[Math.min(Math.max(index, 0), options.length - 1)]?.focus({ preventScroll: true });
    switch (event.key) {
      case "ArrowDown":
        go(at + 1);
        return true;
      case "ArrowUp":
        go(at - 1);
        return true;
      case "Home":
      case "PageUp":
        go(0);
        return true;
      case "End":
      case "PageDown":
        go(options.length - 1);
        return true;
      case "Enter":
      case " ":
        if (at >= 0) this.#choose(options[at]);
        else this.#close(true);
        return true;
      case "Escape":
        this.#close(true);
        return true;
      case "Tab":
        this.#close(true); // and on from the pill, as from a select
        return false;
    }
    if (event.key.length !== 1) return false;
    const typed = event.key.toLowerCase();
    const following = [...options.slice(at + 1), ...options.slice(0, at + 1)];
    following.find((option) => option.dataset.value.toLowerCase().startsWith(typed))?.focus({ preventScroll: true });
    return true;
  }
}

// On whole device pixels, where borders are crispest. `memory.style` spares what is the same.
function place(memory, node, [x0, y0, x1, y1], devicePixelRatio) {
  const snap = (v) => Math.round(v * devicePixelRatio) / devicePixelRatio;
  const style = `${snap(x0)} ${snap(y0)} ${snap(x1 - x0)} ${snap(y1 - y0)}`;
  if (memory.style === style) return;
  memory.style = style;
  node.style.transform = `translate(${snap(x0)}px, ${snap(y0)}px)`;
  node.style.width = `${snap(x1 - x0)}px`;
  node.style.height = `${snap(y1 - y0)}px`;
}
