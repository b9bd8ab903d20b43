// Switches, choices and angles in the picture: what stands there can be used there.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openHouse } from "./support/house.mjs";
import { call, cameraOf, distance, layoutOf, pictureBox, screenshot, settle, takeEvents, valueOf } from "./support/page.mjs";

let tab, page, defaults, camera;
openHouse({ width: 1100, height: 800, touch: true, drawn: false }, (desk) => ({ tab, page, defaults, camera } = desk));

const parameter = async (name) => (await call(page, "getParameters")).find((p) => p.name === name);
async function other(type) {
  const found = (await layoutOf(page)).others.find((candidate) => candidate.type === type);
  assert.ok(found, `the house shows no ${type} handle`);
  return found;
}
/** The middle of a box of the layout, in the window. */
async function middle([x0, y0, x1, y1]) {
  const box = await pictureBox(page);
  return [box.x + (x0 + x1) / 2, box.y + (y0 + y1) / 2];
}
const pill = (name) => page.locator("dimline-editor").locator(`.pill[data-name="${name}"]`);
const list = () => page.locator("dimline-editor").getByRole("listbox");

test("each switch and choice is a button in its layout's box, and says what it is", async () => {
  const box = await pictureBox(page);
  const placed = (await layoutOf(page)).others.filter(({ type }) => type !== "angular");
  assert.ok(placed.length >= 2);
  for (const handle of placed) {
    const { title } = await parameter(handle.parameter);
    const shown = await pill(handle.parameter).boundingBox();
    const [x0, y0, x1, y1] = handle.box;
    for (const [is, wanted] of [
      [shown.x - box.x, x0],
      [shown.y - box.y, y0],
      [shown.width, x1 - x0],
      [shown.height, y1 - y0],
    ]) {
      assert.ok(Math.abs(is - wanted) < 1, `${handle.parameter}: ${is}, not ${wanted}`);
    }
    const fits = await pill(handle.parameter).evaluate((node) => node.scrollWidth <= node.clientWidth);
    assert.ok(fits, `the text of ${handle.parameter} is wider than its pill`);
    await page.locator("dimline-editor").getByRole("button", { name: new RegExp(`^${title}`) }).waitFor();
  }
  await screenshot(page, "pills-at-rest");
});

test("a click on a switch toggles it: one undo step", async () => {
  const { parameter: name, box } = await other("boolean");
  const node = pill(name);
  assert.equal(await node.getAttribute("aria-pressed"), String(defaults[name]));
  await page.mouse.click(...(await middle(box)));
  await settle(page);
  assert.equal(await valueOf(page, name), !defaults[name]);
  assert.equal(await node.getAttribute("aria-pressed"), String(!defaults[name]));
  assert.deepEqual(await takeEvents(page), ["input", "change"]);
  await page.keyboard.press("Control+z");
  await settle(page);
  assert.equal(await valueOf(page, name), defaults[name]);
  assert.deepEqual(await cameraOf(page), camera, "the click turned the view");
});

test("a finger and the keyboard toggle it too", async () => {
  const { parameter: name, box } = await other("boolean");
  await page.touchscreen.tap(...(await middle(box)));
  await settle(page);
  assert.equal(await valueOf(page, name), !defaults[name]);
  await pill(name).focus();
  await page.keyboard.press("Space");
  await settle(page);
  assert.equal(await valueOf(page, name), defaults[name]);
});

test("a choice opens where the layout offers its options, and each can be chosen", async () => {
  const { parameter: name } = await other("range");
  for (const value of (await parameter(name)).choices) {
    await call(page, "setParameters", { [name]: defaults[name] });
    await settle(page);
    const { box, options } = await other("range");
    await page.mouse.click(...(await middle(box)));
    await settle(page);
    assert.equal(await pill(name).getAttribute("aria-expanded"), "true");
    const option = list().getByRole("option", { selected: true });
    assert.equal(await option.getAttribute("data-value"), String(defaults[name]));
    await page.mouse.click(...(await middle(options.find((o) => o.value === value).box)));
    await settle(page);
    assert.equal(await valueOf(page, name), value);
    assert.equal(await list().count(), 0);
    assert.match(await pill(name).getAttribute("aria-label"), new RegExp(value, "i"));
  }
  await screenshot(page, "choice-made");
});

test("the options close by Escape, by a click elsewhere and by a click on the choice, and change nothing", async () => {
  const { parameter: name, box } = await other("range");
  const at = await middle(box);
  const picture = await pictureBox(page);
  for (const close of [
    () => page.keyboard.press("Escape"),
    () => page.mouse.click(picture.x + 8, picture.y + picture.height - 8),
    () => page.mouse.click(...at),
  ]) {
    await page.mouse.click(...at);
    await list().waitFor();
    await close();
    await list().waitFor({ state: "detached" });
    assert.equal(await pill(name).getAttribute("aria-expanded"), "false");
  }
  await settle(page);
  assert.deepEqual((await takeEvents(page)).filter((type) => type !== "camera-change"), []);
});

test("a choice works from the keyboard as a menu does", async () => {
  const { parameter: name } = await other("range");
  const { choices } = await parameter(name);
  await pill(name).focus();
  await page.keyboard.press("ArrowDown");
  await list().waitFor();
  await page.keyboard.press("End");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await valueOf(page, name), choices.at(-2));
  // The focus is back on the choice, and a letter finds an option instead of moving the camera.
  await page.keyboard.press("Enter");
  await list().waitFor();
  await page.keyboard.press(choices.at(-1)[0]);
  await page.keyboard.press("Space");
  await settle(page);
  assert.equal(await valueOf(page, name), choices.at(-1));
  assert.deepEqual(await cameraOf(page), camera);
});

test("an open choice stays with its pill while the view turns", async () => {
  const { box } = await other("range");
  await page.mouse.click(...(await middle(box)));
  await list().waitFor();
  await call(page, "setCamera", { ...camera, eye: camera.eye.map((x, i) => x + [1.5, 0.5, -1][i]) });
  await settle(page);
  const now = await other("range");
  const picture = await pictureBox(page);
  const shown = await list().boundingBox();
  const left = Math.min(...now.options.map((o) => o.box[0]));
  const top = Math.min(...now.options.map((o) => o.box[1]));
  assert.ok(distance([shown.x - picture.x, shown.y - picture.y], [left, top]) < 1.5);
  await page.keyboard.press("Escape");
});

test("hovering over a choice says what it chooses", async () => {
  const { parameter: name, box } = await other("range");
  await page.mouse.move(...(await middle(box)));
  await settle(page);
  const tip = page.locator("dimline-editor").locator(".readout[data-shown]");
  assert.equal(await tip.textContent(), (await parameter(name)).title);
  await page.mouse.move(2, 2);
  await settle(page);
  assert.equal(await tip.count(), 0);
});

test("an angle's arrow is dragged about its centre", async () => {
  const { parameter: name, handles, anchor } = await other("angular");
  const { min, max, step } = await parameter(name);
  const picture = await pictureBox(page);
  const radius = distance(handles[0].screen, anchor);
  const start = Math.atan2(handles[0].screen[1] - anchor[1], handles[0].screen[0] - anchor[0]);
  // A few pixels behind the arrow's tip, towards the fixed leg: a smaller angle turns clockwise on screen here or not, so both ways are tried.
  for (const sense of [1, -1]) {
    const at = (rad, r = radius) => [
      picture.x + anchor[0] + r * Math.cos(rad),
      picture.y + anchor[1] + r * Math.sin(rad),
    ];
    await page.mouse.move(...at(start));
    await settle(page);
    await page.mouse.down();
    await page.mouse.move(...at(start + sense * 0.12, radius * 1.3), { steps: 4 });
    await settle(page);
    const value = await valueOf(page, name);
    assert.notEqual(value, defaults[name]);
    assert.ok(value >= min && value <= max && Math.abs(value / step - Math.round(value / step)) < 1e-9);
    const now = await other("angular");
    const [x, y] = [now.handles[0].screen[0] - anchor[0], now.handles[0].screen[1] - anchor[1]];
    const turned = (Math.atan2(y, x) - start) * sense;
    // The end follows the pointer's direction, to half a step.
    assert.ok(value === min || value === max || Math.abs(turned - 0.12) < 0.03, `turned by ${turned}`);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await settle(page);
    assert.equal(await valueOf(page, name), defaults[name]);
  }
});

test("an angle's element is a slider for the keyboard", async () => {
  const { parameter: name } = await other("angular");
  const slider = page.locator("dimline-editor").locator(`.label[data-name="${name}"]`);
  assert.equal(await slider.getAttribute("role"), "slider");
  await slider.focus();
  await page.keyboard.press("ArrowUp");
  await settle(page);
  const { step } = await parameter(name);
  assert.equal(await valueOf(page, name), defaults[name] + step);
});

test("beside the pills the picture is free: a drag that begins next to one turns the view", async () => {
  const { box } = await other("boolean");
  const picture = await pictureBox(page);
  await page.mouse.move(picture.x + box[2] + 12, picture.y + (box[1] + box[3]) / 2);
  await page.mouse.down();
  await page.mouse.move(picture.x + box[2] + 72, picture.y + (box[1] + box[3]) / 2, { steps: 3 });
  await page.mouse.up();
  await settle(page);
  assert.notDeepEqual(await cameraOf(page), camera);
});

test("without its lines the element shows neither labels nor pills", async () => {
  await page.evaluate(() => (document.querySelector("dimline-editor").linesShown = false));
  await settle(page);
  assert.equal(await page.locator("dimline-editor").locator(".pill, .label").count(), 0);
  assert.deepEqual((await layoutOf(page)).others, []);
  await page.evaluate(() => (document.querySelector("dimline-editor").linesShown = true));
  await settle(page);
  assert.ok((await page.locator("dimline-editor").locator(".pill").count()) >= 2);
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
