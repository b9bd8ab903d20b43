// Without a mouse: every parameter in view can be reached, is named, and does what its keys say; and where the focus is can be seen.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { inside, modelNames, sliderOf } from "./support/handles.mjs";
import { call, launch, layoutOf, lineOf, openPage, screenshot, settle, showModel, valueOf } from "./support/page.mjs";
import { decodePng } from "./support/png.mjs";

let browser, tab, page;
before(async () => {
  browser = await launch();
  tab = await openPage(browser, { width: 1100, height: 800, drawn: false });
  page = tab.page;
});
after(async () => {
  await browser?.close();
});

const parameters = () => call(page, "getParameters");
const stops = () =>
  page.evaluate(() =>
    [...document.querySelector("dimline-editor").shadowRoot.querySelectorAll(".label[role=slider], .pill:not([inert])")].map((node) => {
      const { left, top, width, height } = node.getBoundingClientRect();
      return {
        name: node.dataset.name,
        role: node.getAttribute("role") ?? node.localName,
        tabIndex: node.tabIndex,
        label: node.getAttribute("aria-label") ?? node.textContent,
        min: node.getAttribute("aria-valuemin"),
        max: node.getAttribute("aria-valuemax"),
        now: node.getAttribute("aria-valuenow"),
        text: node.getAttribute("aria-valuetext"),
        x: left + width / 2,
        y: top + height / 2,
      };
    }),
  );

test("in every model each parameter in view is one slider or one button, with a name, a range, a value and its unit", async () => {
  for (const model of await modelNames(page)) {
    await showModel(page, model);
    const { lines, others } = await layoutOf(page);
    const shown = new Set([...lines, ...others].map(({ parameter }) => parameter));
    const found = await stops();
    assert.deepEqual(found.map(({ name }) => name).sort(), [...shown].sort(), model);
    const known = new Map((await parameters()).map((p) => [p.name, p]));
    for (const stop of found) {
      const p = known.get(stop.name);
      assert.ok(stop.label.includes(p.title), `${model}: "${stop.label}" does not name ${p.title}`);
      assert.equal(stop.tabIndex, 0, `${model}: ${stop.name}`);
      if (stop.role !== "slider") continue;
      assert.deepEqual([stop.min, stop.max, stop.now].map(Number), [p.min, p.max, p.value], `${model}: ${stop.name}`);
      const sign = { m: " m", deg: "°", m2: " m²", "": "" }[p.unit];
      assert.ok(stop.text.includes(sign) && /\d/.test(stop.text), `${model}: ${stop.name} says "${stop.text}"`);
    }
  }
  await showModel(page, "house");
});

test("the Tab key goes over the picture as it is read: row by row, from left to right", async () => {
  await inside(page, "canvas").focus();
  const order = [];
  const count = (await stops()).length;
  for (let i = 0; i < count; ++i) {
    await page.keyboard.press("Tab");
    order.push(await page.evaluate(() => document.activeElement.shadowRoot?.activeElement?.dataset.name));
  }
  const found = new Map((await stops()).map((stop) => [stop.name, stop]));
  assert.deepEqual([...order].sort(), [...found.keys()].sort(), "the Tab key leaves something out");
  const at = order.map((name) => found.get(name));
  for (let i = 1; i < at.length; ++i) {
    const [from, to] = [at[i - 1], at[i]];
    // The next one is lower, or in the same row and farther right; rows are 24 px high.
    assert.ok(to.y > from.y - 24 && (to.y > from.y || to.x > from.x), `${order[i]} comes after ${order[i - 1]}`);
  }
  for (let i = 0; i < count; ++i) await page.keyboard.press("Shift+Tab");
  assert.equal(await page.evaluate(() => document.activeElement.shadowRoot.activeElement.localName), "canvas");
});

test("arrows, Shift, Page Up and Down, Home and End do what a slider does, each one undo step", async () => {
  for (const name of ["Width", "RoofPitch"]) {
    const { min, max, step, value: start } = (await parameters()).find((p) => p.name === name);
    const slider = sliderOf(page, name);
    for (const [key, expected] of [
      ["ArrowUp", start + step],
      ["ArrowRight", start + step],
      ["ArrowDown", start - step],
      ["ArrowLeft", start - step],
      ["Shift+ArrowRight", start + 10 * step],
      ["Shift+ArrowDown", start - 10 * step],
      ["PageUp", start + 10 * step],
      ["PageDown", start - 10 * step],
      ["Home", min],
      ["End", max],
    ]) {
      await slider.focus();
      await page.keyboard.press(key);
      await settle(page);
      const wanted = Math.min(Math.max(expected, min), max);
      const value = await valueOf(page, name);
      assert.ok(Math.abs(value - wanted) < 1e-9, `${name} by ${key} is ${value}, not ${wanted}`);
      assert.equal(Number(await slider.getAttribute("aria-valuenow")), value);
      if (value === start) continue;
      await page.keyboard.press("Control+z");
      await settle(page);
      assert.equal(await valueOf(page, name), start, `${name}, undone after ${key}`);
    }
  }
});

test("the focus stays on the parameter while its line moves, and can be seen in the picture", async () => {
  const slider = sliderOf(page, "Width");
  await inside(page, "canvas").focus();
  await settle(page);
  const box = await slider.boundingBox();
  const clip = { x: box.x - 14, y: box.y - 14, width: box.width + 28, height: box.height + 28 };
  const without = decodePng(await page.screenshot({ clip }));
  while ((await page.evaluate(() => document.activeElement.shadowRoot?.activeElement?.dataset.name)) !== "Width")
    await page.keyboard.press("Tab");
  await settle(page);
  const focused = decodePng(await page.screenshot({ clip }));
  // A ring of 2 px around the text in the accent's colour.
  const ring = [];
  for (let i = 0; i < focused.pixels.length; i += focused.channels) {
    const [r, g, b] = focused.pixels.subarray(i, i + 3);
    if (Math.abs(r - 0xc2) + Math.abs(g - 0x41) + Math.abs(b - 0x0c) < 60) ring.push(i);
  }
  const before = ring.filter((i) => Math.abs(without.pixels[i] - 0xc2) + Math.abs(without.pixels[i + 1] - 0x41) < 60);
  assert.ok(ring.length - before.length > 2 * (box.width + box.height), `${ring.length} pixels of a ring`);
  await screenshot(page, "focused");
  for (let i = 0; i < 4; ++i) {
    // Faster than frames: nothing gets lost.
    await page.keyboard.press("Shift+ArrowLeft");
    await page.keyboard.press("PageDown");
    await page.keyboard.press("ArrowLeft");
    await settle(page);
    assert.equal(await page.evaluate(() => document.activeElement.shadowRoot?.activeElement?.dataset.name), "Width");
  }
  const { min, default: normal } = (await parameters()).find((p) => p.name === "Width");
  assert.equal(await valueOf(page, "Width"), min);
  await call(page, "setParameters", { Width: normal });
  await settle(page);
});

test("the focus goes along when a line changes its place", async () => {
  await sliderOf(page, "Width").focus();
  const places = new Set();
  for (const view of ["front", "back", "top", "three-quarter"]) {
    await call(page, "setView", view);
    await settle(page);
    places.add(lineOf(await layoutOf(page), "Width").identity);
    assert.equal(await page.evaluate(() => document.activeElement.shadowRoot?.activeElement?.dataset.name), "Width", `in the ${view} view`);
  }
  assert.ok(places.size > 1, "it changed its place");
});

test("screen readers are told what undo and redo have changed, and when a key meets a limit; of other changes they hear from the slider itself", async () => {
  const told = () => inside(page, "[role=status]").textContent();
  const { max, step, value } = (await parameters()).find((p) => p.name === "RoofPitch");
  await sliderOf(page, "RoofPitch").focus();
  await page.keyboard.press("ArrowUp");
  await settle(page);
  const before = await told();
  await page.keyboard.press("Control+z");
  await settle(page);
  assert.equal(await told(), `Undone: Roof pitch ${value}°.`);
  await page.keyboard.press("Control+y");
  await settle(page);
  assert.equal(await told(), `Redone: Roof pitch ${value + step}°.`);
  assert.notEqual(before, await told());
  await page.click("#undo");
  assert.equal(await told(), `Undone: Roof pitch ${value}°.`);
  await sliderOf(page, "RoofPitch").focus();
  await page.keyboard.press("End");
  await settle(page);
  assert.equal(await told(), `Undone: Roof pitch ${value}°.`);
  await page.keyboard.press("ArrowUp");
  assert.equal(await told(), `Roof pitch is at most ${max}°.`);
  await page.keyboard.press("Control+z");
  await settle(page);
  assert.equal(await valueOf(page, "RoofPitch"), value);
});

test("the panel's controls do the same from the keyboard", async () => {
  for (const name of ["Width", "RoofPitch"]) {
    const { value, step, default: normal } = (await parameters()).find((p) => p.name === name);
    await page.locator(`.row[data-name="${name}"] input[type=range]`).focus();
    await page.keyboard.press("ArrowRight");
    await settle(page);
    assert.ok(Math.abs((await valueOf(page, name)) - value - step) < 1e-9, name);
    await call(page, "setParameters", { [name]: normal });
    await settle(page);
  }
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
