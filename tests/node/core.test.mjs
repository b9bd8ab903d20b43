import { test } from "node:test";
import assert from "node:assert/strict";
import createDimlineModule from "../../build/wasm/dimline.js";
import createDimlineGltfModule from "../../build/wasm/dimline_gltf.js";
import { tetrahedronGlb } from "../support/tetrahedron.mjs";

const module = await createDimlineModule();

/** An editor with a model, in a viewport, at rest. */
function openEditor(t, { model = "house", width = 1000, height = 1000 } = {}) {
  const editor = new module.Editor();
  t.after(() => editor.delete());
  editor.resize(width, height, 1);
  assert.equal(editor.setModel(model), "");
  let nowMs = 0;
  const frame = () => editor.frame((nowMs += 16));
  const settle = () => {
    let frames = 0;
    while ((frame() || !editor.atRest()) && ++frames < 1000);
    assert.ok(frames < 1000, "the editor comes to rest");
  };
  settle();
  editor.eventsJson();
  return {
    editor,
    frame,
    settle,
    layout: () => JSON.parse(editor.layoutJson()),
    line: (name) => JSON.parse(editor.layoutJson()).lines.find((line) => line.parameter === name),
    value: (name) => JSON.parse(editor.parametersJson()).find((parameter) => parameter.name === name).value,
    events: () => JSON.parse(editor.eventsJson()),
  };
}

const isPoint = (value, size) => Array.isArray(value) && value.length === size && value.every(Number.isFinite);

const apart = (a, b) => [a[0] - b[0], a[1] - b[1]];
// As in core/constants.h: so far an extension line may be moved aside that would lie on another line.
const kExtensionAsidePx = 4;

/** The frame as web/dimline_editor.d.ts declares it, field by field. */
function checkFrame(frame, parameterNames) {
  assert.deepEqual(Object.keys(frame).sort(), ["hidden", "lines", "others", "projection", "size", "view", "visible"]);
  assert.ok(isPoint(frame.size, 2) && isPoint(frame.view, 16) && isPoint(frame.projection, 16));
  for (const line of frame.lines) {
    assert.ok(parameterNames.includes(line.parameter), line.parameter);
    assert.equal(typeof line.scope, "string");
    assert.ok(Number.isInteger(line.scopeIndex) && line.scopeIndex >= 0);
    assert.ok(["linear-contour", "linear-center", "diametric", "radial", "spherical-diametric", "spherical-radial"].includes(line.type));
    assert.ok(["scope", "object", "billboard", "none"].includes(line.slip));
    assert.ok(Number.isFinite(line.value));
    assert.ok(line.text.length > 0);
    assert.equal(typeof line.indirect, "boolean");
    assert.ok(line.chain === null || Number.isInteger(line.chain) || typeof line.chain === "string");
    assert.ok(["outside", "guide", "inside"].includes(line.placement));
    assert.ok(["scope", "billboard", "object", "none"].includes(line.plane.kind));
    assert.ok(["front", "back", "none"].includes(line.plane.facing));
    assert.ok(isPoint(line.plane.point, 3) && isPoint(line.plane.normal, 3));
    for (const part of [line.base, line.line]) {
      assert.ok(part.world.length === 2 && part.world.every((point) => isPoint(point, 3)));
      assert.ok(part.screen.length === 2 && part.screen.every((point) => isPoint(point, 2)));
    }
    assert.equal(line.extensions.length, 2);
    for (const polyline of line.extensions) assert.ok(polyline.every((point) => isPoint(point, 2)));
    if (line.placement !== "inside") {
      line.extensions.forEach((polyline, end) => {
        const bys = [apart(polyline[0], line.base.screen[end]), apart(polyline.at(-1), line.line.screen[end])];
        for (const by of bys) assert.ok(Math.hypot(...by) < kExtensionAsidePx + 1e-6, `${line.parameter}: ${by}`);
        assert.ok(Math.hypot(...apart(bys[0], bys[1])) < 1e-6, `${line.parameter}: aside as a whole`);
      });
    }
    assert.ok(line.label === null || isPoint(line.label.box, 4));
    assert.ok(line.handles.length >= 1);
    for (const handle of line.handles) {
      assert.ok(["start", "end"].includes(handle.end));
      assert.deepEqual(handle.screen, line.line.screen[handle.end === "end" ? 1 : 0]);
    }
    assert.ok(line.identity.length > 0);
    // World and screen are one line, seen through the frame's own matrices.
    line.line.world.forEach((point, i) => {
      const seen = project(frame, point);
      assert.ok(Math.hypot(seen[0] - line.line.screen[i][0], seen[1] - line.line.screen[i][1]) < 1e-6);
    });
  }
  for (const hidden of frame.hidden) {
    assert.ok(parameterNames.includes(hidden.parameter));
    assert.ok(["occluded", "out-of-view", "too-short", "foreshortened", "crowded", "no-scope"].includes(hidden.reason));
    assert.ok(!frame.lines.some((line) => line.parameter === hidden.parameter));
  }
  for (const [name, index] of frame.visible) assert.ok(typeof name === "string" && Number.isInteger(index));
}

const multiply = (m, v) => [0, 1, 2, 3].map((row) => m[row] * v[0] + m[4 + row] * v[1] + m[8 + row] * v[2] + m[12 + row] * v[3]);
function project(frame, point) {
  const clip = multiply(frame.projection, multiply(frame.view, [...point, 1]));
  return [((clip[0] / clip[3] + 1) / 2) * frame.size[0], ((1 - clip[1] / clip[3]) / 2) * frame.size[1]];
}

test("the core loads without a DOM and knows its models", () => {
  const models = JSON.parse(module.modelsJson());
  const house = models.find((model) => model.name === "house");
  assert.ok(house.title.length > 0);
});

test("the house's parameters are as getParameters() promises", (t) => {
  const { editor } = openEditor(t);
  const parameters = JSON.parse(editor.parametersJson());
  assert.ok(parameters.length >= 10);
  for (const p of parameters) {
    assert.deepEqual(Object.keys(p).sort(),
                     ["annotation", "choices", "default", "group", "help", "max", "min", "name", "step", "title", "type", "unit", "value"]);
    assert.ok(["float", "int", "angle", "bool", "choice"].includes(p.type));
    assert.ok(["m", "deg", "m2", ""].includes(p.unit));
    assert.deepEqual(p.value, p.default);
    if (p.type === "bool") assert.equal(typeof p.value, "boolean");
    else if (p.type === "choice") assert.ok(p.choices.includes(p.value));
    else assert.ok(p.min <= p.value && p.value <= p.max);
  }
});

test("the layout is a FRAME, in motion too", (t) => {
  const stage = openEditor(t);
  const names = JSON.parse(stage.editor.parametersJson()).map((p) => p.name);
  checkFrame(stage.layout(), names);
  assert.ok(stage.layout().lines.length > 5);
  for (let i = 0; i < 40; i++) {
    const angle = i * 0.2;
    const camera = { eye: [30 * Math.sin(angle), 6, 30 * Math.cos(angle)], target: [0, 3, 0], fovDeg: 40 };
    assert.equal(stage.editor.setCameraJson(JSON.stringify(camera)), "");
    stage.frame();
    checkFrame(stage.layout(), names);
  }
});

test("the labels of the DOM are those of the layout", (t) => {
  const stage = openEditor(t);
  const labels = JSON.parse(stage.editor.labelsJson());
  const { lines, others } = stage.layout();
  const arcs = others.filter((other) => other.type === "angular");
  assert.ok(arcs.length > 0);
  assert.equal(labels.length, lines.length + arcs.length);
  assert.equal(new Set(labels.map((label) => label.id)).size, labels.length, "each has an id of its own");
  const placed = [...lines, ...arcs.map((arc) => ({ ...arc, label: { box: arc.box } }))];
  assert.ok(labels.some((label) => label.inside) && labels.some((label) => !label.inside), "of both kinds");
  labels.forEach((label, i) => {
    assert.equal(label.name, placed[i].parameter);
    assert.equal(label.text, placed[i].text);
    assert.equal(label.inside, placed[i].placement === "inside");
    assert.equal(label.opacity, 1);
    assert.equal(label.hovered, false);
    assert.equal(label.dragged, false);
    assert.equal(label.handles.length, placed[i].handles.length);
    if (label.box) label.box.forEach((x, k) => assert.ok(Math.abs(x - placed[i].label.box[k]) <= 0.006));
  });
});

test("switches and choices are those of the layout, with their values and options", (t) => {
  const stage = openEditor(t);
  const pills = JSON.parse(stage.editor.pillsJson());
  const placed = stage.layout().others.filter((other) => other.type !== "angular");
  assert.deepEqual(pills.map((pill) => pill.name), placed.map((other) => other.parameter));
  assert.ok(pills.some((pill) => pill.options.length > 1) && pills.some((pill) => typeof pill.value === "boolean"));
  pills.forEach((pill, i) => {
    assert.equal(pill.value, placed[i].value);
    assert.equal(pill.opacity, 1);
    assert.equal(pill.fading, false);
    pill.box.forEach((x, k) => assert.ok(Math.abs(x - placed[i].box[k]) <= 0.006));
    assert.deepEqual(pill.options.map((option) => option.value), (placed[i].options ?? []).map((option) => option.value));
  });
});

test("without its lines the layout is empty, and with them it is what it was", (t) => {
  const stage = openEditor(t);
  const before = stage.layout();
  stage.editor.setLinesShown(false);
  stage.settle();
  assert.equal(stage.editor.linesShown(), false);
  assert.deepEqual([stage.layout().lines, stage.layout().others], [[], []]);
  assert.equal(stage.editor.labelsJson() + stage.editor.pillsJson(), "[][]");
  stage.editor.setLinesShown(true);
  stage.settle();
  assert.deepEqual(stage.layout(), before);
});

test("dragging the width's handle along its line by what 1 m takes makes the house wider and keeps the handle under the pointer", (t) => {
  const stage = openEditor(t);
  const line = stage.line("Width");
  const before = stage.value("Width");
  const frame = stage.layout();
  const [start, end] = line.line.world;
  const length = Math.hypot(...end.map((x, i) => x - start[i]));
  // Half a metre on: a whole one, if the house grows on both sides.
  const wanted = project(frame, end.map((x, i) => x + ((x - start[i]) / length) * 0.5));
  const grab = line.handles.find((handle) => handle.end === "end").screen;

  assert.equal(stage.editor.hover(1, "mouse", 0, ...grab, 0), "handle");
  assert.equal(stage.editor.pointerDown(1, "mouse", 0, ...grab, 0), "handle");
  assert.equal(stage.editor.pointerMove(1, "mouse", 0, ...wanted, 0), "handle");
  stage.frame();
  const after = stage.value("Width");
  assert.ok(after > before);
  const handle = stage.line("Width").handles.find((h) => h.end === "end").screen;
  const step = JSON.parse(stage.editor.parametersJson()).find((p) => p.name === "Width").step;
  const pxPerStep = (Math.hypot(wanted[0] - grab[0], wanted[1] - grab[1]) / (after - before)) * step;
  assert.ok(Math.hypot(handle[0] - wanted[0], handle[1] - wanted[1]) <= 0.5 * pxPerStep + 0.5);
  assert.deepEqual(stage.events(), ["input"]);
  stage.editor.pointerUp(1, "mouse", 0, ...wanted, 0);
  assert.deepEqual(stage.events(), ["change"]);

  assert.ok(stage.editor.canUndo());
  stage.editor.undo();
  assert.equal(stage.value("Width"), before);
  stage.editor.redo();
  assert.equal(stage.value("Width"), after);
});

test("every line of the house can be dragged there and back, and cancelled", (t) => {
  const stage = openEditor(t);
  for (const name of new Set(stage.layout().lines.map((line) => line.parameter))) {
    const line = stage.line(name);
    const before = stage.value(name);
    const [x, y] = line.handles[0].screen;
    const [from, to] = line.line.screen;
    const along = [to[0] - from[0], to[1] - from[1]].map((d) => d / Math.hypot(to[0] - from[0], to[1] - from[1]));
    const values = new Set();
    assert.equal(stage.editor.pointerDown(1, "mouse", 0, x, y, 0), "handle", name);
    for (const travel of [-300, -40, 40, 300]) {
      stage.editor.pointerMove(1, "mouse", 0, x + along[0] * travel, y + along[1] * travel, 0);
      stage.frame();
      values.add(stage.value(name));
    }
    assert.ok(values.size > 1, `${name} changes`);
    stage.editor.pointerMove(1, "mouse", 0, x, y, 0);
    stage.frame();
    assert.equal(stage.value(name), before, name);
    stage.editor.pointerMove(1, "mouse", 0, x + along[0] * 300, y + along[1] * 300, 0);
    stage.frame();
    stage.editor.cancelGesture();
    assert.equal(stage.value(name), before, name);
    stage.settle();
  }
  assert.equal(stage.editor.canUndo(), false);
});

test("an orbit moves the camera and says so", (t) => {
  const stage = openEditor(t);
  const before = JSON.parse(stage.editor.cameraJson());
  assert.equal(stage.editor.pointerDown(1, "mouse", 0, 5, 5, 0), "camera");
  assert.equal(stage.editor.pointerMove(1, "mouse", 0, 105, 5, 0), "camera");
  stage.editor.pointerUp(1, "mouse", 0, 105, 5, 0);
  const after = JSON.parse(stage.editor.cameraJson());
  assert.deepEqual(stage.events(), ["camera-change"]);
  assert.notDeepEqual(after.eye, before.eye);
  const distance = (camera) => Math.hypot(...camera.eye.map((x, i) => x - camera.target[i]));
  assert.ok(Math.abs(distance(after) - distance(before)) < 1e-9);
});

test("parameters are set together, clamped, and undone in one step", (t) => {
  const stage = openEditor(t);
  const width = stage.value("Width");
  assert.equal(stage.editor.setParametersJson('{"Width": 1e6, "Depth": 9}'), "");
  const max = JSON.parse(stage.editor.parametersJson()).find((p) => p.name === "Width").max;
  assert.equal(stage.value("Width"), max);
  assert.equal(stage.value("Depth"), 9);
  assert.deepEqual(stage.events(), ["input", "change"]);
  stage.editor.undo();
  assert.equal(stage.value("Width"), width);
  assert.equal(stage.editor.canUndo(), false);

  for (const value of [9, 9.5, 10]) assert.equal(stage.editor.setParameterContinuous("Width", JSON.stringify(value)), "");
  stage.editor.endContinuous();
  stage.editor.undo();
  assert.equal(stage.value("Width"), width);
});

test("what goes wrong is said in a sentence, and nothing changes", (t) => {
  const stage = openEditor(t);
  const before = stage.editor.parametersJson() + stage.editor.cameraJson();
  const { editor } = stage;
  assert.match(editor.setModel("castle"), /castle.*house/s);
  assert.match(editor.setParametersJson('{"Widht": 3}'), /Widht/);
  assert.match(editor.setParametersJson('{"Width": "3"}'), /Width/);
  assert.match(editor.setParametersJson('{"Width": NaN}'), /JSON/);
  assert.match(editor.setParameterContinuous("Widht", "3"), /Widht/);
  assert.match(editor.setParameterContinuous("Width", "undefined"), /Width/);
  assert.match(editor.setCameraJson('{"eye": [0, 0], "target": [0, 0, 0]}'), /eye/);
  assert.match(editor.setStandardView("below"), /below/);
  assert.match(editor.setFieldsFrom("moon"), /moon/);
  assert.match(editor.setScene("text"), /Uint8Array/);
  assert.match(editor.setScene(new Uint8Array([1, 2, 3])), /bytes/);
  assert.match(editor.attachContext(0), /WebGL/);
  assert.match(editor.attachContext(99), /WebGL/);
  assert.equal(editor.parametersJson() + editor.cameraJson(), before);
});

test("input that is no number, or in nobody's viewport, is survived", (t) => {
  const stage = openEditor(t);
  const before = stage.editor.layoutJson();
  stage.editor.pointerDown(1, "mouse", 0, NaN, 3, 0);
  stage.editor.pointerMove(1, "mouse", 0, Infinity, 3, 0);
  stage.editor.wheel(NaN, 3, 100, 0);
  stage.editor.resize(NaN, 500, 1);
  stage.editor.frame(NaN);
  stage.settle();
  assert.equal(stage.editor.layoutJson(), before);
  stage.editor.resize(0, 0, 1);
  stage.frame();
  assert.equal(stage.layout().lines.length, 0);
  stage.editor.resize(1000, 1000, 1);
  stage.settle();
  assert.equal(stage.editor.layoutJson(), before);
});

test("a .glb is a document too: its box can be dragged", async (t) => {
  const stage = openEditor(t);
  const reader = await createDimlineGltfModule();
  assert.equal(stage.editor.setScene(reader.importGltf("tetra.glb", tetrahedronGlb(), {}).scene), "");
  stage.settle();
  const names = JSON.parse(stage.editor.parametersJson()).map((p) => p.name);
  assert.deepEqual(names, ["Width", "Height", "Depth"]);
  checkFrame(stage.layout(), names);
  assert.ok(stage.layout().lines.length >= 2);
});

test("fields are measured on demand, and there is no GPU in node", (t) => {
  const { editor } = openEditor(t);
  const fields = JSON.parse(editor.fieldsJson("cpu"));
  assert.equal(fields.width, 1000);
  assert.equal(fields.left.length, 1000);
  assert.equal(fields.top.length, 1000);
  assert.ok(fields.left.some((x) => x === null) && fields.left.some((x) => x > 0));
  assert.equal(JSON.parse(editor.fieldsJson("gpu")), null);
  assert.equal(editor.fieldsFrom(), "auto");
  const timings = JSON.parse(editor.timingsJson());
  for (const key of ["rebuildMs", "fieldsMs", "placeMs", "drawMs"]) assert.ok(timings[key] >= 0, key);
});

test("many editors come and go without the memory growing", () => {
  const open = () => {
    const editor = new module.Editor();
    editor.resize(800, 800, 1);
    editor.setModel("house");
    editor.frame(16);
    editor.delete();
  };
  for (let i = 0; i < 5; i++) open();
  const before = process.memoryUsage().arrayBuffers;
  for (let i = 0; i < 30; i++) open();
  assert.ok(process.memoryUsage().arrayBuffers - before < 8e6);
});
