// Editing through web/core.js: texts that become values, what a drag leads to, measures, hidden lines.
import { test } from "node:test";
import assert from "node:assert/strict";
import { createCore } from "../../web/core.js";

const kModule = new URL("../../build/wasm/dimline.js", import.meta.url);

async function openCore(t, model = "house") {
  const core = await createCore({ url: kModule });
  t.after(() => core.dispose());
  core.setModel(model);
  core.resize(1000, 1000, 1);
  let nowMs = 0;
  const settle = () => {
    let frames = 0;
    while ((core.frame((nowMs += 16)) || !core.atRest) && ++frames < 1000);
    assert.ok(frames < 1000, "the core comes to rest");
  };
  settle();
  core.takeEvents();
  return { core, settle, value: (name) => core.parameters().find((parameter) => parameter.name === name).value };
}

/** A line, where its moving end is, and which way that points on screen. */
function endOf(core, name) {
  const line = core.layout().lines.find((candidate) => candidate.parameter === name);
  const [from, to] = line.line.screen;
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return { line, at: to, along: [(to[0] - from[0]) / length, (to[1] - from[1]) / length] };
}

test("what a visitor types is read in units, sums and either decimal mark, or refused with a sentence", async (t) => {
  const { core } = await openCore(t);
  assert.equal(core.parseValue("Width", "3*1.2m + 20 cm"), 3.8);
  assert.equal(core.parseValue("Width", "10'6\""), 3.2004);
  assert.equal(core.parseValue("Width", "7,5"), 7.5);
  assert.equal(core.parseValue("RoofPitch", "35°"), 35);
  assert.equal(core.parseValue("Floors", "1 + 2"), 3);
  assert.equal(core.parseValue("RoofType", "Hip"), "hip");
  assert.throws(() => core.parseValue("Width", "3 apples"), /"3 apples" is not a length: "apples" is no unit\. Try 13\.00, 1300 cm or 42'8"\./);
  assert.throws(() => core.parseValue("Floors", "2.5"), /whole numbers/);
  assert.throws(() => core.parseValue("Windth", "2"), /no parameter "Windth"/);
});

test("an edit field's text is the value again, in the visitor's numbers", async (t) => {
  const { core, settle } = await openCore(t);
  assert.equal(core.inputText("Width"), "13.00 m");
  core.setNumberFormat({ decimal: "," });
  settle();
  assert.equal(core.inputText("Width"), "13,00 m");
  assert.equal(core.parseValue("Width", core.inputText("Width")), 13);
  assert.equal(endOf(core, "Width").line.text, "13,00 m");
  assert.throws(() => core.setNumberFormat({ decimal: ";" }), /"\." or ","/);
});

test("a gesture says what it has led to, is fine with shift, and free with alt", async (t) => {
  const { core, settle, value } = await openCore(t);
  assert.deepEqual(core.gestures(), []);
  const { at, along } = endOf(core, "Width");
  const to = (px) => [at[0] + along[0] * px, at[1] + along[1] * px];
  assert.equal(core.pointerDown(1, "mouse", 0, ...at, 0), "handle");
  assert.equal(core.gestures()[0].difference, "");
  core.pointerMove(1, "mouse", 0, ...to(20), 0);
  settle();
  const moved = core.gestures()[0];
  assert.deepEqual([moved.parameter, moved.kind, moved.limit, moved.pointer, moved.snap], ["Width", "line", null, "mouse", "step"]);
  assert.equal(moved.value, value("Width"));
  assert.match(moved.difference, /^\+\d\.\d\d m$/);
  const onStep = (step) => Math.abs(value("Width") / step - Math.round(value("Width") / step)) < 1e-6;
  assert.ok(onStep(0.1));
  assert.ok(Math.hypot(...moved.direction) > 0.999);
  // In the picture the handle is under the pointer, to within the value's step.
  assert.ok(Math.hypot(moved.handle[0] - to(20)[0], moved.handle[1] - to(20)[1]) < 3);
  core.pointerMove(1, "mouse", 0, ...to(21.3), 1);
  settle();
  assert.equal(core.gestures()[0].snap, "fine");
  assert.ok(onStep(0.01));
  core.pointerMove(1, "mouse", 0, ...to(21.3), 4);
  assert.equal(core.gestures()[0].snap, "none");
  core.pointerMove(1, "mouse", 0, ...to(3000), 0);
  settle();
  assert.equal(core.gestures()[0].limit, "max");
  core.cancelPointer(7); // another pointer's
  assert.deepEqual(core.gestures().map(({ id, parameter }) => [id, parameter]), [[1, "Width"]]);
  core.cancelPointer(1);
  assert.deepEqual(core.gestures(), []);
  assert.equal(value("Width"), 13);
});

test("the parameter at a place is that of its handle or its label; it can be reset in one step", async (t) => {
  const { core, settle, value } = await openCore(t);
  const { at, line } = endOf(core, "Width");
  assert.equal(core.handleAt(...at), "Width");
  const [x0, y0, x1, y1] = line.label.box;
  assert.equal(core.handleAt((x0 + x1) / 2, (y0 + y1) / 2), "Width");
  assert.equal(core.handleAt(3, 3), null);
  core.setParameters({ Width: 15 });
  settle();
  core.resetParameter("Width");
  assert.equal(value("Width"), 13);
  core.undo();
  assert.equal(value("Width"), 15);
});

test("measures are read, and have lines of their own when they are shown", async (t) => {
  const { core, settle } = await openCore(t);
  const measures = core.measures();
  assert.deepEqual(measures.map((measure) => measure.name), ["OverallHeight", "GrossFloorArea"]);
  assert.equal(measures[1].value, 218.4);
  assert.equal(core.layout().measures, undefined);
  assert.equal(core.measuresShown, false);
  const lines = core.layout().lines.length;
  core.measuresShown = true;
  settle();
  const frame = core.layout();
  assert.equal(frame.lines.length, lines);
  assert.equal(frame.measures.length, 1);
  assert.deepEqual(frame.measures[0].handles, []);
  assert.equal(frame.measures[0].text, measures[0].text);
  assert.ok(core.labels().some((label) => label.measure && label.name === "OverallHeight"));
  assert.ok(!core.parameters().some((parameter) => parameter.name === "OverallHeight"));
});

test("hidden lines are shown for as long as they are asked for", async (t) => {
  const { core, settle } = await openCore(t);
  core.setCamera({ eye: [0, 9, -30], target: [0, 3, 0], fovDeg: 35 });
  settle();
  const before = JSON.stringify(core.layout());
  const hidden = core.layout().hidden.filter(({ reason }) => reason !== "out-of-view" && reason !== "no-scope");
  assert.ok(hidden.length > 0);
  core.hiddenShown = true;
  settle();
  const shown = core.layout();
  for (const { parameter } of hidden) {
    assert.ok([...shown.lines, ...shown.others].some((handle) => handle.parameter === parameter), parameter);
  }
  core.hiddenShown = false;
  settle();
  assert.equal(JSON.stringify(core.layout()), before);
});
