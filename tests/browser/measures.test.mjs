// What follows from the parameters is read, in the picture and in the panel, and never set.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { inside, middleOf } from "./support/handles.mjs";
import { call, launch, layoutOf, openPage, screenshot, settle } from "./support/page.mjs";

let browser, tab, page;
before(async () => {
  browser = await launch();
  tab = await openPage(browser, { width: 1100, height: 800, drawn: false });
  page = tab.page;
});
after(async () => {
  await browser?.close();
});

const measures = () => call(page, "getMeasures");
const inPanel = () => page.locator(".measures dl div").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));

test("the panel lists the house's measures, and they follow its parameters", async () => {
  const before = await measures();
  assert.ok(before.length >= 2, `${before.length} measures`);
  assert.deepEqual(await inPanel(), before.map(({ title, text }) => [title, text]));
  assert.equal(await page.locator(".measures input").count(), 0);
  await call(page, "setParameters", { Floors: 4 });
  await settle(page);
  const after = await measures();
  const grown = after.filter(({ value }, i) => value > before[i].value);
  assert.ok(grown.length >= 1, "two more floors change nothing");
  assert.deepEqual(await inPanel(), after.map(({ title, text }) => [title, text]));
  await call(page, "undo");
  await settle(page);
  assert.deepEqual(await measures(), before);
});

test("the button and its key show their lines, which cannot be taken hold of, and put them away again", async () => {
  const before = await layoutOf(page);
  assert.equal(before.measures, undefined);
  await page.click("#measures");
  await settle(page);
  assert.equal(await page.getAttribute("#measures", "aria-pressed"), "true");
  const shown = (await layoutOf(page)).measures;
  assert.ok(shown.length >= 1, "no measure has a line");
  await screenshot(page, "measures");
  for (const line of shown) {
    assert.deepEqual(line.handles, []);
    const { title } = (await measures()).find(({ name }) => name === line.parameter);
    await inside(page, `[role=img][aria-label="${title}: ${line.text}"]`).waitFor();
    if (!line.label) continue;
    await page.mouse.click(...(await middleOf(page, line.label.box)));
    await settle(page);
    assert.equal(await inside(page, ".value-field").count(), 0, `${title} can be typed`);
  }
  await page.keyboard.press("m");
  await settle(page);
  assert.equal(await page.getAttribute("#measures", "aria-pressed"), "false");
  assert.equal((await layoutOf(page)).measures, undefined);
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
