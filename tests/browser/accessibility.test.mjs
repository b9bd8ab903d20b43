// What axe-core finds wrong for people who use a screen reader or see little: nothing serious, in the page and in the element.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { labelOf, inside } from "./support/handles.mjs";
import { layoutOf, launch, openPage, pictureBox, settle } from "./support/page.mjs";

const kGrave = ["serious", "critical"];

let browser, axe;
before(async () => {
  browser = await launch();
  axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
});
after(async () => {
  await browser?.close();
});

/** What is seriously wrong, a line for each node; and how many rules were found to hold. */
async function findings(page) {
  await page.evaluate(axe);
  // What is half faded away is seen by nobody long enough to be read.
  await page.evaluate(() => {
    const running = [document, document.querySelector("dimline-editor").shadowRoot].flatMap((root) => root.getAnimations());
    return Promise.allSettled(running.map(({ finished }) => finished));
  });
  const { violations, passes } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations", "passes"] }));
  const grave = violations
    .filter(({ impact }) => kGrave.includes(impact))
    .flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary }) => `${id}: ${target.flat()}: ${failureSummary}`));
  return { grave, passed: passes.map(({ id }) => id) };
}

test("axe-core sees into the element: a name that is taken away there is found", async () => {
  const { page, close } = await openPage(browser, { drawn: false });
  await page.evaluate(() => document.querySelector("dimline-editor").shadowRoot.querySelector("[role=slider]").removeAttribute("aria-label"));
  const { grave, passed } = await findings(page);
  assert.ok(grave.length === 1 && /^aria-input-field-name/.test(grave[0]), grave.join("\n"));
  assert.ok(passed.includes("color-contrast") && passed.includes("button-name"));
  await close();
});

for (const model of ["house", "boat", "candler", "omni-tree", "lever"]) {
  test(`${model}: nothing serious`, async () => {
    const { page, close } = await openPage(browser, { path: `?model=${model}`, drawn: false });
    const { grave, passed } = await findings(page);
    assert.deepEqual(grave, []);
    assert.ok(passed.length > 15, `${passed.length} rules held`);
    await close();
  });
}

test("nothing serious while a value is typed, wrongly even, while a choice is open, and in the list of models", async () => {
  const { page, close } = await openPage(browser, { width: 1100, height: 800, drawn: false });
  await page.mouse.click(...(await labelOf(page, "Width")));
  await page.keyboard.type("3 apples");
  await page.keyboard.press("Enter");
  await inside(page, ".value-field .note").waitFor();
  assert.deepEqual((await findings(page)).grave, []);
  await page.keyboard.press("Escape");
  const { box } = (await layoutOf(page)).others.find(({ type }) => type === "range");
  const picture = await pictureBox(page);
  await page.mouse.click(picture.x + (box[0] + box[2]) / 2, picture.y + (box[1] + box[3]) / 2);
  await inside(page, "[role=listbox]").waitFor();
  await settle(page);
  assert.deepEqual((await findings(page)).grave, []);
  await page.keyboard.press("Escape");
  await page.click("#model");
  await page.locator("#models[open]").waitFor();
  assert.deepEqual((await findings(page)).grave, []);
  await close();
});

test("nothing serious on a phone, with the panel open and folded", async () => {
  const { page, close } = await openPage(browser, { width: 390, height: 844, dpr: 2, touch: true, drawn: false });
  assert.deepEqual((await findings(page)).grave, []);
  await page.tap("#fold");
  await settle(page);
  assert.deepEqual((await findings(page)).grave, []);
  await close();
});
