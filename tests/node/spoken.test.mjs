// Sentences for screen readers.
import { test } from "node:test";
import assert from "node:assert/strict";
import { beyondSentence, changeSentence, hiddenSentence, limitSentence } from "../../web/spoken.js";

const pitch = (value) => ({ title: "Roof pitch", type: "angle", unit: "deg", step: 1, value });
const width = (value) => ({ title: "Width", type: "float", unit: "m", step: 0.1, value });
const floors = (value) => ({ title: "Floors", type: "int", unit: "", step: 1, value });
const chimney = (value) => ({ title: "Chimney", type: "bool", unit: "", value });
const roof = (value) => ({ title: "Roof", type: "choice", unit: "", value });

test("a step through the history is told by what it has changed, in the visitor's manner of writing numbers", () => {
  assert.equal(changeSentence("Undone", [pitch(40), width(9)], [pitch(35), width(9)], "."), "Undone: Roof pitch 35°.");
  assert.equal(changeSentence("Redone", [pitch(35), width(9)], [pitch(35), width(9.45)], ","), "Redone: Width 9,45 m.");
  assert.equal(changeSentence("Undone", [chimney(true), roof("gable")], [chimney(false), roof("half-hip")], "."), "Undone: Chimney off, Roof Half hip.");
});

test("of many changes the first are named and the others counted; of none that is said", () => {
  const before = [pitch(1), width(1), floors(1), chimney(true), roof("gable")];
  const after = [pitch(2), width(2), floors(2), chimney(false), roof("hip")];
  assert.equal(changeSentence("Undone", before, after, "."), "Undone: Roof pitch 2°, Width 2.00 m, Floors 2 and 2 more.");
  assert.equal(changeSentence("Undone", before, before, "."), "Nothing to undo.");
  assert.equal(changeSentence("Redone", before, before, "."), "Nothing to redo.");
});

test("hidden lines that come into view are counted, and where there are none that is said", () => {
  assert.equal(hiddenSentence(0), "Nothing is hidden in this view.");
  assert.equal(hiddenSentence(1), "1 hidden line is shown.");
  assert.equal(hiddenSentence(3), "3 hidden lines are shown.");
});

test("a limit is told with its value", () => {
  assert.equal(limitSentence("Width", true, "15.00 m"), "Width is at most 15.00 m.");
  assert.equal(limitSentence("Floors", false, "1"), "Floors is at least 1.");
});

test("a value beyond its range is told, and no other", () => {
  const between = { ...width(9), min: 7, max: 18 };
  assert.equal(beyondSentence(between, 18.01, ","), "Width is at most 18,00 m.");
  assert.equal(beyondSentence(between, 0, "."), "Width is at least 7.00 m.");
  for (const value of [7, 12, 18]) assert.equal(beyondSentence(between, value, "."), "");
  assert.equal(beyondSentence({ ...chimney(true), min: null, max: null }, true, "."), "");
});
