/**
 * All that lies over the picture as DOM: labels, switches and choices, what is typed, what is said; and the taps, cursors and the
 * order of the Tab key that go with them. It decides nothing about values: it asks the core, and shows what the core says.
 */

import { cursorAlong, dragDirection } from "./cursors.js";
import { make } from "./dom.js";
import { LabelLayer } from "./label_layer.js";
import { stepped } from "./numbers.js";
import { PillLayer } from "./pill_layer.js";
import { Readout } from "./readout.js";
import { arrange, readingOrder } from "./tab_order.js";
import { ValueField } from "./value_field.js";

// From the value as it is by now: keys may come faster than frames.
function step(core, name, steps) {
  const parameter = core.parameters().find((candidate) => candidate.name === name);
  core.setParameterContinuous(name, stepped(parameter, steps));
}

export class Overlay {
  #stage;
  #handles = make("div", { class: "handles" });
  #host;
  #labels;
  #pills;
  #readout;
  #field;
  #parameters = [];
  #measures = [];
  #hover = { name: null, cursor: "" }; // the cursor over the handle that the mouse rests on

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
    const box = make("div", { class: "readout", "aria-hidden": "true" });
    const live = make("p", { class: "live", role: "status" });
    stage.append(this.#handles, box, live);
    const handleHost = {
      changed: host.changed,
      step: (name, steps) => host.act((core) => step(core, name, steps)),
      endAdjusting: () => host.guard(() => this.#endAdjusting()),
      set: (name, value) => host.act((core) => core.setParameters({ [name]: value })),
      edit: (name, text) => host.guard(() => this.#field.open(name, { text })),
      reset: (name) => this.#reset(name),
    };
    this.#labels = new LabelLayer(this.#handles, handleHost, signal);
    this.#pills = new PillLayer(this.#handles, handleHost, signal);
    this.#readout = new Readout(stage, box, live);
    this.#field = new ValueField(stage, this.#fieldHost(), signal);
  }

  /** Forgets what it shows: another document. */
  clear() {
    this.#field.close();
    this.#labels.clear();
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
    const gesture = core.gesture();
    this.#pills.update(core.pills(), devicePixelRatio);
    this.#labels.update(labels, devicePixelRatio);
    this.#field.follow();
    input.dragDirection = gesture?.direction;
    const named = gesture && { ...gesture, title: this.#titleOf(gesture.parameter) };
    this.#readout.update(named, this.#hoveredName(labels), input.last);
    // Where the Tab key goes is a matter of the picture at rest: nothing changes places under a finger.
    if (!rests || input.active) return;
    arrange(this.#handles, readingOrder([...this.#labels.stops(), ...this.#pills.stops()]));
  }

  #hoveredName(labels) {
    if (this.#field.name !== null) return "";
    const line = labels.find((label) => label.hovered);
    if (!line) return this.#pills.hovered?.title ?? "";
    const title = line.measure ? this.#measures.find(({ name }) => name === line.name)?.title : this.#titleOf(line.name);
    return line.box ? title : `${title}  ${line.text}`; // a line without a text tells its value here
  }

  #parameter(name) {
    return this.#parameters.find((candidate) => candidate.name === name);
  }

  #titleOf(name) {
    return this.#parameter(name)?.title ?? name;
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
    if (label && (label.inside || target !== "handle")) this.#field.open(label.name, { pointer: { x: clientX, y: clientY } });
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
    };
  }

  // What is beyond the range becomes its end, and that is said.
  #accept(core, { name, title, min, max }, text) {
    const value = core.parseValue(name, text);
    core.setParameters({ [name]: value });
    if (value > max || value < min) {
      this.#say(name, `${title} is ${value > max ? "at most" : "at least"} ${core.inputText(name)}.`);
    }
  }

  #reset(name) {
    this.#host.guard(() => {
      this.#host.act((core) => core.resetParameter(name));
      this.#say(name, `${this.#titleOf(name)}: ${this.#host.core().inputText(name)} again`);
    });
  }

  #say(name, sentence) {
    const middle = [this.#stage.offsetWidth / 2, this.#stage.offsetHeight / 2];
    const lastsMs = this.#readout.say(sentence, this.#labels.boxOf(name) ?? [...middle, ...middle]);
    setTimeout(this.#host.changed, lastsMs + 50);
  }
}
