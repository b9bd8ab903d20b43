import { make, setEnabled } from "./dom.js";
import { travelOf } from "./editor_keys.js";
import { choiceTitle, decimalsOf, keySteps, kUnits, numberText } from "./numbers.js";
import { beyondSentence } from "./spoken.js";

const kIcons = "assets/icons/icons.svg";
const kMostSegments = 4; // more choices than these go into a menu
const kIdle = "No effect as the model is now.";

function makeIcon(name) {
  const kSvg = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(kSvg, "svg");
  svg.setAttribute("aria-hidden", "true");
  const use = document.createElementNS(kSvg, "use");
  use.setAttribute("href", `${kIcons}#${name}`);
  svg.append(use);
  return svg;
}

const nameOfRow = (target) => target?.closest?.(".row")?.dataset.name ?? null;

/**
 * Form controls for every parameter, grouped. Shows what the editor says and tells the editor what the visitor sets; it holds
 * no values of its own.
 */
export class Panel {
  #rows = new Map(); // name -> row
  #measures = null; // the list under the rows
  #hovered = null; // the name of the row under the mouse
  #focused = null; // and of the one in use
  #host;

  /**
   * @param {HTMLElement} container
   * @param {object} host
   *   set(values), slide(name, value), step(name, steps), endSlide(): what the visitor sets; never throw
   *   read(name, text): the number that a typed text means; throws an Error for the visitor
   *   refresh(name): asks for a call of refresh() with that parameter
   *   point(name): the row in use or under the mouse, or null
   *   travel("undo" | "redo"): a step through the history
   *   mark(): the decimal mark
   *   help(sentence): what to say of the row in use, or ""
   *   tell(sentence): to those who hear the page
   */
  constructor(container, host) {
    this.container = container;
    this.#host = host;
    container.addEventListener("focusin", (event) => this.#focusOn(event.target));
    container.addEventListener("focusout", (event) => this.#focusOn(event.relatedTarget));
    container.addEventListener("pointerover", (event) => event.pointerType === "mouse" && this.#hoverOn(event.target));
    container.addEventListener("pointerleave", () => this.#hoverOn(null));
  }

  #focusOn(target) {
    this.#helpWith(target);
    this.#focused = nameOfRow(target);
    this.#host.point(this.#hovered ?? this.#focused);
  }

  #hoverOn(target) {
    const name = nameOfRow(target);
    if (name === this.#hovered) return;
    this.#hovered = name;
    this.#host.point(this.#hovered ?? this.#focused);
  }

  #helpWith(target) {
    const id = target?.closest?.("[aria-describedby]")?.getAttribute("aria-describedby");
    this.#host.help(document.getElementById(id?.split(" ")[0] ?? "")?.textContent ?? "");
  }

  /** Builds the rows anew: another document. */
  build(parameters) {
    this.#rows.clear();
    const groups = new Map();
    for (const parameter of parameters)
      groups.set(parameter.group, [...(groups.get(parameter.group) ?? []), parameter]);
    const sections = [...groups].map(([group, members], index) => {
      const heading = make("h2", { id: `group-${index}` }, group || "General");
      const rows = members.map((parameter) => this.#makeRow(parameter));
      return make("section", { "aria-labelledby": heading.id }, heading, ...rows);
    });
    this.container.replaceChildren(...sections);
    this.show(parameters);
  }

  /**
   * Shows these values.
   * @param {object[]} parameters as getParameters() gives them
   * @param {boolean} live whether they are changing right now, by the visitor's hand in the picture
   */
  show(parameters, live = false) {
    for (const parameter of parameters) {
      const row = this.#rows.get(parameter.name);
      if (!row) continue;
      const changed = row.value !== parameter.value;
      row.node.toggleAttribute("data-live", live && (changed || row.node.hasAttribute("data-live")));
      row.node.toggleAttribute("data-changed", parameter.value !== parameter.default);
      setEnabled(row.reset, parameter.value !== parameter.default);
      if (!changed) continue;
      row.value = parameter.value;
      row.show(parameter);
      if (live) row.node.scrollIntoView({ block: "nearest" });
    }
  }

  /** Marks the rows of what the model has nothing of as it is now, such as the pitch of a flat roof: they can be set for later. */
  markIdle(names) {
    for (const [name, row] of this.#rows) {
      const idle = names.includes(name);
      row.node.toggleAttribute("data-idle", idle);
      row.node.title = idle ? kIdle : "";
      row.idle.hidden = !idle;
    }
  }

  /** Shows one value as it is, over whatever was typed. */
  refresh(parameter) {
    this.#rows.get(parameter.name)?.show(parameter, true);
  }

  /** Shows what follows from the parameters and cannot be set: under the rows, when there is anything of the kind. */
  showMeasures(measures) {
    this.#measures ??= make("dl");
    const section = this.#measures.closest("section");
    if (measures.length === 0) return section?.remove();
    if (!section?.isConnected) {
      const heading = make("h2", { id: "group-measures" }, "Overall");
      this.container.append(make("section", { class: "measures", "aria-labelledby": heading.id }, heading, this.#measures));
    }
    const rows = measures.map(({ title, text, help }) => make("div", { title: help || null }, make("dt", {}, title), make("dd", {}, text)));
    this.#measures.replaceChildren(...rows);
  }

  /** The default of every parameter that is not at it. */
  defaults(parameters) {
    return Object.fromEntries(parameters.filter((p) => p.value !== p.default).map((p) => [p.name, p.default]));
  }

  #makeRow(parameter) {
    const id = `parameter-${parameter.name}`;
    const reset = make(
      "button",
      {
        type: "button",
        class: "reset",
        "aria-label": `Reset ${parameter.title}`,
        title: "Reset",
      },
      makeIcon("reset"),
    );
    reset.addEventListener("click", () => {
      if (this.#rows.get(parameter.name).value === parameter.default) return;
      this.#host.set({ [parameter.name]: parameter.default });
      this.#host.tell(`${parameter.title} is reset.`);
    });
    // The help is a tooltip for the mouse, a description for screen readers, and for the row in use the page shows it.
    const help = parameter.help ? make("p", { id: `${id}-help`, hidden: true }, parameter.help) : null;
    const build = { bool: makeSwitch, choice: makeChoice }[parameter.type] ?? makeNumber;
    const { head, body, show } = build(parameter, id, help?.id ?? null, this.#host);
    const node = make(
      "div",
      { class: `row ${parameter.type}`, "data-name": parameter.name },
      make("div", { class: "head", title: parameter.help }, ...head, reset),
      ...body,
      ...(help ? [help] : []),
    );
    // The head's last control stands at the right edge, the reset button before it.
    const control = head[1];
    if (control) node.firstChild.append(control);
    const idle = make("span", { class: "sr-only", hidden: true }, kIdle);
    head[0].after(idle);
    this.#rows.set(parameter.name, { node, reset, idle, show, value: undefined });
    return node;
  }
}

function makeNumber(parameter, id, helpId, host) {
  const { name, title, min, max } = parameter;
  const step = parameter.step || "any";
  const decimals = decimalsOf(parameter);
  const unit = kUnits[parameter.unit] ?? parameter.unit;
  const label = make("label", { for: id }, title);
  const problem = make("p", { class: "problem", id: `${id}-problem`, role: "alert" });
  const input = make("input", {
    type: "text",
    class: "number",
    role: "spinbutton",
    id,
    inputmode: min < 0 ? "text" : decimals ? "decimal" : "numeric",
    enterkeyhint: "done",
    autocomplete: "off",
    spellcheck: "false",
    "aria-valuemin": min,
    "aria-valuemax": max,
    "aria-describedby": [helpId, problem.id].filter(Boolean).join(" "),
  });
  const range = make("input", { type: "range", min, max, step, "aria-label": title, "aria-describedby": helpId });
  let now = parameter;
  const complain = (sentence) => {
    problem.textContent = sentence;
    input.setAttribute("aria-invalid", String(Boolean(sentence)));
  };
  const show = (shown, whole = false) => {
    const other = now.value !== shown.value;
    now = shown;
    const text = numberText(shown.value, decimals, host.mark());
    // What is being typed stays as it is, unless the value is another one by now.
    if (whole || other || document.activeElement !== input) {
      const typed = input.value !== text;
      input.value = text;
      if (whole || other || typed) complain("");
    }
    input.setAttribute("aria-valuenow", shown.value);
    input.setAttribute("aria-valuetext", `${text} ${unit}`.trim());
    range.value = shown.value;
    range.setAttribute("aria-valuetext", `${text} ${unit}`.trim());
    range.style.setProperty("--share", max > min ? (shown.value - min) / (max - min) : 0);
  };
  // As it stands in the field it may be rounded: it is the value that is there already.
  const isAsShown = () => input.value === numberText(now.value, decimals, host.mark());
  const take = () => {
    if (input.value.trim() === "") return host.refresh(name);
    if (isAsShown()) {
      if (input.ariaInvalid === "true") complain(""); // what was wrong is gone; what was said of a value stays
      return;
    }
    let value;
    try {
      value = host.read(name, input.value);
    } catch (error) {
      return complain(error.message); // and what was typed stays, to be mended
    }
    host.set({ [name]: value });
    host.refresh(name);
    problem.textContent = beyondSentence(parameter, value, host.mark());
  };
  let before = parameter.value;
  range.addEventListener("pointerdown", () => (before = now.value));
  range.addEventListener("input", () => host.slide(name, range.valueAsNumber));
  // A slider that is let go of where it began tells of no change.
  for (const type of ["change", "pointerup"]) range.addEventListener(type, () => host.endSlide());
  // A finger that came down on the slider scrolls the panel: nothing was meant to change.
  range.addEventListener("pointercancel", () => {
    if (now.value !== before) host.slide(name, before);
    host.endSlide();
  });
  input.addEventListener("change", take);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") {
      take();
      input.select();
    } else if (event.key === "Escape") {
      host.refresh(name);
    } else if (travelOf(event) && isAsShown()) {
      // Nothing is typed that the browser could take back.
      event.preventDefault();
      host.travel(travelOf(event));
    } else if (["ArrowUp", "ArrowDown", "PageUp", "PageDown"].includes(event.key)) {
      event.preventDefault();
      host.step(name, keySteps(event));
    }
  });
  input.addEventListener("keyup", () => host.endSlide());
  input.addEventListener("blur", () => host.endSlide());
  input.addEventListener("focus", () => input.select());
  const field = make(
    "span",
    { class: "field" },
    input,
    make("span", { class: unit === "°" ? "unit close" : "unit", "aria-hidden": "true" }, unit),
  );
  return { head: [label, field], body: [problem, range], show };
}

function makeSwitch(parameter, id, helpId, host) {
  const input = make("input", { type: "checkbox", role: "switch", id, "aria-describedby": helpId });
  input.addEventListener("change", () => host.set({ [parameter.name]: input.checked }));
  const show = ({ value }) => (input.checked = value);
  return { head: [make("label", { for: id }, parameter.title), input], body: [], show };
}

function makeChoice(parameter, id, helpId, host) {
  const { name, title, choices } = parameter;
  if (choices.length > kMostSegments) {
    const select = make(
      "select",
      { id, "aria-describedby": helpId },
      ...choices.map((choice) => make("option", { value: choice }, choiceTitle(choice))),
    );
    select.addEventListener("change", () => host.set({ [name]: select.value }));
    return { head: [make("label", { for: id }, title)], body: [select], show: ({ value }) => (select.value = value) };
  }
  const caption = make("span", { class: "caption", id: `${id}-title` }, title);
  const inputs = choices.map((choice, index) => {
    const input = make("input", { type: "radio", name: id, id: `${id}-${index}`, value: choice });
    input.addEventListener("change", () => host.set({ [name]: choice }));
    return input;
  });
  const segments = make(
    "div",
    { class: "segments", role: "radiogroup", "aria-labelledby": caption.id, "aria-describedby": helpId },
    ...inputs.map((input) => make("label", {}, input, make("span", {}, choiceTitle(input.value)))),
  );
  const show = ({ value }) => inputs.forEach((input) => (input.checked = input.value === value));
  return { head: [caption], body: [segments], show };
}
