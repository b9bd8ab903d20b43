// The page's contract with scripts and hosts, in the page as it ships.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import {
  call,
  cameraOf,
  launch,
  layoutOf,
  openPage,
  recordEvents,
  settle,
  takeEvents,
  valueOf,
} from "./support/page.mjs";

let browser, tab, page;
before(async () => {
  browser = await launch();
  tab = await openPage(browser, { drawn: false });
  page = tab.page;
  await recordEvents(page);
});
after(async () => {
  await browser?.close();
});

/** The message of the Error that the call throws in the page. */
async function errorOf(method, ...args) {
  return page.evaluate(
    ([name, list]) => {
      try {
        document.querySelector("dimline-editor")[name](...list);
        return null;
      } catch (error) {
        return error instanceof Error ? error.message : "not an Error";
      }
    },
    [method, args],
  );
}

test("ready resolves, and the element is the one of the tag", async () => {
  assert.equal(
    await page.evaluate(async () => {
      const element = document.querySelector("dimline-editor");
      return (await element.ready) === undefined && element.model;
    }),
    "house",
  );
});

test("getParameters describes every parameter", async () => {
  const parameters = await call(page, "getParameters");
  assert.ok(parameters.length >= 14, `the house has ${parameters.length} parameters`);
  assert.equal(new Set(parameters.map((p) => p.name)).size, parameters.length);
  for (const p of parameters) {
    assert.deepEqual(
      Object.keys(p).sort(),
      [
        "annotation",
        "choices",
        "default",
        "group",
        "help",
        "max",
        "min",
        "name",
        "step",
        "title",
        "type",
        "unit",
        "value",
      ],
      p.name,
    );
    assert.ok(p.title && p.help && p.group, `${p.name} has no title, help or group`);
    assert.ok(["m", "deg", "m2", ""].includes(p.unit), p.name);
    assert.deepEqual(p.value, p.default, `${p.name} does not start at its default`);
    if (p.type === "bool") assert.equal(typeof p.value, "boolean");
    else if (p.type === "choice") assert.ok(p.choices.includes(p.value), p.name);
    else {
      assert.ok(["float", "int", "angle"].includes(p.type), p.name);
      assert.ok(p.min <= p.value && p.value <= p.max && p.min < p.max && p.step >= 0, p.name);
      assert.equal(p.unit === "deg", p.type === "angle", p.name);
    }
  }
  assert.deepEqual(new Set(parameters.map((p) => p.type)), new Set(["float", "int", "angle", "bool", "choice"]));
});

test("setParameters changes, clamps, and is one undo step", async () => {
  const parameters = await call(page, "getParameters");
  const [a, b] = parameters.filter((p) => p.type === "float");
  await takeEvents(page);
  await call(page, "setParameters", { [a.name]: a.max + 1000, [b.name]: b.min });
  await settle(page);
  assert.equal(await valueOf(page, a.name), a.max);
  assert.equal(await valueOf(page, b.name), b.min);
  assert.deepEqual(await takeEvents(page), ["input", "change"]);
  await call(page, "undo");
  await settle(page);
  assert.deepEqual(await call(page, "getParameters"), parameters);
  await call(page, "redo");
  await settle(page);
  assert.equal(await valueOf(page, a.name), a.max);
  await call(page, "undo");
  await settle(page);
  assert.deepEqual(await call(page, "getParameters"), parameters);
});

test("every type of parameter can be set", async () => {
  const parameters = await call(page, "getParameters");
  const values = {};
  for (const p of parameters) {
    if (p.type === "bool") values[p.name] = !p.value;
    else if (p.type === "choice") values[p.name] = p.choices.find((choice) => choice !== p.value);
    else values[p.name] = p.value === p.min ? p.max : p.min;
  }
  await call(page, "setParameters", values);
  await settle(page);
  const now = Object.fromEntries((await call(page, "getParameters")).map((p) => [p.name, p.value]));
  assert.deepEqual(now, values);
  await call(page, "undo");
  await settle(page);
  assert.deepEqual(await call(page, "getParameters"), parameters);
});

test("setParameters refuses what it cannot mean, says so, and changes nothing", async () => {
  const parameters = await call(page, "getParameters");
  const named = (type) => parameters.find((p) => p.type === type).name;
  const cases = [
    [{ Wdith: 9 }, /Wdith/],
    [{ [named("float")]: "9" }, new RegExp(named("float"))],
    [{ [named("float")]: true }, new RegExp(named("float"))],
    [{ [named("int")]: null }, new RegExp(named("int"))],
    [{ [named("bool")]: 1 }, new RegExp(named("bool"))],
    [{ [named("choice")]: "thatched" }, /thatched/],
    [{ [named("choice")]: 0 }, new RegExp(named("choice"))],
    [{ [named("angle")]: [30] }, new RegExp(named("angle"))],
    [{ [named("float")]: 5, Nope: 1 }, /Nope/],
    [null, /object/],
    [[1], /object/],
    ["Width", /object/],
  ];
  for (const [values, pattern] of cases) {
    const message = await errorOf("setParameters", values);
    assert.match(message ?? "no error", pattern, JSON.stringify(values));
    assert.ok(message.length > 20 && message.length < 300, `not a sentence: ${message}`);
  }
  // JSON cannot carry these into the page.
  const messages = await page.evaluate(
    (name) =>
      [NaN, Infinity, undefined, 1n, Symbol("x")].map((value) => {
        try {
          document.querySelector("dimline-editor").setParameters({ [name]: value });
          return "no error";
        } catch (error) {
          return error.message;
        }
      }),
    named("float"),
  );
  for (const message of messages) assert.match(message, new RegExp(named("float")));
  assert.deepEqual(await call(page, "getParameters"), parameters);
});

test("a camera is given back as it was set", async () => {
  const start = await cameraOf(page);
  const perspective = { eye: [12.5, 7.25, 21], target: [0.5, 3, -1], up: [0, 1, 0], fovDeg: 40 };
  await takeEvents(page);
  await call(page, "setCamera", perspective);
  await settle(page);
  assert.deepEqual(roundedCamera(await cameraOf(page)), perspective);
  assert.ok((await takeEvents(page)).includes("camera-change"));
  const orthographic = { eye: [0, 3, 30], target: [0, 3, 0], up: [0, 1, 0], orthoHeight: 14 };
  await call(page, "setCamera", orthographic);
  await settle(page);
  assert.deepEqual(roundedCamera(await cameraOf(page)), orthographic);
  assert.equal(await page.evaluate(() => document.querySelector("dimline-editor").orthographic), true);
  assert.equal(await page.getAttribute("#projection", "aria-pressed"), "true");
  await call(page, "setCamera", start);
  await settle(page);
  assert.deepEqual(await cameraOf(page), start);
});

function roundedCamera(camera) {
  return JSON.parse(
    JSON.stringify(camera, (_, value) => (typeof value === "number" ? Number(value.toFixed(9)) : value)),
  );
}

test("setCamera refuses what is no camera, and says so", async () => {
  const start = await cameraOf(page);
  for (const [camera, pattern] of [
    [null, /camera/i],
    [{ target: [0, 0, 0], fovDeg: 35 }, /eye/],
    [{ eye: [1, 2], target: [0, 0, 0], fovDeg: 35 }, /eye/],
    [{ eye: [1, 2, "3"], target: [0, 0, 0], fovDeg: 35 }, /eye/],
    [{ eye: [1, 2, 3], target: [1, 2, 3], fovDeg: 35 }, /./],
    [{ eye: [1, 2, 3], target: [0, 0, 0], fovDeg: 190 }, /fov|field of view/i],
    [{ eye: [1, 2, 3], target: [0, 0, 0], orthoHeight: -4 }, /height/i],
  ]) {
    assert.match((await errorOf("setCamera", camera)) ?? "no error", pattern, JSON.stringify(camera));
    assert.notEqual(await errorOf("setCamera", camera), null, JSON.stringify(camera));
  }
  assert.deepEqual(await cameraOf(page), start);
});

test("layout has the frame's fields, and every annotated parameter once", async () => {
  const frame = await layoutOf(page);
  const box = await page.locator("dimline-editor").boundingBox();
  assert.deepEqual(frame.size, [box.width, box.height]);
  assert.equal(frame.view.length, 16);
  assert.equal(frame.projection.length, 16);
  assert.ok(frame.lines.length >= 4, `only ${frame.lines.length} lines`);
  for (const line of frame.lines) {
    assert.ok(["outside", "guide", "inside"].includes(line.placement), line.parameter);
    assert.equal(line.base.world.length, 2);
    assert.equal(line.line.screen.length, 2);
    assert.equal(line.extensions.length, 2);
    assert.ok(line.identity && line.text && line.handles.length > 0, line.parameter);
    if (line.label) assert.equal(line.label.box.length, 4);
  }
  // The members of a chain are lines of one parameter; without a chain there is one line.
  const shown = new Map();
  for (const { parameter, chain } of frame.lines) {
    assert.ok(
      !shown.has(parameter) || (chain !== null && shown.get(parameter) !== null),
      `${parameter} has several lines without a chain`,
    );
    shown.set(parameter, chain);
  }
  const reasons = new Set(["occluded", "out-of-view", "too-short", "foreshortened", "crowded", "no-scope"]);
  for (const { parameter, reason } of frame.hidden) {
    assert.ok(!shown.has(parameter), `${parameter} is both shown and hidden`);
    assert.ok(reasons.has(reason), `${parameter} is hidden because ${reason}`);
  }
  const accounted = [...shown.keys(), ...frame.others.map((o) => o.parameter), ...frame.hidden.map((h) => h.parameter)];
  assert.equal(new Set(accounted).size, shown.size + frame.others.length + frame.hidden.length);
  const drawn = (await call(page, "getParameters")).filter((p) =>
    /type=(linear|diametric|radial|spherical)/.test(p.annotation),
  );
  for (const { name } of drawn) assert.ok(accounted.includes(name), `${name} is neither shown nor hidden`);
});

test("each label's element stands in its layout's box, and is as wide", async () => {
  const frame = await layoutOf(page);
  const angles = frame.others.filter((other) => other.type === "angular");
  const labelled = [...frame.lines, ...angles.map((arc) => ({ ...arc, label: { box: arc.box } }))].filter((line) => line.label);
  assert.ok(labelled.length >= 3);
  const shown = await page.evaluate(() => {
    const editor = document.querySelector("dimline-editor");
    const origin = editor.getBoundingClientRect();
    return [...editor.shadowRoot.querySelectorAll(".label:not([data-textless])")].map((node) => {
      const range = document.createRange();
      range.selectNodeContents(node);
      const [box, text] = [node.getBoundingClientRect(), range.getBoundingClientRect()];
      return {
        text: node.textContent,
        box: [box.left - origin.left, box.top - origin.top, box.right - origin.left, box.bottom - origin.top],
        textWidth: text.width,
      };
    });
  });
  assert.equal(shown.length, labelled.length);
  for (const line of labelled) {
    const [x0, y0, x1, y1] = line.label.box;
    const match = shown.find(
      (label) => label.text === line.text && Math.hypot(label.box[0] - x0, label.box[1] - y0) < 1,
    );
    assert.ok(match, `no label "${line.text}" at ${line.label.box}`);
    assert.ok(
      Math.abs(match.textWidth - (x1 - x0)) < 0.5,
      `"${line.text}" is ${match.textWidth} px wide, its box ${x1 - x0}`,
    );
    assert.ok(Math.abs(match.box[3] - y1) < 1);
  }
});

test("input while a value moves, one change and one undo step at its end", async () => {
  const { name, min, max, value } = (await call(page, "getParameters")).find((p) => p.type === "float");
  await takeEvents(page);
  for (let i = 1; i <= 5; ++i) {
    await call(page, "setParameterContinuous", name, min + ((max - min) * i) / 6);
    await settle(page);
  }
  await call(page, "endContinuous");
  await settle(page);
  assert.deepEqual(await takeEvents(page), ["input", "input", "input", "input", "input", "change"]);
  await call(page, "undo");
  await settle(page);
  assert.equal(await valueOf(page, name), value);
});

test("a model that there is not: an error event, and the document stays", async () => {
  await takeEvents(page);
  const before = await layoutOf(page);
  const message = await page.evaluate(
    () =>
      new Promise((resolve) => {
        const editor = document.querySelector("dimline-editor");
        editor.addEventListener(
          "error",
          (event) => resolve(event.error instanceof Error ? event.message : "no Error"),
          { once: true },
        );
        editor.model = "castle";
      }),
  );
  assert.match(message, /castle/);
  assert.match(message, /house/, "the message should say what there is");
  await settle(page);
  assert.deepEqual((await layoutOf(page)).lines, before.lines);
  await page.evaluate(() => (document.querySelector("dimline-editor").model = "house"));
  await settle(page);
  assert.deepEqual(
    (await takeEvents(page)).filter((type) => type !== "camera-change"),
    ["error", "load"],
  );
});

test("initial-values: what a model begins with, by attribute or by property", async () => {
  const begun = await page.evaluate(async () => {
    const kinds = [
      (editor) => editor.setAttribute("initial-values", '{"Width": 9.7, "RoofType": "hip"}'),
      (editor) => (editor.initialValues = { Width: 10.4 }),
      (editor) => (editor.initialValues = (parameters) => ({ Width: parameters.find((p) => p.name === "Width").max })),
      (editor) => editor.setAttribute("initial-values", "Width=9"),
      (editor) => editor.setAttribute("initial-values", '{"Moat": 3}'),
      (editor) => (editor.initialValues = new Map([["Width", 9]])),
      (editor) =>
        (editor.initialValues = () => {
          throw undefined;
        }),
    ];
    const results = [];
    for (const give of kinds) {
      const editor = document.createElement("dimline-editor");
      editor.model = "house";
      editor.style.cssText = "position: fixed; inset: 0 auto auto 0; width: 400px; height: 300px";
      give(editor);
      let problem = "";
      let atLoad = null;
      editor.addEventListener("error", (event) => ((problem = event.message), event.stopPropagation()));
      editor.addEventListener("load", () => (atLoad = editor.getParameters().find((p) => p.name === "Width").value));
      document.body.append(editor);
      await editor.ready;
      const { value, max, default: byDefault } = editor.getParameters().find((p) => p.name === "Width");
      results.push({ value, max, byDefault, atLoad, problem, canUndo: editor.canUndo });
      editor.remove();
    }
    return results;
  });
  const [attribute, object, made, noJson, unknown, map, thrower] = begun;
  assert.deepEqual([attribute.value, attribute.atLoad, attribute.canUndo, attribute.problem], [9.7, 9.7, false, ""]);
  assert.deepEqual([object.value, object.atLoad], [10.4, 10.4]);
  assert.equal(made.value, made.max);
  for (const wrong of [noJson, unknown, map, thrower]) assert.equal(wrong.value, wrong.byDefault);
  assert.match(noJson.problem, /initial-values.*JSON/);
  assert.match(unknown.problem, /Moat/);
  assert.match(map.problem, /Map/);
  assert.match(thrower.problem, /could not be loaded/);
});

test("an element that knew its properties before its class, and another model with values of its own in one task", async () => {
  const seen = await page.evaluate(async () => {
    const editor = document.createElement("div");
    const early = document.createElement("dimline-editor");
    // As if they had been set before the class was known.
    for (const [name, value] of Object.entries({ model: "house", initialValues: { Width: 9.7 }, orthographic: true, linesShown: false })) {
      Object.defineProperty(early, name, { value, writable: true, configurable: true, enumerable: true });
    }
    early.style.cssText = "position: fixed; inset: 0 auto auto 0; width: 400px; height: 300px";
    editor.append(early);
    document.body.append(editor);
    const events = [];
    for (const type of ["load", "error", "change"]) early.addEventListener(type, (event) => (events.push(type), event.stopPropagation()));
    await early.ready;
    const valueOf = (name) => early.getParameters().find((p) => p.name === name).value;
    const first = { width: valueOf("Width"), attribute: early.getAttribute("model"), orthographic: early.getCamera().fovDeg === undefined, linesShown: early.linesShown };
    early.model = "boat";
    early.initialValues = { Length: 30 };
    await early.settled();
    const second = { length: valueOf("Length"), canUndo: early.canUndo };
    editor.remove();
    return { first, second, events };
  });
  assert.deepEqual(seen.first, { width: 9.7, attribute: "house", orthographic: true, linesShown: false });
  assert.deepEqual(seen.second, { length: 30, canUndo: false });
  assert.deepEqual(seen.events, ["load", "load"]);
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
