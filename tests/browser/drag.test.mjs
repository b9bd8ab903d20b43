// The main job: dragging a dimension line's arrow changes the house, and everything follows.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fingersOf } from "./support/handles.mjs";
import { openHouse } from "./support/house.mjs";
import {
  call,
  distance,
  layoutOf,
  lineOf,
  openPage,
  pictureBox,
  screenshot,
  settle,
  takeEvents,
  valueOf,
} from "./support/page.mjs";
import { colourStatistics, decodePng, pixelAt } from "./support/png.mjs";

const kWidth = "Width";
/** px. Well within the width's range in a window of this size: the house grows to both sides, so the width changes by twice as much. */
const kTravelPx = 40;

const kWindow = { width: 1000, height: 700 };

let browser, tab, page, defaults;
openHouse({ ...kWindow, touch: true, drawn: false }, (desk) => ({ browser, tab, page, defaults } = desk));

/** The width's line, its handle in the window's pixels, and its direction on screen from the fixed end to the moving one. */
async function widthHandle(of = page) {
  const box = await pictureBox(of);
  const line = lineOf(await layoutOf(of), kWidth);
  const handle = line.handles.find((candidate) => candidate.end === "end") ?? line.handles[0];
  const [from, to] = handle.end === "end" ? line.line.screen : [...line.line.screen].reverse();
  const length = distance(from, to);
  return {
    line,
    handle,
    grip: gripOf(handle.screen, [from, to], box),
    direction: [(to[0] - from[0]) / length, (to[1] - from[1]) / length],
  };
}

/** A visitor takes hold of the arrowhead, some pixels behind its tip. */
function gripOf([x, y], [from, to], box) {
  const length = distance(from, to);
  return [box.x + x - ((to[0] - from[0]) / length) * 5, box.y + y - ((to[1] - from[1]) / length) * 5];
}

const panelValue = () => page.inputValue(`[data-name="${kWidth}"] input.number`).then(Number);
const panelSlider = () => page.inputValue(`[data-name="${kWidth}"] input[type=range]`).then(Number);
const worldLength = ([a, b]) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

test("the width's arrow, dragged 40 px: value, geometry and panel follow, and the arrow stays under the pointer", async () => {
  const start = await valueOf(page, kWidth);
  const { line, handle, grip, direction } = await widthHandle();
  assert.ok(Math.abs(worldLength(line.base.world) - start) < 1e-6, "the base line is as long as the value says");
  await page.mouse.move(...grip);
  await settle(page);
  await page.mouse.down();
  let previous = start;
  for (let px = 10; px <= kTravelPx; px += 10) {
    await page.mouse.move(grip[0] + direction[0] * px, grip[1] + direction[1] * px);
    await settle(page);
    const now = lineOf(await layoutOf(page), kWidth);
    const tip = now.handles.find((candidate) => candidate.end === handle.end).screen;
    const wanted = [handle.screen[0] + direction[0] * px, handle.screen[1] + direction[1] * px];
    // The value moves in steps, so the tip may be half a step off.
    const { step } = (await call(page, "getParameters")).find((p) => p.name === kWidth);
    const stepPx = (step * distance(...now.line.screen)) / worldLength(now.line.world);
    assert.ok(
      distance(tip, wanted) <= Math.max(3, stepPx / 2 + 1),
      `after ${px} px the arrow is ${distance(tip, wanted).toFixed(1)} px from the pointer`,
    );
    const value = await valueOf(page, kWidth);
    assert.ok(value >= previous, `${value} after ${previous}`);
    previous = value;
  }
  // Nothing of the drag was left behind by a frame that still runs.
  await page.mouse.up();
  await settle(page);
  const value = await valueOf(page, kWidth);
  assert.ok(value > start + 0.2, `the width is ${value} after ${start}`);
  const after = lineOf(await layoutOf(page), kWidth);
  assert.ok(Math.abs(worldLength(after.base.world) - value) < 1e-6, "the house is as wide as the value says");
  assert.equal(await panelValue(), Number(value.toFixed(2)));
  assert.ok(Math.abs((await panelSlider()) - value) < 1e-9);
  assert.match(after.text, new RegExp(`^${value.toFixed(2).replace(/0$/, "0?")}`));

  const events = await takeEvents(page);
  assert.equal(events.filter((type) => type === "change").length, 1);
  assert.equal(events.at(-1), "change");
  assert.ok(events.filter((type) => type === "input").length >= 3);

  await page.keyboard.press("Control+z");
  await settle(page);
  assert.equal(await valueOf(page, kWidth), start);
  assert.equal(await panelValue(), start);
  await page.keyboard.press("Control+Shift+Z");
  await settle(page);
  assert.equal(await valueOf(page, kWidth), value);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+y");
  await settle(page);
  assert.equal(await valueOf(page, kWidth), value);
});

test("the picture after a drag is one, and hovering over an arrow leaves it as it is", async () => {
  const { page: drawn, complaints, close } = await openPage(browser, kWindow);
  const box = await pictureBox(drawn);
  const { grip: start, direction } = await widthHandle(drawn);
  await drawn.mouse.move(...start);
  await drawn.mouse.down();
  await drawn.mouse.move(start[0] + direction[0] * kTravelPx, start[1] + direction[1] * kTravelPx, { steps: 4 });
  await drawn.mouse.up();
  await settle(drawn);
  const { colours, commonest } = colourStatistics(decodePng(await screenshot(drawn, "after-width-drag")));
  assert.ok(
    colours > 40 && commonest < 0.9,
    `the picture has ${colours} colours, one of them on ${(commonest * 100).toFixed(0)} %`,
  );

  const { grip } = await widthHandle(drawn);
  await drawn.mouse.move(box.x + 2, box.y + 2);
  await settle(drawn);
  const before = decodePng(await drawn.screenshot({ clip: box }));
  await drawn.mouse.move(...grip);
  await settle(drawn);
  const hovered = decodePng(await drawn.screenshot({ clip: box }));
  let changed = 0;
  for (let i = 0; i < before.pixels.length; i += before.channels)
    changed += Math.abs(before.pixels[i] - hovered.pixels[i]) > 16 ? 1 : 0;
  for (const [name, picture] of Object.entries({ before, hovered })) {
    const [red, green, blue] = pixelAt(picture, 3, 3);
    assert.ok(Math.min(red, green, blue) > 200, `${name}: the sky is ${[red, green, blue]}`);
  }
  const share = changed / (before.width * before.height);
  assert.ok(share > 0 && share < 0.03, `${(share * 100).toFixed(1)} % of the pixels changed`);
  assert.deepEqual(complaints, []);
  await close();
});

test("Esc in the middle of a drag takes all of it back", async () => {
  const before = { layout: await layoutOf(page), parameters: await call(page, "getParameters") };
  const { grip, direction } = await widthHandle();
  await page.mouse.move(...grip);
  await page.mouse.down();
  await page.mouse.move(grip[0] + direction[0] * 50, grip[1] + direction[1] * 50, { steps: 5 });
  await settle(page);
  assert.notDeepEqual(await call(page, "getParameters"), before.parameters);
  await page.keyboard.press("Escape");
  await settle(page);
  assert.deepEqual(await call(page, "getParameters"), before.parameters);
  assert.equal(await panelValue(), before.parameters.find((p) => p.name === kWidth).value);
  // What the pointer does until it is up means nothing.
  await page.mouse.move(grip[0] + 80, grip[1] + 20);
  await page.mouse.up();
  await page.mouse.move(5, 5);
  await settle(page);
  assert.deepEqual(await call(page, "getParameters"), before.parameters);
  assert.deepEqual((await layoutOf(page)).lines, before.layout.lines);
});

test("a finger drags an arrow as a mouse does", async () => {
  const start = await valueOf(page, kWidth);
  const { grip, direction, handle } = await widthHandle();
  const fingers = await fingersOf(page);
  const at = (px) => [grip[0] + direction[0] * px, grip[1] + direction[1] * px];
  await fingers.down(at(0));
  for (let px = 10; px <= kTravelPx; px += 10) await fingers.move(at(px));
  await settle(page);
  const tip = lineOf(await layoutOf(page), kWidth).handles.find((candidate) => candidate.end === handle.end).screen;
  assert.ok(distance(tip, [handle.screen[0] + direction[0] * kTravelPx, handle.screen[1] + direction[1] * kTravelPx]) <= 3);
  await fingers.up();
  await settle(page);
  assert.ok((await valueOf(page, kWidth)) > start + 0.2);
});

test("a drag beyond the range stops at its end, and comes back", async () => {
  const { min, max } = (await call(page, "getParameters")).find((p) => p.name === kWidth);
  const { grip, direction } = await widthHandle();
  await page.mouse.move(...grip);
  await page.mouse.down();
  await page.mouse.move(grip[0] + direction[0] * 5000, grip[1] + direction[1] * 5000, { steps: 4 });
  await settle(page);
  assert.equal(await valueOf(page, kWidth), max);
  await page.mouse.move(grip[0] - direction[0] * 5000, grip[1] - direction[1] * 5000, { steps: 4 });
  await settle(page);
  assert.equal(await valueOf(page, kWidth), min);
  await page.mouse.move(...grip);
  await settle(page);
  assert.equal(await valueOf(page, kWidth), defaults[kWidth]);
  await page.mouse.up();
  await settle(page);
});

test("every line's handle moves its parameter both ways", async () => {
  const box = await pictureBox(page);
  // An indirect line shows what the model made of the value, by rounding: it may well stay.
  const names = new Set((await layoutOf(page)).lines.filter((line) => !line.indirect).map((line) => line.parameter));
  assert.ok(names.size >= 4);
  for (const name of names) {
    for (const travelPx of [120, -120]) {
      const { min, max, value: start } = (await call(page, "getParameters")).find((p) => p.name === name);
      const line = lineOf(await layoutOf(page), name);
      const [handle] = line.handles;
      const [from, to] = handle.end === "end" ? line.line.screen : [...line.line.screen].reverse();
      const length = distance(from, to);
      const grip = gripOf(handle.screen, [from, to], box);
      await page.mouse.move(...grip);
      await page.mouse.down();
      await page.mouse.move(
        grip[0] + ((to[0] - from[0]) / length) * travelPx,
        grip[1] + ((to[1] - from[1]) / length) * travelPx,
        { steps: 4 },
      );
      await settle(page);
      const value = await valueOf(page, name);
      const stuck = travelPx > 0 ? start === max : start === min;
      assert.ok(stuck || (value - start) * travelPx > 0, `${name}: ${start} became ${value} by ${travelPx} px`);
      await page.keyboard.press("Escape");
      await page.mouse.up();
      await settle(page);
      assert.equal(await valueOf(page, name), start, name);
    }
  }
});

test("a line's element is a slider for the keyboard", async () => {
  const slider = page.locator("dimline-editor").locator(`.label[data-name="${kWidth}"]`).first();
  const parameter = (await call(page, "getParameters")).find((p) => p.name === kWidth);
  assert.equal(await slider.getAttribute("role"), "slider");
  assert.equal(await slider.getAttribute("aria-label"), parameter.title);
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await settle(page);
  assert.ok(Math.abs((await valueOf(page, kWidth)) - (parameter.value + parameter.step)) < 1e-9);
  await page.keyboard.press("PageDown");
  await settle(page);
  assert.ok(Math.abs((await valueOf(page, kWidth)) - (parameter.value - 9 * parameter.step)) < 1e-9);
  assert.equal(Number(await slider.getAttribute("aria-valuenow")), await valueOf(page, kWidth));
  await page.keyboard.press("End");
  await settle(page);
  assert.equal(await valueOf(page, kWidth), parameter.max);
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
