/**
 * The DOM over the picture: one element for each dimension line and each angle that is shown, which is its text and, for
 * keyboards and screen readers, a slider. Positions and texts are the core's. Switches and choices are pill_layer.js.
 */

import { stepped } from "./numbers.js";

const kPageSteps = 10; // steps of Page Up and Page Down, and of Shift with an arrow

export class LabelLayer {
  #layer;
  #tip;
  #host;
  #entries = new Map(); // the line's identity -> {node, ...what it shows}
  #parameters = [];
  #shown = 0;
  #handingOver = false;

  /**
   * @param {HTMLElement} layer
   * @param {HTMLElement} tip names the line under the pointer
   * @param {{adjust: (name: string, value: number) => void, endAdjusting: () => void}} host
   * @param {AbortSignal} signal
   */
  constructor(layer, tip, host, signal) {
    this.#layer = layer;
    this.#tip = tip;
    this.#host = host;
    layer.addEventListener("keydown", (event) => this.#keyDown(event), { signal });
    layer.addEventListener("keyup", () => this.#host.endAdjusting(), { signal });
    layer.addEventListener("focusout", () => this.#handingOver || this.#host.endAdjusting(), { signal });
  }

  /** The parameters as getParameters() gives them: names, ranges and values for screen readers. */
  setParameters(parameters) {
    this.#parameters = parameters;
    for (const entry of this.#entries.values()) this.#describe(entry);
  }

  /**
   * Shows these labels and no others.
   * @param {object[]} labels as Core.labels() gives them
   * @param {number} devicePixelRatio texts stand on whole device pixels, where they are crispest
   * @param {{x: number, y: number, touch: boolean}} pointer
   * @param {object | null} control the parameter of another control that the pointer rests on and that should be named
   */
  update(labels, devicePixelRatio, pointer, control = null) {
    const round = ++this.#shown;
    const described = new Set();
    let active = null;
    for (const label of labels) {
      let entry = this.#entries.get(label.id);
      if (!entry) {
        entry = this.#add(label);
      }
      entry.round = round;
      this.#show(entry, label, devicePixelRatio);
      // A parameter with several lines is one slider: the others are its pictures, and so is a line that fades away.
      const first = label.handles.length > 0 && !described.has(label.parameter);
      if (first) described.add(label.parameter);
      if (entry.first !== first) {
        entry.first = first;
        this.#describe(entry);
      }
      if (label.dragged || (label.hovered && !active?.dragged)) active = label;
    }
    for (const [id, entry] of this.#entries) {
      if (entry.round === round) continue;
      this.#entries.delete(id);
      this.#handOver(entry);
      entry.node.remove();
    }
    this.#showTip(active ? this.#tipOf(active) : control?.title, pointer);
  }

  #tipOf(active) {
    const title = this.#parameters[active.parameter]?.title ?? active.name;
    return active.dragged || !active.box ? `${title}  ${active.text}` : title;
  }

  // A line that changes its place is another one; the keyboard's focus goes along.
  #handOver({ node, parameter }) {
    if (this.#layer.getRootNode().activeElement !== node) return;
    for (const heir of this.#entries.values()) {
      if (heir.parameter !== parameter || !heir.first) continue;
      this.#handingOver = true;
      heir.node.focus({ preventScroll: true });
      this.#handingOver = false;
    }
  }

  #add(label) {
    const node = document.createElement("div");
    node.className = "label";
    node.setAttribute("part", "label");
    const entry = {
      node,
      parameter: label.parameter,
      text: null,
      transform: "",
      opacity: "",
      active: false,
      first: null,
      round: 0,
    };
    this.#entries.set(label.id, entry);
    this.#layer.append(node);
    return entry;
  }

  #show(entry, label, devicePixelRatio) {
    const { node } = entry;
    entry.parameter = label.parameter;
    if (entry.text !== label.text) {
      entry.text = label.text;
      node.setAttribute("aria-valuetext", label.text);
      entry.content = null;
    }
    const textless = !label.box;
    const content = textless ? "" : label.text;
    if (entry.content !== content) {
      entry.content = content;
      node.textContent = content;
      node.toggleAttribute("data-textless", textless);
    }
    const [x, y] = label.box ?? label.handles[0]?.screen ?? [0, 0];
    const snap = (v) => Math.round(v * devicePixelRatio) / devicePixelRatio;
    const transform = `translate(${snap(x)}px, ${snap(y)}px)`;
    if (entry.transform !== transform) node.style.transform = entry.transform = transform;
    const opacity = label.opacity >= 1 ? "" : String(label.opacity);
    if (entry.opacity !== opacity) node.style.opacity = entry.opacity = opacity;
    const active = label.hovered || label.dragged;
    if (entry.active !== active) {
      entry.active = active;
      node.toggleAttribute("data-active", active);
    }
  }

  #describe({ node, parameter: index, first }) {
    const parameter = this.#parameters[index];
    if (!parameter) return;
    if (!first) {
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
    node.dataset.name = parameter.name;
  }

  #keyDown(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const parameter = this.#parameters.find((p) => p.name === event.target.dataset?.name);
    if (!parameter) return;
    const large = event.shiftKey ? kPageSteps : 1;
    const moves = {
      ArrowUp: large,
      ArrowRight: large,
      ArrowDown: -large,
      ArrowLeft: -large,
      PageUp: kPageSteps,
      PageDown: -kPageSteps,
      Home: -Infinity,
      End: Infinity,
    };
    if (!(event.key in moves)) return;
    event.preventDefault();
    this.#host.adjust(parameter.name, stepped(parameter, moves[event.key]));
  }

  #showTip(text, pointer) {
    const tip = this.#tip;
    tip.toggleAttribute("data-shown", Boolean(text));
    if (!text) return;
    if (tip.textContent !== text) tip.textContent = text;
    // Beside a mouse's arrow, but above a finger, which hides what is under it.
    const margin = 6;
    const width = tip.offsetWidth;
    const height = tip.offsetHeight;
    const { offsetWidth: stageWidth, offsetHeight: stageHeight } = this.#layer;
    let x = pointer.touch ? pointer.x - width / 2 : pointer.x + 14;
    let y = pointer.touch ? pointer.y - height - 40 : pointer.y + 20;
    if (!pointer.touch && y + height + margin > stageHeight) y = pointer.y - height - 12;
    x = Math.min(Math.max(x, margin), Math.max(margin, stageWidth - width - margin));
    y = Math.min(Math.max(y, margin), Math.max(margin, stageHeight - height - margin));
    tip.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
  }
}
