/**
 * The DOM over the picture: one element for each dimension line and each angle that is shown, which is its text and, for
 * keyboards and screen readers, a slider. Positions and texts are the core's. Switches and choices are pill_layer.js.
 */

import { keySteps, valueText } from "./numbers.js";

// A key with one of these characters begins a number where a line has the focus.
const kNumberKey = /^[0-9.,(-]$/;

// px. What a finger needs; a label with less gets it from the free picture around it.
const kTouchTargetPx = 44;

export class LabelLayer {
  #layer;
  #host;
  #entries = new Map(); // the line's identity -> {node, ...what it shows}
  #parameters = [];
  #measures = [];
  #mark = ".";
  #round = 0;
  #handingOver = false;

  /**
   * @param {HTMLElement} layer may hold other things too
   * @param {{step: (name: string, steps: number) => void, endAdjusting: () => void, edit: (name: string, text?: string) => void,
   *   reset: (name: string) => void}} host
   * @param {AbortSignal} signal
   */
  constructor(layer, host, signal) {
    this.#layer = layer;
    this.#host = host;
    layer.addEventListener("keydown", (event) => this.#keyDown(event), { signal });
    layer.addEventListener("keyup", () => this.#host.endAdjusting(), { signal });
    layer.addEventListener("focusout", () => this.#handingOver || this.#host.endAdjusting(), { signal });
  }

  /**
   * What screen readers say of lines.
   * @param {object[]} parameters as getParameters() gives them
   * @param {object[]} measures as getMeasures() gives them
   * @param {"." | ","} mark the decimal mark
   */
  describe(parameters, measures, mark) {
    this.#parameters = parameters;
    this.#measures = measures;
    this.#mark = mark;
    for (const entry of this.#entries.values()) this.#describe(entry);
  }

  /**
   * Shows these labels and no others.
   * @param {object[]} labels as Core.labels() gives them
   * @param {number} devicePixelRatio texts stand on whole device pixels, where they are crispest
   */
  update(labels, devicePixelRatio) {
    const round = ++this.#round;
    for (const label of labels) {
      const entry = this.#entries.get(label.id) ?? this.#add(label);
      entry.round = round;
      entry.node.removeAttribute("data-left");
      this.#show(entry, label, devicePixelRatio);
    }
    this.#chooseSliders();
    for (const [id, entry] of this.#entries) {
      if (entry.round === round) continue;
      // Where the line has gone while it was being changed, its slider remains until the focus leaves it: the way back.
      if (this.#hasFocus(entry)) {
        entry.node.toggleAttribute("data-left", true);
        continue;
      }
      this.#entries.delete(id);
      entry.node.remove();
    }
  }

  /** Forgets all: another document. */
  clear() {
    for (const { node } of this.#entries.values()) node.remove();
    this.#entries.clear();
  }

  /** The label at a place in the picture (CSS px): for a finger the nearest within its reach. Null for none. */
  labelAt(x, y, touch) {
    let best = null;
    let least = Infinity;
    for (const [id, { box, parameter, editable }] of this.#entries) {
      if (!box || !editable) continue;
      const [x0, y0, x1, y1] = box;
      const reachX = touch ? Math.max(4, (kTouchTargetPx - (x1 - x0)) / 2) : 2;
      const reachY = touch ? Math.max(4, (kTouchTargetPx - (y1 - y0)) / 2) : 2;
      const outX = Math.max(x0 - x, x - x1, 0);
      const outY = Math.max(y0 - y, y - y1, 0);
      if (outX > reachX || outY > reachY) continue;
      const away = Math.hypot(outX, outY) + Math.hypot(x - (x0 + x1) / 2, y - (y0 + y1) / 2) * 1e-3;
      if (away < least) [best, least] = [{ id, name: this.#parameters[parameter]?.name, box, inside: outX + outY === 0 }, away];
    }
    return best;
  }

  /** Makes a label the slider of its parameter, of which it was one of the pictures. */
  choose({ id }) {
    const chosen = this.#entries.get(id);
    for (const entry of this.#entries.values()) {
      if (entry.editable && entry.parameter === chosen.parameter) this.#makeSlider(entry, entry === chosen);
    }
  }

  /** The box of a parameter's slider in the picture, [x0, y0, x1, y1]; of no size for a line without a text. Null when none is shown. */
  boxOf(name) {
    const entry = this.#sliderOf(name);
    return entry && boxOfEntry(entry);
  }

  /** Gives the keyboard's focus to a parameter's slider, if one is shown. */
  focus(name) {
    this.#sliderOf(name)?.node.focus({ preventScroll: true });
  }

  /** Where a parameter's slider is: {name, box, handle: its arrow's tip, or null}; null for none. */
  placeOf(name) {
    const entry = this.#sliderOf(name);
    return entry && { name, box: boxOfEntry(entry), handle: entry.round === this.#round ? entry.handle : null };
  }

  /** The place of the slider that the keyboard is at; null when it is elsewhere, or the focus need not be seen. */
  get focused() {
    const node = this.#layer.getRootNode().activeElement;
    return node?.matches(".label:focus-visible") ? this.placeOf(node.dataset.name) : null;
  }

  /** Sliders with their middles, for the order of the Tab key. */
  stops() {
    return [...this.#entries.values()].filter(({ slider }) => slider).map((entry) => {
      const [x0, y0, x1, y1] = boxOfEntry(entry);
      return { node: entry.node, x: (x0 + x1) / 2, y: (y0 + y1) / 2 };
    });
  }

  /** The name of the parameter whose slider follows this one (or comes before it, for -1) in the order of the Tab key; null at the end. */
  neighbour(name, direction) {
    const nodes = [...this.#layer.children].filter((node) => node.getAttribute("role") === "slider");
    const at = nodes.findIndex((node) => node.dataset.name === name);
    return at < 0 ? null : (nodes[at + direction]?.dataset.name ?? null);
  }

  /** Hides the label behind an edit field that stands in its place; null for none. */
  cover(name) {
    for (const { node, slider } of this.#entries.values()) {
      node.toggleAttribute("data-covered", slider && name !== null && node.dataset.name === name);
    }
  }

  #sliderOf(name) {
    for (const entry of this.#entries.values()) {
      if (entry.slider && entry.node.dataset.name === name) return entry;
    }
    return null;
  }

  // A parameter with several lines is one slider, where its value is written if it is anywhere; the others are its pictures,
  // and so is a line that fades away. A slider stays the slider while its line is there.
  #chooseSliders() {
    const chosen = new Map();
    for (const entry of this.#entries.values()) {
      if (!entry.editable) continue;
      const rank = entry.round !== this.#round ? 0 : (entry.box ? 2 : 1) + (entry.slider ? 2 : 0);
      const best = chosen.get(entry.parameter);
      if (!best || rank > best.rank) chosen.set(entry.parameter, { entry, rank });
    }
    for (const { entry } of chosen.values()) this.#makeSlider(entry, true);
    for (const entry of this.#entries.values()) {
      const heir = chosen.get(entry.parameter)?.entry;
      if (entry === heir) continue;
      // A line that changes its place is another one; the keyboard's focus goes along, before its node can have it no longer.
      if (entry.slider && this.#hasFocus(entry)) this.#handOver(heir);
      this.#makeSlider(entry, false);
    }
  }

  #hasFocus({ node }) {
    return this.#layer.getRootNode().activeElement === node;
  }

  #makeSlider(entry, slider) {
    if (entry.slider === slider) return;
    entry.slider = slider;
    this.#describe(entry);
  }

  #handOver(heir) {
    this.#handingOver = true;
    heir?.node.focus({ preventScroll: true });
    this.#handingOver = false;
  }

  #add(label) {
    const node = document.createElement("div");
    node.className = "label";
    node.setAttribute("part", "label");
    const entry = {
      node,
      parameter: label.parameter,
      measure: label.measure ? label.name : null,
      text: null,
      content: null,
      box: null,
      at: [0, 0],
      handle: null,
      transform: "",
      opacity: "",
      inside: false,
      active: false,
      editable: false,
      slider: null,
      round: 0,
    };
    this.#entries.set(label.id, entry);
    this.#layer.append(node);
    return entry;
  }

  #show(entry, label, devicePixelRatio) {
    const { node } = entry;
    entry.parameter = label.parameter;
    entry.box = label.box;
    entry.at = label.box ?? label.handles[0]?.screen ?? entry.at;
    entry.handle = label.handles.at(-1)?.screen ?? null;
    entry.editable = label.handles.length > 0 && !label.measure;
    if (entry.text !== label.text) {
      entry.text = label.text;
      this.#describe(entry);
    }
    const textless = !label.box;
    const content = textless ? "" : label.text;
    if (entry.content !== content) {
      entry.content = content;
      node.textContent = content;
      node.toggleAttribute("data-textless", textless);
    }
    const snap = (v) => Math.round(v * devicePixelRatio) / devicePixelRatio;
    const transform = `translate(${snap(entry.at[0])}px, ${snap(entry.at[1])}px)`;
    if (entry.transform !== transform) node.style.transform = entry.transform = transform;
    const opacity = label.opacity >= 1 ? "" : String(label.opacity);
    if (entry.opacity !== opacity) node.style.opacity = entry.opacity = opacity;
    const inside = label.inside && !textless;
    if (entry.inside !== inside) {
      entry.inside = inside;
      node.toggleAttribute("data-inside", inside);
    }
    const active = label.hovered || label.dragged;
    if (entry.active !== active) {
      entry.active = active;
      node.toggleAttribute("data-active", active);
    }
  }

  #describe({ node, text, measure, parameter: index, slider }) {
    if (measure !== null) {
      const title = this.#measures.find(({ name }) => name === measure)?.title ?? measure;
      node.setAttribute("role", "img");
      node.setAttribute("aria-label", `${title}: ${text}`);
      return;
    }
    const parameter = this.#parameters[index];
    if (!parameter) return;
    if (!slider) {
      node.removeAttribute("tabindex");
      node.setAttribute("role", "presentation");
      node.setAttribute("aria-hidden", "true");
      return;
    }
    node.tabIndex = 0;
    node.setAttribute("role", "slider");
    node.removeAttribute("aria-hidden");
    node.setAttribute("aria-label", parameter.title);
    node.setAttribute("aria-valuemin", parameter.min);
    node.setAttribute("aria-valuemax", parameter.max);
    node.setAttribute("aria-valuenow", parameter.value);
    node.setAttribute("aria-valuetext", text || valueText(parameter, this.#mark));
    node.dataset.name = parameter.name;
  }

  #keyDown(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (!event.target.classList.contains("label")) return;
    const parameter = this.#parameters.find((p) => p.name === event.target.dataset.name);
    if (!parameter) return;
    const steps = keySteps(event);
    if (steps !== null) this.#host.step(parameter.name, steps);
    else if (event.key === "Enter" || event.key === "F2") this.#host.edit(parameter.name);
    else if (event.key === "Delete" || event.key === "Backspace") this.#host.reset(parameter.name);
    else if (kNumberKey.test(event.key)) this.#host.edit(parameter.name, event.key);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

const boxOfEntry = ({ box, at }) => box ?? [at[0], at[1], at[0], at[1]];
