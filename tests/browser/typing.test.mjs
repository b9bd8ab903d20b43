// Exact values: typed on the line itself and in the panel, in the visitor's own manner of writing numbers.
import assert from "node:assert/strict";
import { test } from "node:test";
import { inside, labelOf, middleOf, sliderOf } from "./support/handles.mjs";
import { openHouse } from "./support/house.mjs";
import { call, cameraOf, layoutOf, openPage, screenshot, settle, takeEvents, valueOf } from "./support/page.mjs";

let browser, tab, page, defaults;
openHouse({ width: 1100, height: 800, drawn: false }, (desk) => ({ browser, tab, page, defaults } = desk));

const field = () => inside(page, ".value-field input");
const note = () => inside(page, ".value-field .note");
const selected = () => field().evaluate((input) => input.value.slice(input.selectionStart, input.selectionEnd));
async function clickLabel(name) {
  await page.mouse.click(...(await labelOf(page, name)));
  await settle(page);
}
const focusedName = () => page.evaluate(() => document.activeElement.shadowRoot?.activeElement?.dataset.name ?? null);

test("a click on the number opens a field in its place with the value in it, all selected", async () => {
  const at = await labelOf(page, "Width");
  const camera = await cameraOf(page);
  await clickLabel("Width");
  assert.equal(await field().inputValue(), "13.00 m");
  assert.equal(await selected(), await field().inputValue());
  assert.equal(await field().getAttribute("aria-label"), "Width");
  const box = await inside(page, ".value-field").boundingBox();
  assert.ok(Math.hypot(box.x + box.width / 2 - at[0], box.y + box.height / 2 - at[1]) < 3, "the field is beside its line");
  assert.ok(box.width < 120 && box.height < 34, `the field has ${box.width} x ${box.height} px`);
  await screenshot(page, "typing-begun");
  await page.keyboard.press("Escape");
  await settle(page);
  assert.equal(await field().count(), 0);
  assert.deepEqual(await cameraOf(page), camera);
  assert.deepEqual(await takeEvents(page), []);
});

test("arithmetic and units are read, Enter accepts, and it is one undo step", async () => {
  const { max } = (await call(page, "getParameters")).find((p) => p.name === "Width");
  for (const [typed, expected] of [
    ["3*3.2m", 9.6],
    ["1100 cm", 11],
    ["36'6\"", 11.1252],
    ["12,34", 12.34],
    ["(10+15)/2", 12.5],
  ]) {
    assert.ok(expected < max);
    await clickLabel("Width");
    await page.keyboard.type(typed);
    await page.keyboard.press("Enter");
    await settle(page);
    assert.ok(Math.abs((await valueOf(page, "Width")) - expected) < 1e-9, `${typed} became ${await valueOf(page, "Width")}`);
    assert.equal(await field().count(), 0);
    assert.equal(await focusedName(), "Width", "the focus is not on the line");
  }
  assert.deepEqual(await takeEvents(page), Array(5).fill(["input", "change"]).flat());
  for (let i = 0; i < 5; ++i) await page.keyboard.press("Control+z");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), defaults.Width);
});

test("what is no value stays, with a sentence beside it, wherever the visitor goes", async () => {
  await clickLabel("Width");
  await page.keyboard.type("3 apples");
  await page.keyboard.press("Enter");
  assert.match(await note().textContent(), /3 apples/);
  assert.ok(await note().isVisible());
  assert.equal(await field().getAttribute("aria-invalid"), "true");
  assert.equal(await field().inputValue(), "3 apples");
  await screenshot(page, "typing-error");
  const noteBox = await note().boundingBox();
  assert.ok(noteBox.x >= 0 && noteBox.y >= 0 && noteBox.y + noteBox.height <= 800);
  await page.keyboard.press("Tab");
  assert.equal(await field().inputValue(), "3 apples");
  // A look at the picture's other side, and back to it.
  await page.mouse.move(700, 120);
  await page.mouse.down();
  await page.mouse.move(720, 120, { steps: 3 });
  await page.mouse.up();
  await settle(page);
  assert.equal(await field().inputValue(), "3 apples");
  assert.equal(await valueOf(page, "Width"), defaults.Width);
  await field().focus();
  await page.keyboard.press("Backspace");
  assert.equal(await note().textContent(), "", "the sentence stays although the text is another one");
  await page.keyboard.press("Control+a");
  await page.keyboard.type("9");
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), 9);
  await call(page, "setView", "three-quarter");
  await call(page, "fitToView");
  await settle(page);
});

test("Tab and Shift+Tab accept and go to the next line and back; after the last one the browser goes on", async () => {
  const titles = await inside(page, ".label[role=slider]").evaluateAll((nodes) => nodes.map((node) => node.getAttribute("aria-label")));
  const at = titles.indexOf("Door width");
  assert.ok(at > 0 && at < titles.length - 1, `${titles}`);
  await clickLabel("DoorWidth");
  const visited = [];
  const visit = async (key) => {
    await page.keyboard.press(key);
    await settle(page);
    assert.equal(await selected(), await field().inputValue());
    visited.push(await field().getAttribute("aria-label"));
  };
  await page.keyboard.type("1.35");
  await visit("Tab");
  assert.equal(await valueOf(page, "DoorWidth"), 1.35);
  await visit("Shift+Tab");
  await visit("Shift+Tab");
  assert.deepEqual(visited, [titles[at + 1], titles[at], titles[at - 1]]);
  await page.keyboard.press("Escape");
  await sliderOf(page, (await call(page, "getParameters")).find(({ title }) => title === titles.at(-1)).name).focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  assert.equal(await field().count(), 0);
  assert.notEqual(await page.evaluate(() => document.activeElement.shadowRoot?.activeElement?.localName), "input");
});

test("a click on any number of a chain opens the field there, and the keyboard goes on from there", async () => {
  const lines = (await layoutOf(page)).lines.filter(({ parameter, chain, label }) => parameter === "FloorHeight" && chain !== null && label);
  assert.ok(lines.length >= 2, "each floor has its number");
  for (const { label } of lines) {
    const [x, y] = await middleOf(page, label.box);
    await page.mouse.click(x, y);
    await settle(page);
    const box = await inside(page, ".value-field").boundingBox();
    assert.ok(Math.hypot(box.x + box.width / 2 - x, box.y + box.height / 2 - y) < 8, `the field is ${box.x}, ${box.y}, the click was at ${x}, ${y}`);
    await page.keyboard.press("Escape");
    assert.equal(await focusedName(), "FloorHeight");
    const focused = await page.evaluate(() => document.activeElement.shadowRoot.activeElement.getBoundingClientRect().toJSON());
    assert.ok(Math.hypot(focused.x + focused.width / 2 - x, focused.y + focused.height / 2 - y) < 8);
  }
});

test("a digit typed on a focused line begins an edit, and so does Enter", async () => {
  await sliderOf(page, "Width").focus();
  const camera = await cameraOf(page);
  await page.keyboard.type("1");
  await page.keyboard.type("0.25");
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), 10.25);
  assert.deepEqual(await cameraOf(page), camera, "a digit chose a view");
  await page.keyboard.press("Enter");
  assert.match(await field().inputValue(), /^10\.25 m$/);
  await page.keyboard.press("Escape");
  assert.equal(await focusedName(), "Width");
  await page.keyboard.press("Delete");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), defaults.Width);
});

test("a value beyond the range becomes its end, and the picture says so", async () => {
  const { max, title } = (await call(page, "getParameters")).find((p) => p.name === "Width");
  await clickLabel("Width");
  await page.keyboard.type("1000");
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), max);
  const said = inside(page, "[role=status]");
  assert.match(await said.textContent(), new RegExp(`^${title} is at most ${max}`));
  assert.ok(await inside(page, ".readout[data-shown]").isVisible());
});

test("what was said of one value goes with the next press and the next value", async () => {
  const { min, max } = (await call(page, "getParameters")).find((p) => p.name === "Width");
  const readout = inside(page, ".readout[data-shown]");
  const type = async (text) => {
    await page.keyboard.type(text);
    await page.keyboard.press("Enter");
    await settle(page);
  };
  await clickLabel("Width");
  await type("1000");
  assert.match(await readout.textContent(), new RegExp(`at most ${max}`));
  await clickLabel("Width");
  const texts = async () => (await readout.allTextContents()).join();
  assert.doesNotMatch(await texts(), /at most/, "it is there while the next value is typed");
  await type("0.1");
  assert.match(await readout.textContent(), new RegExp(`at least ${min}`));
  await page.keyboard.type("9");   // a digit begins a number
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), 9);
  assert.doesNotMatch(await texts(), /at least/, "it is there when the next value is taken");
});

test("a click elsewhere takes the value", async () => {
  await clickLabel("Width");
  await page.keyboard.type("10.5");
  await page.mouse.click(700, 120);
  await settle(page);
  assert.equal(await field().count(), 0);
  assert.equal(await valueOf(page, "Width"), 10.5);
});

test("a drag that begins on a number turns the view and opens nothing", async () => {
  const camera = await cameraOf(page);
  const at = await labelOf(page, "Depth");
  await page.mouse.move(...at);
  await page.mouse.down();
  await page.mouse.move(at[0] + 30, at[1], { steps: 4 });
  await page.mouse.up();
  await settle(page);
  assert.equal(await field().count(), 0);
  assert.notDeepEqual(await cameraOf(page), camera);
  await call(page, "setCamera", camera);
});

test("a double click on a number resets it, and undo brings the value back", async () => {
  await call(page, "setParameters", { Width: 10 });
  await settle(page);
  await page.mouse.dblclick(...(await labelOf(page, "Width")));
  await settle(page);
  assert.equal(await valueOf(page, "Width"), defaults.Width);
  assert.equal(await field().count(), 0);
  await page.keyboard.press("Control+z");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), 10);
});

test("two clicks with a value typed in between are no double click, however quick they are", async () => {
  await call(page, "setParameters", { Width: 10 });
  await settle(page);
  const at = await labelOf(page, "Width");
  await page.evaluate(() => {
    window.clickedMs = [];
    document.addEventListener("click", (event) => window.clickedMs.push(event.timeStamp), { capture: true });
  });
  // Once in a while a machine that has much to do takes longer than a double click may.
  let apartMs = Infinity;
  for (let tries = 0; apartMs > 400 && tries < 10; tries++) {
    await page.mouse.click(...at);
    await page.keyboard.type("10");
    await page.keyboard.press("Enter");
    await page.mouse.click(...at);
    await settle(page);
    apartMs = await page.evaluate(() => window.clickedMs.at(-1) - window.clickedMs.at(-2));
    assert.equal(await valueOf(page, "Width"), 10);
    assert.equal(await field().count(), 1);
    await page.keyboard.press("Escape");
    await settle(page);
  }
  assert.ok(apartMs <= 400, `the clicks were ${apartMs} ms apart`);
});

test("the panel's fields read the same, and keep what they cannot read", async () => {
  const row = page.locator('.row[data-name="Width"]');
  const number = row.locator("input.number");
  for (const [typed, expected] of [
    ["3*3.2m", 9.6],
    ["10,5", 10.5],
  ]) {
    await number.fill(typed);
    await number.press("Enter");
    await settle(page);
    assert.ok(Math.abs((await valueOf(page, "Width")) - expected) < 1e-9, typed);
    assert.equal(Number(await number.inputValue()), expected);
  }
  await number.fill("3 apples");
  await number.press("Enter");
  assert.match(await row.getByRole("alert").textContent(), /3 apples/);
  assert.equal(await number.inputValue(), "3 apples");
  await number.press("Escape");
  assert.equal(await number.inputValue(), "10.50");
  assert.equal(await row.locator(".problem").textContent(), "");
  await number.press("ArrowUp");
  await number.press("ArrowUp");
  await settle(page);
  const { step } = (await call(page, "getParameters")).find((p) => p.name === "Width");
  assert.ok(Math.abs((await valueOf(page, "Width")) - 10.5 - 2 * step) < 1e-9);
});

test("numbers are written as the visitor writes them: labels, fields and panel alike, and `lang` overrides it", async () => {
  const german = await browser.newContext({ locale: "de-DE", viewport: { width: 1000, height: 700 } });
  const other = await german.newPage();
  await other.goto(process.env.DIMLINE_URL);
  await other.evaluate(() => document.querySelector("dimline-editor").ready);
  await settle(other);
  const texts = () => inside(other, ".label:not([data-textless])").allTextContents();
  assert.ok((await texts()).includes("13,00 m"), `${await texts()}`);
  assert.equal(await other.locator('.row[data-name="Width"] input.number').inputValue(), "13,00");
  assert.equal(await sliderOf(other, "Width").getAttribute("aria-valuetext"), "13,00 m");
  await other.mouse.click(...(await labelOf(other, "Width")));
  assert.equal(await inside(other, ".value-field input").inputValue(), "13,00 m");
  await other.keyboard.type("9,25");
  await other.keyboard.press("Enter");
  await settle(other);
  assert.equal(await valueOf(other, "Width"), 9.25);
  await screenshot(other, "decimal-comma");
  await other.evaluate(() => (document.querySelector("dimline-editor").lang = "en"));
  await settle(other);
  assert.ok((await texts()).includes("9.25 m"), `${await texts()}`);
  assert.equal(await other.locator('.row[data-name="Width"] input.number').inputValue(), "9.25");
  await german.close();
});

test("under a finger the field is large enough, and asks for a keyboard with numbers", async () => {
  const { page: phone, close } = await openPage(browser, { width: 390, height: 844, dpr: 2, touch: true });
  await phone.touchscreen.tap(...(await labelOf(phone, "Width")));
  await settle(phone);
  const input = inside(phone, ".value-field input");
  assert.equal(await input.getAttribute("inputmode"), "decimal");
  const field = await inside(phone, ".value-field").boundingBox();
  assert.ok(field.height >= 40);
  const name = await inside(phone, ".readout[data-shown]").boundingBox();
  const apart = Math.max(field.x - name.x - name.width, name.x - field.x - field.width, field.y - name.y - name.height, name.y - field.y - field.height);
  assert.ok(apart >= 6, `the name stands ${apart} px from the field`);
  assert.ok((await input.evaluate((node) => parseFloat(getComputedStyle(node).fontSize))) >= 16, "the phone zooms into the field");
  assert.equal(await input.evaluate((node) => node.value.slice(node.selectionStart, node.selectionEnd)), await input.inputValue());
  await screenshot(phone, "typing-on-a-phone");
  await phone.keyboard.type("9");
  await phone.keyboard.press("Enter");
  await settle(phone);
  assert.equal(await valueOf(phone, "Width"), 9);
  await close();
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
