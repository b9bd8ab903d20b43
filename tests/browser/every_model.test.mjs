// In every built-in model, by the browser's own input: a finger drags a line, keys move sliders, values are typed, angles are turned, switches and choices are used,
// and all of it can be undone to the very start. What the mouse does with lines is told by follow.test.mjs.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { arcGripOf, fingersOf, gripsOf, inside, labelOf, middleOf, modelNames, sliderOf } from "./support/handles.mjs";
import { call, launch, layoutOf, openPage, pictureBox, settle, showModel, valueOf } from "./support/page.mjs";

const kTravelPx = 36;
const kNearPx = 3;

let browser, tab, page, fingers, picture;
before(async () => {
  browser = await launch();
  tab = await openPage(browser, { width: 800, height: 560, drawn: false, touch: true, reducedMotion: "reduce" });
  page = tab.page;
  fingers = await fingersOf(page);
  picture = await pictureBox(page);
});
after(async () => {
  await browser?.close();
});

const parameters = () => call(page, "getParameters");
const parameter = async (name) => (await parameters()).find((p) => p.name === name);
// As the next frame has it: the editor asked for that frame first.
const gesture = () =>
  page.evaluate(async () => {
    await new Promise(requestAnimationFrame);
    return document.querySelector("dimline-editor").gestures[0] ?? null;
  });
/** All that follows from the values, too. */
const documentNow = async () => JSON.stringify([await parameters(), await call(page, "getMeasures")]);
const project = ([x, y], [dx, dy]) => x * dx + y * dy;

/** Lines that a visitor can drag, one a parameter. */
async function dragged() {
  const { lines } = await layoutOf(page);
  const names = [...new Set(lines.filter(({ handles }) => handles.length > 0).map((line) => line.parameter))];
  return names.map((name) => lines.find((line) => line.parameter === name && line.handles.length > 0));
}

async function byFinger(what) {
  let changed = 0;
  const start = await documentNow();
  const [{ parameter: name }] = await dragged();
  for (const sense of [1, -1]) {
    // After a drag lines may have found other places.
    const line = (await dragged()).find(({ parameter }) => parameter === name);
    assert.ok(line, `${what}: ${name} has no line any more`);
    const [grip] = gripsOf(line, picture);
    const at = (px) => [grip.at[0] + grip.outward[0] * px, grip.at[1] + grip.outward[1] * px];
    await fingers.down(at(0));
    await fingers.move(at(sense * kTravelPx));
    const { parameter: held, handle, limit, value } = await gesture();
    assert.equal(held, name, `${what}: something else was taken hold of`);
    const ahead = project([handle[0] - grip.tip[0], handle[1] - grip.tip[1]], grip.outward) - sense * kTravelPx;
    // Where only some lengths are to be had, the handle may be half way to the next one; how near it comes then is told by follow.test.mjs.
    assert.ok(Math.abs(ahead) <= kNearPx || limit || line.indirect || line.chain, `${what}, ${name}: ${ahead.toFixed(1)} px from the finger at ${value}`);
    if (value !== (await parameter(name)).default) changed += 1;
    await fingers.move(at(0));
    await fingers.up();
    await settle(page);
    assert.equal(await documentNow(), start, `${what}, ${name}: there and back`);
  }
  assert.ok(changed > 0, `${what}: no finger changed anything`);
}

async function byKeys(what) {
  const [line] = (await dragged()).slice(-1);
  const name = line.parameter;
  const { value, min, max, step, type } = await parameter(name);
  const size = step || (max - min) / 100;
  const down = value + size > max;
  await sliderOf(page, name).focus();
  await page.keyboard.press(down ? "ArrowLeft" : "ArrowRight");
  await settle(page);
  const moved = await valueOf(page, name);
  assert.ok(Math.abs(moved - value - (down ? -size : size)) < 1e-6, `${what}, ${name} (${type}): ${value} became ${moved} by a key`);
}

async function byTyping(what) {
  const { lines } = await layoutOf(page);
  const line = lines.find(({ label, handles }) => label && handles.length > 0);
  assert.ok(line, `${what}: no line has a number`);
  const name = line.parameter;
  const { min, max, step, type } = await parameter(name);
  const wanted = type === "int" ? Math.round(min + 0.6 * (max - min)) : Number((min + Math.round((0.6 * (max - min)) / (step || 0.01)) * (step || 0.01)).toFixed(3));
  await page.mouse.click(...(await labelOf(page, name)));
  await settle(page);
  const field = inside(page, ".value-field input");
  assert.equal(await field.count(), 1, `${what}: a click on the number of ${name} opens no field`);
  await page.keyboard.type(`${wanted}`);
  await page.keyboard.press("Enter");
  await settle(page);
  assert.ok(Math.abs((await valueOf(page, name)) - wanted) < 1e-9, `${what}, ${name}: ${await valueOf(page, name)} after ${wanted} was typed`);
}

async function otherHandles(what, seen) {
  for (const { parameter: name, type } of (await layoutOf(page)).others) {
    const other = (await layoutOf(page)).others.find((candidate) => candidate.parameter === name);
    if (!other) continue; // what was used before has put it away
    const before = await valueOf(page, name);
    seen.add(type);
    if (type === "boolean") {
      await page.mouse.click(...(await middleOf(page, other.box)));
      await settle(page);
      assert.equal(await valueOf(page, name), !before, `${what}, ${name}: a click`);
      await page.touchscreen.tap(...(await middleOf(page, (await layoutOf(page)).others.find((o) => o.parameter === name)?.box ?? other.box)));
      await settle(page);
    } else if (type === "range") {
      const { choices } = await parameter(name);
      const next = choices[(choices.indexOf(before) + 1) % choices.length];
      await page.mouse.click(...(await middleOf(page, other.box)));
      await inside(page, `.option[data-value="${next}"]`).click();
      await settle(page);
      assert.equal(await valueOf(page, name), next, `${what}, ${name}: a choice`);
    } else {
      const grip = arcGripOf(other, picture);
      await page.mouse.move(...grip.at);
      await page.mouse.down();
      await page.mouse.move(...grip.turned(0.1));
      await page.mouse.move(...grip.turned(0.2));
      const { value, limit } = await gesture();
      assert.ok(value !== before || limit, `${what}, ${name}: an arc`);
      await page.mouse.move(...grip.at);
      await page.mouse.up();
      await settle(page);
      assert.equal(await valueOf(page, name), before, `${what}, ${name}: there and back`);
    }
  }
}

test("fingers, keys, typing, angles, switches and choices work in every model, and undo leads back to the same bytes", async (t) => {
  const seen = new Set();
  const models = await modelNames(page);
  assert.equal(models.length, 12);
  for (const model of models) {
    await t.test(model, async () => {
      await showModel(page, model);
      const start = await documentNow();
      await byFinger(model);
      assert.equal(await page.isDisabled("#undo"), true, "dragging there and back is a step");
      await byKeys(model);
      await byTyping(model);
      await otherHandles(model, seen);
      assert.notEqual(await documentNow(), start);
      let steps = 0;
      await inside(page, "canvas").focus();
      while (await page.isEnabled("#undo")) {
        assert.ok(++steps < 50);
        await page.keyboard.press("Control+z");
        await page.evaluate(() => new Promise(requestAnimationFrame));
      }
      await settle(page);
      assert.ok(steps >= 2);
      assert.equal(await documentNow(), start, "undone to the start");
    });
  }
  assert.deepEqual([...seen].sort(), ["angular", "boolean", "range"]);
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
