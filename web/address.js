/**
 * What the page's address says: which model is shown, and after a # the values that are not its defaults, as in
 * ?model=house#Width=9.7&RoofType=hip. So a reload, a bookmark, the browser's way back and a link that is sent to somebody
 * all lead to what was there to be seen.
 */

import { beyondSentence } from "./spoken.js";

const kModelKey = "model";
const kMostProblems = 5; // then an address is not one of ours, and nobody reads on
const kDigits = 10; // of a number: more than anybody sets, and fewer than arithmetic leaves

/** The name of the model that an address asks for, or null. */
export function modelOf(url) {
  return new URL(url).searchParams.get(kModelKey) || null;
}

/** An address with another model in it, and no values. */
export function withModel(url, model) {
  const address = new URL(url);
  address.searchParams.set(kModelKey, model);
  address.hash = "";
  return address.href;
}

/**
 * An address with these values in it.
 * @param {object[]} parameters as getParameters() gives them
 */
export function withValues(url, parameters) {
  const address = new URL(url);
  const changed = parameters.filter((p) => p.value !== p.default);
  address.hash = new URLSearchParams(changed.map((p) => [p.name, textOf(p.value)])).toString();
  return address.href;
}

const textOf = (value) => String(typeof value === "number" ? Number(value.toPrecision(kDigits)) : value);

/**
 * The values that an address asks for.
 * @param {object[]} parameters as getParameters() gives them
 * @returns {{values: Record<string, number | boolean | string>, problems: string[]}} problems: a sentence for each that cannot be had
 */
export function valuesOf(url, parameters) {
  const values = {};
  const problems = [];
  for (const [name, text] of new URLSearchParams(new URL(url).hash.slice(1))) {
    if (problems.length === kMostProblems) break;
    const parameter = parameters.find((p) => p.name === name);
    const value = parameter && valueOf(parameter, text);
    if (!parameter) problems.push(`The address asks for “${name}”, which this model does not have.`);
    else if (value === undefined) problems.push(`The address asks for ${parameter.title} to be “${text}”, but it is ${kindOf(parameter)}.`);
    else {
      values[name] = value;
      const beyond = beyondSentence(parameter, value, ".");
      if (beyond) problems.push(beyond);
    }
  }
  return { values, problems };
}

function valueOf({ type, choices }, text) {
  if (type === "bool") return text === "true" || (text === "false" ? false : undefined);
  if (type === "choice") return choices.includes(text) ? text : undefined;
  // Somebody may have typed 9,5 there.
  const number = text.trim() === "" ? Number.NaN : Number(text.replace(/^([^.,]*),([^.,]*)$/, "$1.$2"));
  return Number.isFinite(number) ? number : undefined;
}

function kindOf({ type, choices }) {
  if (type === "bool") return "true or false";
  return type === "choice" ? `one of ${choices.join(", ")}` : "a number";
}
