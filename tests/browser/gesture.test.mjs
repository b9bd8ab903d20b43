// What a drag feels like: it is read as it goes, ends are felt, keys make it finer, it can be let go of anywhere and given up.
import assert from "node:assert/strict";
import { test } from "node:test";
import { cursorOf, fingersOf, gripOf, gripsOf, inside, labelOf } from "./support/handles.mjs";
import { openHouse } from "./support/house.mjs";
import { call, layoutOf, openPage, pictureBox, recordEvents, screenshot, settle, takeEvents, valueOf } from "./support/page.mjs";

let browser, tab, page, defaults;
openHouse({ width: 1100, height: 800, drawn: false }, (desk) => ({ browser, tab, page, defaults } = desk));

const parameter = async (name) => (await call(page, "getParameters")).find((p) => p.name === name);
const readout = (of = page) => inside(of, ".readout[data-shown]");
const along = (grip, px) => [grip.at[0] + grip.outward[0] * px, grip.at[1] + grip.outward[1] * px];
async function dragBy(grip, px) {
  await page.mouse.move(...grip.at);
  await page.mouse.down();
  await page.mouse.move(...along(grip, px), { steps: 3 });
  await settle(page);
}

test("value and difference stand beside the handle; keys are explained during the first drag, and only then", async () => {
  const { min } = await parameter("Width");
  for (const round of [0, 1]) {
    const grip = await gripOf(page, "Width");
    await dragBy(grip, -40);
    const value = await valueOf(page, "Width");
    assert.ok(value > min && value < defaults.Width);
    const text = await readout().textContent();
    assert.ok(text.includes(`Width${value.toFixed(2)} m−${(defaults.Width - value).toFixed(2)} m`), text);
    assert.equal(/Shift.*Alt/.test(text), round === 0, text);
    const { handle } = await page.evaluate(() => document.querySelector("dimline-editor").gestures[0]);
    const [box, picture] = [await readout().boundingBox(), await pictureBox(page)];
    const [x, y] = [picture.x + handle[0], picture.y + handle[1]];
    const away = Math.hypot(Math.max(box.x - x, x - box.x - box.width, 0), Math.max(box.y - y, y - box.y - box.height, 0));
    assert.ok(away >= 8 && away < 60, `the box is ${away} px from the handle`);
    if (round === 0) await screenshot(page, "drag-readout");
    await page.mouse.up();
    await settle(page);
    await call(page, "setParameters", defaults);
    await settle(page);
  }
});

test("at its limit the handle says so, and nothing jumps over it", async () => {
  const { min, max } = await parameter("Width");
  const grip = await gripOf(page, "Width");
  await dragBy(grip, 2000);
  assert.equal(await valueOf(page, "Width"), max);
  assert.equal(await readout().locator(".limit").textContent(), "max");
  await screenshot(page, "drag-at-limit");
  await page.mouse.move(...along(grip, -2000), { steps: 4 });
  await settle(page);
  assert.equal(await valueOf(page, "Width"), min);
  assert.equal(await readout().locator(".limit").textContent(), "min");
  await page.mouse.move(...along(grip, -10), { steps: 4 });
  await settle(page);
  assert.equal(await readout().locator(".limit").textContent(), "");
  await page.keyboard.press("Escape");
  await page.mouse.up();
});

test("Shift makes the steps ten times finer and Alt takes them away, at once, while the pointer rests", async () => {
  const { step } = await parameter("Width");
  const grip = await gripOf(page, "Width");
  await dragBy(grip, -37.3);
  const onGrid = (value, size) => Math.abs(value / size - Math.round(value / size)) < 1e-6;
  const coarse = await valueOf(page, "Width");
  assert.ok(onGrid(coarse, step));
  await page.keyboard.down("Shift");
  await settle(page);
  const fine = await valueOf(page, "Width");
  assert.ok(onGrid(fine, step / 10) && Math.abs(fine - coarse) <= step / 2 + 1e-9, `${fine} after ${coarse}`);
  await page.keyboard.up("Shift");
  await page.keyboard.down("Alt");
  await settle(page);
  const free = await valueOf(page, "Width");
  assert.ok(Math.abs(free - fine) <= step / 20 + 1e-9, `${free} after ${fine}`);
  assert.ok(new Set([coarse, fine, free]).size >= 2, `${coarse}, ${fine}, ${free}`);
  await page.keyboard.up("Alt");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), coarse);
  await page.keyboard.press("Escape");
  await page.mouse.up();
});

test("the cursor shows which way the line goes, at rest and while it is dragged", async () => {
  const seen = new Set();
  for (const name of ["Width", "Depth", "ChimneyHeight"]) {
    const grip = await gripOf(page, name);
    const degrees = ((Math.atan2(grip.outward[1], grip.outward[0]) * 180) / Math.PI + 180) % 180;
    await page.mouse.move(...grip.at);
    await settle(page);
    const cursor = await cursorOf(page);
    const drawn = { "ew-resize": 0, "nwse-resize": 45, "ns-resize": 90, "nesw-resize": 135 }[cursor];
    const off = Math.abs(((degrees - drawn + 270) % 180) - 90);
    assert.ok(off <= 22.6, `${name}: ${cursor} over a line at ${degrees.toFixed(0)}°`);
    seen.add(cursor);
    await page.mouse.down();
    await page.mouse.move(...along(grip, 6));
    await settle(page);
    assert.equal(await cursorOf(page), cursor);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await settle(page);
  }
  assert.ok(seen.size >= 2);
  await page.mouse.move(...(await labelOf(page, "Width")));
  await settle(page);
  assert.equal(await cursorOf(page), "text");
});

test("the name of what the mouse rests on hides no number", async () => {
  const { lines } = await layoutOf(page);
  const picture = await pictureBox(page);
  const names = [...new Set(lines.map(({ parameter: name }) => name))];
  for (const name of names) {
    const { at, line } = await gripOf(page, name);
    await page.mouse.move(...at);
    await settle(page);
    const { title } = await parameter(name);
    // A line that carries no number is told with it.
    assert.equal((await readout().textContent()).replace(/\s+/g, " "), line.label ? title : `${title} ${line.text}`);
    const { x, y, width, height } = await readout().boundingBox();
    const box = [x - picture.x, y - picture.y, x - picture.x + width, y - picture.y + height];
    for (const { label, text, parameter: other } of (await layoutOf(page)).lines) {
      if (!label) continue;
      const [x0, y0, x1, y1] = label.box;
      const hidden = Math.max(0, Math.min(x1, box[2]) - Math.max(x0, box[0])) * Math.max(0, Math.min(y1, box[3]) - Math.max(y0, box[1]));
      assert.ok(hidden <= 40, `${name} hides ${hidden.toFixed(0)} px² of ${text} of ${other}`);
    }
  }
  assert.ok(names.length >= 8);
});

test("a drag survives leaving the picture and the window, and ends where it is let go of", async () => {
  const grip = await gripOf(page, "Depth");
  await dragBy(grip, -50);
  const there = await valueOf(page, "Depth");
  await page.mouse.move(1090, 300, { steps: 3 }); // over the panel
  await settle(page);
  const overPanel = await valueOf(page, "Depth");
  assert.ok(overPanel > there, `${overPanel} after ${there}`);
  await page.mouse.move(...along(grip, -20), { steps: 3 });
  await settle(page);
  assert.ok((await valueOf(page, "Depth")) < defaults.Depth);
  await page.mouse.move(1090, 300, { steps: 3 });
  await page.mouse.up();
  await settle(page);
  assert.equal(await valueOf(page, "Depth"), overPanel);
  assert.equal((await takeEvents(page)).filter((type) => type === "change").length, 1);
  await page.mouse.move(...along(grip, -20), { steps: 3 });
  await settle(page);
  assert.equal(await valueOf(page, "Depth"), overPanel, "it is still held");
});

test("Escape gives a drag up: values and lines are what they were, to the last byte", async () => {
  const start = [JSON.stringify(await call(page, "getParameters")), JSON.stringify(await layoutOf(page))];
  for (const name of ["Width", "Floors", "RoofPitch"]) {
    const { others } = await layoutOf(page);
    const arc = others.find((other) => other.parameter === name);
    const picture = await pictureBox(page);
    const grip = arc
      ? { at: [picture.x + arc.handles[0].screen[0], picture.y + arc.handles[0].screen[1] + 3], outward: [0, -1] }
      : await gripOf(page, name);
    await dragBy(grip, 60);
    assert.notEqual(await valueOf(page, name), defaults[name], name);
    const marked = page.locator(".row[data-live]");
    assert.deepEqual(await marked.evaluateAll((rows) => rows.map((row) => row.dataset.name)), [name]);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await page.mouse.move(2, 2);
    await settle(page);
    assert.equal(await marked.count(), 0, `${name}: still marked in the panel`);
    assert.equal(JSON.stringify(await call(page, "getParameters")), start[0], name);
    assert.equal(JSON.stringify(await layoutOf(page)), start[1], name);
    assert.equal((await takeEvents(page)).includes("change"), false, `${name}: a change that was none`);
  }
});

test("several edits, undone to the start, leave the very same values and the very same model", async () => {
  await page.reload();
  await page.evaluate(() => document.querySelector("dimline-editor").ready);
  await settle(page);
  await recordEvents(page);
  // Which side a line stands on, and so which members of a chain have room, remembers the way there; the model does not.
  const state = async () => JSON.stringify([await call(page, "getParameters"), (await layoutOf(page)).visible]);
  const start = await state();
  let edits = 0;
  for (const name of ["Width", "ChimneyHeight", "Depth"]) {
    await dragBy(await gripOf(page, name), 30);
    await page.mouse.up();
    await settle(page);
    edits += 1;
  }
  await page.locator("#undo").focus();
  for (let i = 0; i < edits; ++i) await page.keyboard.press("Enter");
  await page.mouse.move(2, 2);
  await settle(page);
  assert.ok(await page.isDisabled("#undo"));
  assert.equal(await state(), start);
  assert.ok(await page.isEnabled("#redo"));
});

test("a double click on an arrow resets its parameter", async () => {
  await call(page, "setParameters", { Width: 10 });
  await settle(page);
  const { at } = await gripOf(page, "Width");
  await page.mouse.dblclick(...at);
  await settle(page);
  assert.equal(await valueOf(page, "Width"), defaults.Width);
  assert.match(await inside(page, "[role=status]").textContent(), /Width reset to 13/);
  await page.click("#undo");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), 10);
});

test("hidden lines are shown while H is held, while the button is held, or until it is clicked again", async () => {
  await call(page, "setView", "top");
  await settle(page);
  await page.mouse.move(2, 2);
  const before = await layoutOf(page);
  const reasons = ["occluded", "too-short", "foreshortened", "crowded"];
  const hidden = before.hidden.filter(({ reason }) => reasons.includes(reason)).length;
  assert.ok(hidden >= 2, "the view from above shows all");
  const left = async () => (await layoutOf(page)).hidden.filter(({ reason }) => reasons.includes(reason)).length;
  const button = page.locator("#hidden-lines");

  await page.keyboard.down("h");
  await settle(page);
  assert.ok((await left()) < hidden, "the key shows none");
  await screenshot(page, "hidden-lines-shown");
  await page.keyboard.up("h");
  await settle(page);
  assert.deepEqual((await layoutOf(page)).lines, before.lines);

  await button.click();
  await settle(page);
  assert.ok((await left()) < hidden);
  assert.equal(await button.getAttribute("aria-pressed"), "true");
  await button.click();
  await settle(page);
  assert.equal(await left(), hidden);
  assert.equal(await button.getAttribute("aria-pressed"), "false");

  await button.hover();
  await page.mouse.down();
  await settle(page);
  assert.ok((await left()) < hidden);
  await page.waitForTimeout(500);
  await page.mouse.up();
  await settle(page);
  assert.equal(await left(), hidden);
  assert.equal(await button.getAttribute("aria-pressed"), "false");
});

test("where nothing is hidden, showing it says so", async () => {
  await page.mouse.move(2, 2);
  const before = await layoutOf(page);
  assert.deepEqual(before.hidden, []);
  await page.keyboard.down("h");
  await settle(page);
  assert.equal(await inside(page, "[role=status]").textContent(), "Nothing is hidden in this view.");
  assert.ok(await inside(page, ".readout[data-shown]").isVisible());
  await page.keyboard.up("h");
  await settle(page);
  assert.deepEqual((await layoutOf(page)).lines, before.lines);
});

test("fingers: the value stands above them, limits buzz, a double tap resets, a second finger beside the lines changes nothing", async () => {
  const { page: phone, close } = await openPage(browser, {
    width: 390,
    height: 844,
    dpr: 2,
    touch: true,
    drawn: false,
    prepare: (other) => other.addInitScript(() => {
      window.buzzes = 0;
      Object.defineProperty(navigator, "vibrate", { value: () => ++window.buzzes });
    }),
  });
  const fingers = await fingersOf(phone);
  const line = (await layoutOf(phone)).lines.find(({ parameter }) => parameter === "Depth");
  const [grip] = gripsOf(line, await pictureBox(phone));
  const start = await valueOf(phone, "Depth");
  await fingers.down(grip.at);
  await fingers.move(along(grip, 10));
  await fingers.move(along(grip, 18));
  await settle(phone);
  const value = await valueOf(phone, "Depth");
  assert.ok(value > start);
  const box = await readout(phone).boundingBox();
  const picture = await pictureBox(phone);
  assert.ok(box.y + box.height < along(grip, 18)[1] - 30, "the finger hides the value");
  assert.ok(box.x >= 0 && box.x + box.width <= 390 && box.y >= picture.y);
  assert.doesNotMatch(await readout(phone).textContent(), /Shift/);
  await screenshot(phone, "drag-by-finger");
  await fingers.down(along(grip, 18), [60, 100]);
  await fingers.move(along(grip, 18), [60, 140]);
  await settle(phone);
  assert.equal(await valueOf(phone, "Depth"), value);
  await fingers.move(along(grip, 900), [60, 140]);
  await settle(phone);
  assert.equal(await readout(phone).locator(".limit").textContent(), "max");
  assert.ok((await phone.evaluate(() => window.buzzes)) >= 1);
  await fingers.up();
  await settle(phone);
  const [now] = gripsOf((await layoutOf(phone)).lines.find(({ parameter }) => parameter === "Depth"), picture);
  await phone.touchscreen.tap(...now.at);
  await phone.touchscreen.tap(...now.at);
  await settle(phone);
  assert.equal(await valueOf(phone, "Depth"), start);
  await close();
});

test("two fingers drag two lines at once, each under its own, the second on when the first is lifted: one undo step", async () => {
  const { page: phone, close } = await openPage(browser, { width: 800, height: 900, touch: true, drawn: false });
  await recordEvents(phone);
  const fingers = await fingersOf(phone);
  const picture = await pictureBox(phone);
  const lineNow = async (name) => (await layoutOf(phone)).lines.find(({ parameter }) => parameter === name);
  const start = JSON.stringify(await call(phone, "getParameters"));
  const names = ["Width", "Depth"];
  const grips = [];
  for (const name of names) grips.push(gripsOf(await lineNow(name), picture)[0]);
  const [first, second] = grips;
  await fingers.down(first.at);
  await fingers.down(first.at, second.at);
  for (const px of [4, 8, 12]) await fingers.move(along(first, -2 * px), along(second, px));
  await settle(phone);
  const gesturesNow = () => phone.evaluate(() => document.querySelector("dimline-editor").gestures);
  const gestures = await gesturesNow();
  assert.deepEqual(gestures.map(({ parameter }) => parameter), names);
  for (const [i, travelPx] of [-24, 12].entries()) {
    const { handle, value, parameter, limit } = gestures[i];
    assert.ok((value - defaults[parameter]) * travelPx > 0 && limit === null, `${parameter} is ${value}`);
    const went = (handle[0] - grips[i].tip[0]) * grips[i].outward[0] + (handle[1] - grips[i].tip[1]) * grips[i].outward[1];
    assert.ok(Math.abs(went - travelPx) <= 3, `${parameter}: ${went} px of the ${travelPx} that its finger went`);
  }
  // The value of each stands above its finger.
  const texts = await readout(phone).allTextContents();
  assert.equal(texts.length, 2);
  for (const [i, name] of names.entries()) assert.ok(texts[i].startsWith(name), texts[i]);
  await screenshot(phone, "drag-by-two-fingers");

  await fingers.lift(along(first, -24));
  await fingers.move(null, along(second, 20));
  await settle(phone);
  const still = await gesturesNow();
  assert.deepEqual(still.map(({ parameter }) => parameter), ["Depth"]);
  assert.ok(still[0].value > gestures[1].value, `${still[0].value} after ${gestures[1].value}`);
  assert.equal(await readout(phone).count(), 1);

  await fingers.up();
  await settle(phone);
  assert.equal(await readout(phone).count(), 0);
  assert.equal(await valueOf(phone, "Width"), gestures[0].value);
  assert.equal(await valueOf(phone, "Depth"), still[0].value);
  assert.equal((await takeEvents(phone)).filter((type) => type === "change").length, 1);
  await phone.click("#undo");
  await settle(phone);
  assert.equal(JSON.stringify(await call(phone, "getParameters")), start);
  assert.ok(await phone.isDisabled("#undo"));
  await close();
});

test("under a finger the options of a choice are 44 px high, stay in the picture, and can be chosen", async () => {
  const { page: phone, close } = await openPage(browser, { width: 390, height: 844, dpr: 2, touch: true, drawn: false });
  const { parameter: name, box } = (await layoutOf(phone)).others.find(({ type }) => type === "range");
  const picture = await pictureBox(phone);
  await phone.touchscreen.tap(picture.x + (box[0] + box[2]) / 2, picture.y + (box[1] + box[3]) / 2);
  const options = inside(phone, ".option");
  await options.first().waitFor();
  await settle(phone);
  const boxes = await Promise.all((await options.all()).map((option) => option.boundingBox()));
  for (const { y, height } of boxes) {
    assert.ok(height >= 43 && y >= picture.y && y + height <= picture.y + picture.height, `${y}, ${height} px high`);
  }
  await screenshot(phone, "choice-on-a-phone");
  const last = boxes.at(-1);
  await phone.touchscreen.tap(last.x + last.width / 2, last.y + last.height / 2);
  await settle(phone);
  const { choices, value } = (await call(phone, "getParameters")).find((p) => p.name === name);
  assert.equal(value, choices.at(-1));
  await close();
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
