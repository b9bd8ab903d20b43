/**
 * All that lies over the picture as DOM: labels, switches and choices, what is typed, what is said; and the taps, cursors and the
 * order of the Tab key that go with them. It decides nothing about values: it asks the core, and shows what the core says.
 */

import { cursorAlong, dragDirection } from "./cursors.js";
import { make } from "./dom.js";
import { DragReadouts } from "./drag_readouts.js";
import { LabelLayer } from "./label_layer.js";
import { stepped } from "./numbers.js";
import { PillLayer } from "./pill_layer.js";
import { Readout } from "./readout.js";
import { kNothingInView, limitSentence } from "./spoken.js";
import { arrange, readingOrder } from "./tab_order.js";
import { ValueField } from "./value_field.js";

// The keyboard as a pointer: no browser gives this id to one.
const kKeyboardId = -2;
const kBehindTipPx = 5;

export class Overlay {
  #stage;
  #handles = make("div", { class: "handles" });
  #host;
  #labels;
  #pills;
  #live = make("p", { class: "live", role: "status" }); // what screen readers are told
  #readout;
  #dragReadouts;
  #field;
  #parameters = [];
  #measures = [];
  #empty = false; // nothing is shown that could be taken hold of
  #hover = { name: null, cursor: "" }; // the cursor over the handle that the mouse rests on
  #saidOf = null; // the name of the parameter that the last sentence was about
  #pointedAt = null; // the name of the parameter that a control elsewhere is about
  #byKeys = false; // the keyboard was used last, and what has its focus is marked as if the mouse were there
  #marked = ""; // where that is

  /**
   * @param {HTMLElement} stage the picture's box, with the canvas in it
   * @param {object} host
   *   core(): null while there is none
   *   act(call): runs a change of the document or the view, and wants a frame after it; throws what it throws
   *   guard(call): runs a call in which nothing can go wrong but the core itself
   *   changed(): a frame is wanted
   * @param {AbortSignal} signal ends all listening
   */
  constructor(stage, host, signal) {
    this.#stage = stage;
    this.#host = host;
    stage.append(this.#handles, this.#live);
    const handleHost = {
      changed: host.changed,
      step: (name, steps) => host.act((core) => this.#step(core, name, steps)),
      endAdjusting: () => host.guard(() => this.#endAdjusting()),
      set: (name, value) => host.act((core) => core.setParameters({ [name]: value })),
      edit: (name, text) => host.guard(() => this.#field.open(name, { text })),
      reset: (name) => this.#reset(name),
    };
    this.#handles.addEventListener("focusin", () => this.#usedKeys(), { signal });
    this.#handles.addEventListener("keydown", () => this.#usedKeys(), { signal });
    this.#handles.addEventListener("focusout", () => this.#usedKeys(), { signal });
    this.#labels = new LabelLayer(this.#handles, handleHost, signal);
    this.#pills = new PillLayer(this.#handles, handleHost, signal);
    this.#readout = new Readout(stage);
    // What was said was about what was done before.
    stage.addEventListener("pointerdown", () => this.#silence(), { signal, capture: true });
    this.#dragReadouts = new DragReadouts(stage);
    this.#field = new ValueField(stage, this.#fieldHost(), signal);
  }

  /** Forgets what it shows: another document. */
  clear() {
    this.#field.close();
    this.#labels.clear();
    this.#readout.silence();
    this.announce("");
    this.#saidOf = this.#pointedAt = null;
    this.#marked = "";
    this.#hover = { name: null, cursor: "" };
  }

  /**
   * What there is to say of the lines.
   * @param {object[]} parameters as Core.parameters() gives them
   * @param {object[]} measures as Core.measures() gives them
   * @param {"." | ","} mark the decimal mark
   */
  describe(parameters, measures, mark) {
    this.#parameters = parameters;
    this.#measures = measures;
    this.#labels.describe(parameters, measures, mark);
    this.#pills.describe(parameters);
  }

  /**
   * Shows the frame that was drawn last.
   * @param {import("./core.js").Core} core
   * @param {import("./pointer_input.js").PointerInput} input
   * @param {boolean} rests whether nothing is going to move by itself
   */
  update(core, input, rests) {
    const labels = core.labels();
    const gestures = core.gestures();
    const dragged = gestures.length > 0;
    const pills = core.pills();
    this.#pills.update(pills, devicePixelRatio);
    this.#labels.update(labels, devicePixelRatio);
    this.#field.follow();
    input.dragDirection = gestures.find(({ pointer }) => pointer !== "touch")?.direction;
    if (dragged) this.#hover.name = null; // its line turns, and the cursor with it
    const focused = dragged || input.active ? null : this.#markFocused(core);
    const name = focused ? this.#titleOf(focused.name) : this.#hoveredName(labels);
    if (this.#saidOf !== null) this.#readout.moveSentence(this.#labels.boxOf(this.#saidOf));
    if (dragged) this.#readout.silence();
    const cost = (box) => core.coverCost(box);
    this.#dragReadouts.update(gestures.map((gesture) => this.#named(gesture)), cost);
    this.#readout.update(dragged || this.#field.complains ? "" : name, input.last, focused && (this.#field.box ?? focused.box), cost);
    // Where the Tab key goes is a matter of the picture at rest: nothing changes places under a finger.
    if (!rests || input.active) return;
    this.#sayIfEmpty(core, labels.length + pills.length);
    arrange(this.#handles, readingOrder([...this.#labels.stops(), ...this.#pills.stops()]));
  }

  // Once, when the picture comes to rest with nothing to take hold of.
  #sayIfEmpty(core, count) {
    const isEmpty = ({ lines, others }) => lines.length + others.length === 0;
    const empty = count === 0 && this.#parameters.length > 0 && core.linesShown && isEmpty(core.layout());
    if (empty && !this.#empty) this.say(null, kNothingInView);
    this.#empty = empty;
  }

  /** The mouse is in use: what it points at shall be marked, and not what has the focus or what pointAt() has named; false for the line whose value is being typed, which stays marked. */
  pointed() {
    if (this.#field.name !== null) return false;
    this.#byKeys = false;
    this.#pointedAt = null;
    this.#marked = "";
    return true;
  }

  /** Marks a parameter's line as if it had the focus, until the mouse points at the picture itself; null for none. */
  pointAt(name) {
    this.#pointedAt = name;
    this.#host.changed();
  }

  /** Closes a field that waits, out of focus, for what is in it to be mended; false when there is none. */
  giveUpTyping() {
    if (this.#field.name === null) return false;
    this.#field.close();
    return true;
  }

  #usedKeys() {
    this.#byKeys = true;
    this.#host.changed();
  }

  // Shows where the focus is by more than a ring: the core marks the line and what it drives, as under a mouse.
  #markFocused(core) {
    const focused = (this.#pointedAt && this.#labels.placeOf(this.#pointedAt)) ?? this.#focused();
    if (!focused && !this.#byKeys && !this.#marked) return null;
    let at = null;
    if (focused?.handle) {
      // A little from the arrow's tip, where two lines of a chain meet, towards the number.
      const [x, y] = focused.handle;
      const [dx, dy] = [(focused.box[0] + focused.box[2]) / 2 - x, (focused.box[1] + focused.box[3]) / 2 - y];
      const share = Math.min(1, kBehindTipPx / (Math.hypot(dx, dy) || 1));
      at = [x + dx * share, y + dy * share];
    }
    const marked = at ? at.map(Math.round).join(" ") : "";
    if (marked !== this.#marked) {
      this.#marked = marked;
      if (at) core.hover(kKeyboardId, "mouse", 0, ...at, 0);
      else core.endHover();
      this.#host.changed();
    }
    return focused;
  }

  #focused() {
    if (!this.#byKeys) return null;
    return this.#field.name === null ? this.#labels.focused : this.#labels.placeOf(this.#field.name);
  }

  #hoveredName(labels) {
    const line = labels.find((label) => label.hovered);
    if (!line) return this.#pills.hovered?.title ?? "";
    const title = line.measure ? this.#measures.find(({ name }) => name === line.name)?.title : this.#titleOf(line.name);
    return line.box ? title : `${title}  ${line.text}`; // a line without a text tells its value here
  }

  #parameter(name) {
    return this.#parameters.find((candidate) => candidate.name === name);
  }

  #named(gesture) {
    const { title, type } = this.#parameter(gesture.parameter);
    return { ...gesture, title, canBeFine: type !== "int" };
  }

  #titleOf(name) {
    return this.#parameter(name)?.title ?? name;
  }

  // From the value as it is by now: keys may come faster than frames.
  #step(core, name, steps) {
    const parameter = core.parameters().find((candidate) => candidate.name === name);
    const value = stepped(parameter, steps);
    if (value === parameter.value) this.announce(limitSentence(parameter.title, steps > 0, core.inputText(name)));
    else core.setParameterContinuous(name, value);
  }

  #endAdjusting() {
    this.#host.core().endContinuous();
    this.#host.changed();
  }

  // --- What a tap means, and what the mouse's arrow looks like ---

  /** @param {{x: number, y: number, touch: boolean, target: string, clientX: number, clientY: number}} tap */
  tapped({ x, y, touch, target, clientX, clientY }) {
    const label = this.#labels.labelAt(x, y, touch);
    // Beside a number its line's arrow may be nearer.
    if (!label || (!label.inside && target === "handle")) return;
    this.#labels.choose(label);
    this.#field.open(label.name, { pointer: { x: clientX, y: clientY } });
    this.#usedKeys();
  }

  doubleTapped({ x, y, touch }) {
    const name = this.#host.core().handleAt(x, y, touch ? "touch" : "mouse") ?? this.#labels.labelAt(x, y, touch)?.name;
    if (name) this.#reset(name);
  }

  /** The cursor for a mouse that rests there. */
  cursorAt(x, y, onHandle) {
    if (!onHandle) {
      this.#hover.name = null;
      return this.#labels.labelAt(x, y, false) ? "text" : "";
    }
    // The layout is asked once for each handle that the mouse comes to, not for each pixel.
    const core = this.#host.core();
    const name = core.handleAt(x, y, "mouse");
    if (this.#hover.name !== name) {
      const direction = name && dragDirection(core.layout(), name, x, y);
      this.#hover = { name, cursor: direction ? cursorAlong(direction) : "handle" };
    }
    return this.#hover.cursor;
  }

  // --- Values by hand ---

  #fieldHost() {
    return {
      parameter: (name) => {
        const parameter = this.#parameter(name);
        return parameter && { ...parameter, text: this.#host.core().inputText(name) };
      },
      accept: (name, text) => this.#host.act((core) => this.#accept(core, this.#parameter(name), text)),
      neighbour: (name, direction) => this.#labels.neighbour(name, direction),
      boxOf: (name) => this.#labels.boxOf(name),
      cover: (name) => this.#labels.cover(name),
      focus: (name) => {
        if (this.#labels.boxOf(name)) this.#labels.focus(name);
        else this.#stage.querySelector("canvas").focus({ preventScroll: true });
      },
      reset: (name) => this.#reset(name),
      changed: this.#host.changed,
    };
  }

  // What is beyond the range becomes its end, and that is said.
  #accept(core, { name, title, min, max }, text) {
    const value = core.parseValue(name, text);
    this.#silence();
    core.setParameters({ [name]: value });
    if (value > max || value < min) {
      this.say(name, limitSentence(title, value > max, core.inputText(name)));
    }
  }

  #reset(name) {
    this.#host.guard(() => {
      this.#host.act((core) => core.resetParameter(name));
      this.say(name, `${this.#titleOf(name)} reset to ${this.#host.core().inputText(name)}.`);
    });
  }

  #silence() {
    this.#readout.silence();
    this.#host.changed();
  }

  /** Tells screen readers a sentence. */
  announce(sentence) {
    this.#live.textContent = sentence;
  }

  /** Says a sentence to all: beside a parameter's handle, or in the middle of the picture. */
  say(name, sentence) {
    this.announce(sentence);
    const middle = [this.#stage.offsetWidth / 2, this.#stage.offsetHeight / 2];
    this.#saidOf = name;
    const lastsMs = this.#readout.say(sentence, this.#labels.boxOf(name) ?? [...middle, ...middle]);
    this.#host.changed();
    setTimeout(this.#host.changed, lastsMs + 50);
  }
}
