import { choiceTitle, decimalsOf, kUnits } from "./numbers.js";

const kIcons = "assets/icons/icons.svg";
const kMostSegments = 4; // more choices than these go into a menu

function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) node.setAttribute(name, "");
    else if (value !== false && value !== null) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

function makeIcon(name) {
  const kSvg = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(kSvg, "svg");
  svg.setAttribute("aria-hidden", "true");
  const use = document.createElementNS(kSvg, "use");
  use.setAttribute("href", `${kIcons}#${name}`);
  svg.append(use);
  return svg;
}

/**
 * Form controls for every parameter, grouped. Shows what the editor says and tells the editor what the visitor sets; it holds
 * no values of its own.
 */
export class Panel {
  #rows = new Map(); // name -> row
  #host;

  /**
   * @param {HTMLElement} container
   * @param {{set: (values: object) => void, slide: (name: string, value: number) => void, endSlide: () => void,
   *   refresh: (name: string) => void, help: (sentence: string) => void}} host
   *   refresh: asks for a call of refresh() with that parameter; help: what to say of the row in use, or ""
   */
  constructor(container, host) {
    this.container = container;
    this.#host = host;
    container.addEventListener("focusin", (event) => this.#helpWith(event.target));
    container.addEventListener("focusout", (event) => this.#helpWith(event.relatedTarget));
  }

  #helpWith(target) {
    const id = target?.closest?.("[aria-describedby]")?.getAttribute("aria-describedby");
    this.#host.help(document.getElementById(id ?? "")?.textContent ?? "");
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
      row.reset.disabled = parameter.value === parameter.default;
      if (!changed) continue;
      row.value = parameter.value;
      row.show(parameter.value);
      if (live) row.node.scrollIntoView({ block: "nearest" });
    }
  }

  /** Shows one value as it is, over whatever was typed. */
  refresh(parameter) {
    this.#rows.get(parameter.name)?.show(parameter.value, true);
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
    reset.addEventListener("click", () => this.#host.set({ [parameter.name]: parameter.default }));
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
    this.#rows.set(parameter.name, { node, reset, show, value: undefined });
    return node;
  }
}

function makeNumber(parameter, id, helpId, host) {
  const { name, title, min, max } = parameter;
  const step = parameter.step || "any";
  const decimals = decimalsOf(parameter);
  const unit = kUnits[parameter.unit] ?? parameter.unit;
  const label = make("label", { for: id }, title);
  const input = make("input", {
    type: "number",
    id,
    min,
    max,
    step,
    inputmode: decimals ? "decimal" : "numeric",
    autocomplete: "off",
    "aria-describedby": helpId,
  });
  const range = make("input", { type: "range", min, max, step, "aria-label": title, "aria-describedby": helpId });
  const show = (value, whole = false) => {
    // "9" may stay as it was typed while the field has the focus; a value that is another one is shown.
    if (whole || document.activeElement !== input || Number(input.value) !== value)
      input.value = value.toFixed(decimals);
    range.value = value;
    range.setAttribute("aria-valuetext", `${value.toFixed(decimals)} ${unit}`.trim());
    const share = max > min ? (value - min) / (max - min) : 0;
    range.style.setProperty("--share", share);
  };
  range.addEventListener("input", () => host.slide(name, range.valueAsNumber));
  range.addEventListener("change", () => host.endSlide());
  range.addEventListener("pointercancel", () => host.endSlide());
  input.addEventListener("change", () => {
    const value = input.valueAsNumber;
    if (Number.isFinite(value)) host.set({ [name]: value });
    host.refresh(name);
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") input.select();
    if (event.key === "Escape") host.refresh(name);
  });
  input.addEventListener("focus", () => input.select());
  const field = make(
    "span",
    { class: "field" },
    input,
    make("span", { class: unit === "°" ? "unit close" : "unit", "aria-hidden": "true" }, unit),
  );
  return { head: [label, field], body: [range], show };
}

function makeSwitch(parameter, id, helpId, host) {
  const input = make("input", { type: "checkbox", role: "switch", id, "aria-describedby": helpId });
  input.addEventListener("change", () => host.set({ [parameter.name]: input.checked }));
  const show = (value) => (input.checked = value);
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
    return { head: [make("label", { for: id }, title)], body: [select], show: (value) => (select.value = value) };
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
  const show = (value) => inputs.forEach((input) => (input.checked = input.value === value));
  return { head: [caption], body: [segments], show };
}
