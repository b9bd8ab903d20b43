/**
 * A value typed on its line: an edit field in place of the label. It lives until what is in it is accepted or given up; text that
 * is no value stays where it is, with the reason beside it, so that nothing that was typed is lost.
 */

import { make } from "./dom.js";

// ms and px. A second press this soon and this near is a double click, although the first one has put the field there.
const kDoubleMs = 450;
const kDoublePx = 24;

const kMarginPx = 6; // from the picture's edge
const kLeastWidthPx = 44;

export class ValueField {
  #layer;
  #host;
  #node;
  #input;
  #mirror;
  #note;
  #name = null; // of the parameter that is edited; null while there is no field
  #start = ""; // the text that stands for the present value
  #centre = [0, 0];
  #at = [0, 0]; // its corner
  #opened = { ms: -Infinity, x: 0, y: 0 };
  #style = "";

  /**
   * @param {HTMLElement} layer
   * @param {object} host
   *   parameter(name): as getParameters() gives it, with text: the text that an edit of its value starts with
   *   accept(name, text): takes the value, or throws an Error with a sentence for the visitor
   *   neighbour(name, direction): the name of the line that Tab goes to, or null
   *   boxOf(name): where its label is, or null
   *   cover(name): hides that label; focus(name): gives the focus to its line
   *   reset(name): on a double click; changed(): a frame is wanted
   * @param {AbortSignal} signal
   */
  constructor(layer, host, signal) {
    this.#layer = layer;
    this.#host = host;
    this.#mirror = make("span", { class: "mirror", "aria-hidden": "true" });
    this.#input = make("input", {
      type: "text",
      size: 1, // its width is the mirror's
      autocomplete: "off",
      autocapitalize: "off",
      spellcheck: "false",
      enterkeyhint: "done",
      "aria-describedby": "value-note",
    });
    this.#note = make("p", { class: "note", id: "value-note", role: "alert" });
    this.#node = make("div", { class: "value-field", "data-control": true, part: "value-field" }, this.#mirror, this.#input, this.#note);
    this.#input.addEventListener(
      "input",
      (event) => {
        event.stopPropagation(); // the element's own `input` says that a value has changed
        this.#typed();
      },
      { signal },
    );
    this.#input.addEventListener("blur", () => this.#left(), { signal });
    this.#node.addEventListener("keydown", (event) => this.#keyDown(event), { signal });
    this.#node.addEventListener("keyup", (event) => event.stopPropagation(), { signal });
    this.#node.addEventListener("pointerdown", (event) => this.#pressed(event), { signal });
  }

  /** The name of the parameter that is being typed, or null. */
  get name() {
    return this.#name;
  }

  /** What it covers of the picture, [x0, y0, x1, y1]; null while there is no field. */
  get box() {
    if (this.#name === null) return null;
    const [x, y] = this.#at;
    return [x, y, x + this.#node.offsetWidth, y + this.#node.offsetHeight];
  }

  /** Whether a sentence beside it says what is wrong. */
  get complains() {
    return this.#name !== null && this.#note.textContent !== "";
  }

  /**
   * Opens the field on a line, all selected.
   * @param {string} name
   * @param {{text?: string, pointer?: {x: number, y: number}}} [options] text: what to begin with instead of the value;
   *   pointer: where a click opened it, in the window
   */
  open(name, { text, pointer } = {}) {
    if (this.#name === name) return;
    if (this.#name !== null && !this.#accept()) return this.#input.focus({ preventScroll: true });
    const parameter = this.#host.parameter(name);
    const box = this.#host.boxOf(name);
    if (!parameter || !box) return;
    this.#name = name;
    this.#start = parameter.text;
    this.#opened = pointer ? { ms: performance.now(), ...pointer } : { ms: -Infinity, x: 0, y: 0 };
    const input = this.#input;
    input.value = text ?? parameter.text;
    input.setAttribute("aria-label", parameter.title);
    // A phone's keys for numbers have neither units nor signs; what can be negative needs them all.
    input.inputMode = parameter.min < 0 ? "text" : parameter.type === "int" ? "numeric" : "decimal";
    this.#complain("");
    this.#typed();
    this.#layer.append(this.#node);
    this.#style = "";
    this.follow();
    this.#host.cover(name);
    input.focus({ preventScroll: true });
    if (text === undefined) input.select();
  }

  /** Stays where its label is, which moves with the view. */
  follow() {
    if (this.#name === null) return;
    const box = this.#host.boxOf(this.#name);
    if (box) this.#centre = [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2];
    this.#host.cover(this.#name);
    this.#place();
  }

  /** Gives up what is in it. */
  close() {
    if (this.#name === null) return;
    this.#name = null;
    this.#host.cover(null);
    this.#host.changed();
    this.#node.remove();
  }

  #place() {
    const { offsetWidth: width, offsetHeight: height } = this.#node;
    const { offsetWidth: stageWidth, offsetHeight: stageHeight } = this.#layer;
    const within = (at, size, most) => Math.round(Math.min(Math.max(at - size / 2, kMarginPx), Math.max(kMarginPx, most - size - kMarginPx)));
    const x = within(this.#centre[0], width, stageWidth);
    const y = within(this.#centre[1], height, stageHeight);
    // The sentence goes below, or above where there is no room, and not over the picture's edge.
    const { offsetWidth: noteWidth, offsetHeight: noteHeight } = this.#note;
    const above = y + height + noteHeight + 2 * kMarginPx > stageHeight;
    const shift = within(x + width / 2, noteWidth, stageWidth) - x;
    this.#at = [x, y];
    const style = `${x} ${y} ${above} ${shift}`;
    if (style === this.#style) return;
    this.#style = style;
    this.#node.style.transform = `translate(${x}px, ${y}px)`;
    this.#note.style.left = `${shift}px`;
    this.#note.toggleAttribute("data-above", above);
  }

  #typed() {
    this.#mirror.textContent = this.#input.value;
    this.#node.style.minWidth = `${kLeastWidthPx}px`;
    if (this.#note.textContent) this.#complain("");
    if (this.#node.isConnected) this.#place();
  }

  #complain(sentence) {
    this.#note.textContent = sentence;
    this.#node.toggleAttribute("data-wrong", Boolean(sentence));
    this.#input.setAttribute("aria-invalid", String(Boolean(sentence)));
    this.#host.changed();
    if (sentence) this.#place();
  }

  /** Takes what is in it, and closes; false when that is no value. */
  #accept() {
    const name = this.#name;
    const text = this.#input.value;
    if (text.trim() !== "" && text !== this.#start) {
      try {
        this.#host.accept(name, text);
      } catch (error) {
        this.#complain(error.message);
        return false;
      }
    }
    this.close();
    return true;
  }

  // The visitor turned to something else: a value is taken, anything else waits for the visitor to come back to it.
  #left() {
    if (this.#name !== null && document.hasFocus()) this.#accept();
  }

  #keyDown(event) {
    event.stopPropagation(); // here keys are text, not commands
    if (event.isComposing) return;
    const name = this.#name;
    if (event.key === "Enter") {
      event.preventDefault();
      if (this.#accept()) this.#host.focus(name);
    } else if (event.key === "Escape") {
      event.preventDefault();
      this.close();
      this.#host.focus(name);
    } else if (event.key === "Tab") {
      const next = this.#host.neighbour(name, event.shiftKey ? -1 : 1);
      if (!this.#accept()) return event.preventDefault();
      this.#host.focus(name);
      // At the last line the browser goes on from there.
      if (next === null) return;
      event.preventDefault();
      this.open(next);
    }
  }

  #pressed(event) {
    const { ms, x, y } = this.#opened;
    const near = Math.hypot(event.clientX - x, event.clientY - y) <= kDoublePx;
    if (performance.now() - ms > kDoubleMs || !near || this.#input.value !== this.#start) return;
    const name = this.#name;
    event.preventDefault();
    this.close();
    this.#host.reset(name);
  }
}
