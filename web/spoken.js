/** Sentences for screen readers. */

import { choiceTitle, valueText } from "./numbers.js";

// More values than this are counted, not read out.
const kMostNamed = 3;

function spokenValue(parameter, mark) {
  if (parameter.type === "bool") return parameter.value ? "on" : "off";
  if (parameter.type === "choice") return choiceTitle(parameter.value);
  return valueText(parameter, mark);
}

/**
 * What a step through the history has changed: "Undone: Roof pitch 35°."
 * @param {"Undone" | "Redone"} word
 * @param {object[]} before the parameters as getParameters() gave them
 * @param {object[]} after the same, afterwards
 * @param {"." | ","} mark the decimal mark
 */
export function changeSentence(word, before, after, mark) {
  const changed = after.filter((parameter, i) => parameter.value !== before[i]?.value);
  if (changed.length === 0) return `Nothing to ${word === "Undone" ? "undo" : "redo"}.`;
  const named = changed.slice(0, kMostNamed).map((parameter) => `${parameter.title} ${spokenValue(parameter, mark)}`);
  const more = changed.length - named.length;
  return `${word}: ${named.join(", ")}${more > 0 ? ` and ${more} more` : ""}.`;
}

/** How many hidden lines and other handles come into view: "2 hidden lines are shown." */
export function hiddenSentence(count) {
  if (count === 0) return "Nothing is hidden in this view.";
  return count === 1 ? "1 hidden line is shown." : `${count} hidden lines are shown.`;
}

/** That a view, as of a flat front from behind, shows nothing whose size could be told. */
export const kNothingInView = "From here no size can be shown. Turn the model.";

/** That a value is at its limit: "Width is at most 15.00 m." */
export const limitSentence = (title, most, text) => `${title} is ${most ? "at most" : "at least"} ${text}.`;

/** The same of a value beyond a parameter's range, which becomes the range's end; "" for one within it, a switch's or a choice's. */
export function beyondSentence(parameter, value, mark) {
  const { title, min, max } = parameter;
  if (typeof value !== "number" || (value >= min && value <= max)) return "";
  return limitSentence(title, value > max, valueText({ ...parameter, value: value > max ? max : min }, mark));
}
