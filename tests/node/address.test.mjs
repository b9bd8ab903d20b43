// What the page's address says of the model and its values.
import { test } from "node:test";
import assert from "node:assert/strict";
import { modelOf, valuesOf, withModel, withValues } from "../../web/address.js";

const kPage = "https://example.org/configure/";
const parameters = [
  { name: "Width", title: "Width", type: "float", unit: "m", min: 7, max: 18, step: 0.1, value: 9, default: 9 },
  { name: "Pitch", title: "Roof pitch", type: "angle", unit: "deg", min: 5, max: 60, step: 1, value: 35, default: 35 },
  { name: "Attic", title: "Attic window", type: "bool", value: true, default: true },
  { name: "Roof", title: "Roof", type: "choice", choices: ["gable", "half hip"], value: "gable", default: "gable" },
];
const changed = (values) => parameters.map((p) => ({ ...p, value: values[p.name] ?? p.value }));

test("the model is in the query, and another one comes without the last one's values", () => {
  assert.equal(modelOf(kPage), null);
  assert.equal(modelOf(`${kPage}?model=boat#Width=9`), "boat");
  assert.equal(withModel(`${kPage}#Width=9.5`, "boat"), `${kPage}?model=boat`);
  assert.equal(withModel(`${kPage}?lang=de&model=house`, "boat"), `${kPage}?lang=de&model=boat`);
});

test("what is not as it was by default stands behind the #, and comes back from there", () => {
  const values = { Width: 9.3, Attic: false, Roof: "half hip" };
  const address = withValues(`${kPage}?model=house#Old=1`, changed(values));
  assert.equal(address, `${kPage}?model=house#Width=9.3&Attic=false&Roof=half+hip`);
  assert.deepEqual(valuesOf(address, parameters), { values, problems: [] });
  assert.equal(withValues(address, parameters), `${kPage}?model=house`);
});

test("a number is written as people write it, not as arithmetic left it", () => {
  assert.equal(withValues(kPage, changed({ Width: 0.1 + 0.2, Pitch: 29.999999999999996 })), `${kPage}#Width=0.3&Pitch=30`);
});

test("a decimal comma is understood, two marks are not", () => {
  assert.deepEqual(valuesOf(`${kPage}#Width=9,5&Pitch=-1,5e1`, parameters).values, { Width: 9.5, Pitch: -15 });
  for (const text of ["1,234.5", "1.234,5", "1,2,3", ",", "1, 5"]) {
    const { values, problems } = valuesOf(`${kPage}#Width=${text}`, parameters);
    assert.deepEqual(values, {}, text);
    assert.equal(problems.length, 1);
  }
});

test("what cannot be had is left out, and said", () => {
  const { values, problems } = valuesOf(`${kPage}#Width=10&Width=wide&Pitch=&Attic=maybe&Roof=dome&Moat=3`, parameters);
  assert.deepEqual(values, { Width: 10 });
  assert.deepEqual(problems, [
    "The address asks for Width to be “wide”, but it is a number.",
    "The address asks for Roof pitch to be “”, but it is a number.",
    "The address asks for Attic window to be “maybe”, but it is true or false.",
    "The address asks for Roof to be “dome”, but it is one of gable, half hip.",
    "The address asks for “Moat”, which this model does not have.",
  ]);
  assert.deepEqual(valuesOf(`${kPage}#Width=Infinity&Pitch=1e999&Attic=constructor`, parameters).values, {});
  assert.equal(valuesOf(`${kPage}#${Array.from({ length: 1000 }, (_, i) => `Moat${i}=1`).join("&")}`, parameters).problems.length, 5);
});

test("a value beyond its range becomes its end, which is said", () => {
  const { values, problems } = valuesOf(`${kPage}#Pitch=85`, parameters);
  assert.deepEqual(values, { Pitch: 85 });
  assert.deepEqual(problems, ["Roof pitch is at most 60°."]);
});
