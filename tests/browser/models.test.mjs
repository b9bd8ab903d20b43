// Choosing a model: the menu with a picture of each, and the address that remembers it.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { call, launch, openPage, pageUrl, ready, screenshot, settle, showModel } from "./support/page.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser?.close();
});

const modelOf = (page) => page.evaluate(() => document.querySelector("dimline-editor").model);
const dialog = (page) => page.getByRole("dialog", { name: "Choose a model" });
const addressedModel = (page) => new URL(page.url()).searchParams.get("model");

/** Opens the menu with the button. */
async function openMenu(page) {
  await page.getByRole("button", { name: /^Model:/ }).click();
  await dialog(page).waitFor();
}

test("the menu shows every model with its picture and its name, the present one marked", async () => {
  const { page, complaints, close } = await openPage(browser, { width: 1400, height: 900 });
  const models = await call(page, "getModels");
  assert.ok(models.length > 1, "there is one model only");
  await openMenu(page);
  const links = dialog(page).getByRole("link");
  assert.deepEqual(await links.allTextContents(), models.map((model) => model.title));
  assert.deepEqual(await dialog(page).locator("[aria-current]").allTextContents(), ["Family house"]);
  await page.waitForFunction(() => [...document.querySelectorAll("#models img")].every((image) => image.complete));
  const broken = await page.evaluate(() =>
    [...document.querySelectorAll("#models img")].filter((image) => image.naturalWidth < 300).map((image) => image.src),
  );
  assert.deepEqual(broken, [], "these pictures are missing: python3 tools/make_pictures.py draws them");
  await screenshot(page, "model-menu");
  await page.keyboard.press("Escape");
  await dialog(page).waitFor({ state: "hidden" });
  assert.equal(await modelOf(page), "house");
  assert.deepEqual(complaints, []);
  await close();
});

test("the way to other models is there under the model's name, clear of the tools, on every screen", async () => {
  for (const [width, height] of [[1280, 800], [1000, 700], [844, 390], [667, 375], [640, 360], [390, 844], [320, 568]]) {
    const { page, close } = await openPage(browser, { width, height, touch: width < 900, drawn: false });
    const { name, button, tools } = await page.evaluate(() => {
      const boxOf = (selector) => document.querySelector(selector).getBoundingClientRect();
      return { name: boxOf("#document").width, button: boxOf("#model"), tools: ["#undo", '[data-view="three-quarter"]'].map(boxOf) };
    });
    const where = `${width}x${height}`;
    assert.ok(name >= 48, `${where}: ${name} px of the name`);
    for (const tool of tools) assert.ok(tool.top >= button.bottom || tool.left >= button.right, `${where}: a tool lies over the name`);
    await close();
  }
});

test("the panel of another model begins at its top", async () => {
  const { page, close } = await openPage(browser, { drawn: false });
  const scroller = page.locator("#panel .scroller");
  await scroller.evaluate((node) => (node.scrollTop = 200));
  await showModel(page, "boat");
  assert.ok(await scroller.evaluate((node) => node.scrollHeight > node.clientHeight + 200), "this panel cannot be scrolled");
  assert.equal(await scroller.evaluate((node) => node.scrollTop), 0);
  await close();
});

test("a click chooses, the address remembers, and the browser's way back leads back", async () => {
  const { page, complaints, close } = await openPage(browser, { drawn: false });
  const other = (await call(page, "getModels")).find((model) => model.name !== "house");
  await openMenu(page);
  await dialog(page).getByRole("link", { name: other.title, exact: true }).click();
  await settle(page);
  assert.equal(await modelOf(page), other.name);
  assert.equal(addressedModel(page), other.name);
  assert.equal(await page.locator("#title").textContent(), other.title);
  assert.ok((await page.title()).startsWith(other.title));
  const names = (await call(page, "getParameters")).map((p) => p.name);
  const rows = await page.locator("#panel .row").evaluateAll((nodes) => nodes.map((node) => node.dataset.name));
  assert.deepEqual(rows.toSorted(), names.toSorted());

  await page.reload();
  await ready(page);
  await settle(page);
  assert.equal(await modelOf(page), other.name);
  await page.goBack();
  await settle(page);
  assert.equal(await modelOf(page), "house");
  assert.equal(await page.locator("#title").textContent(), "Family house");
  await page.goForward();
  await settle(page);
  assert.equal(await modelOf(page), other.name);
  assert.deepEqual(complaints, []);
  await close();
});

const valuesOf = async (page) => Object.fromEntries((await call(page, "getParameters")).map((p) => [p.name, p.value]));

test("what was changed is still there after a reload, after another model, and behind a link", async () => {
  const { page, complaints, close } = await openPage(browser, { drawn: false });
  assert.equal(new URL(page.url()).hash, "", "nothing is changed yet");
  await call(page, "setParameters", { Width: 9.7, RoofType: "hip", Balcony: false });
  await settle(page);
  const made = await valuesOf(page);
  assert.equal(made.Width, 9.7);
  const link = page.url();

  await page.reload();
  await ready(page);
  await settle(page);
  assert.deepEqual(await valuesOf(page), made);
  assert.equal(await page.locator('[data-name="Width"] .number').inputValue(), "9.70");
  assert.equal(page.url(), link);
  assert.equal(await page.evaluate(() => document.querySelector("dimline-editor").canUndo), false, "it began so");

  await openMenu(page);
  await dialog(page).getByRole("link", { name: "Galleon", exact: true }).click();
  await settle(page);
  assert.equal(new URL(page.url()).hash, "", "the galleon has its own values");
  await page.goBack();
  await settle(page);
  assert.equal(await modelOf(page), "house");
  assert.deepEqual(await valuesOf(page), made);

  // Chosen in the menu as well, it is as it was left.
  for (const title of ["Galleon", "Family house"]) {
    await openMenu(page);
    await dialog(page).getByRole("link", { name: title, exact: true }).click();
    await settle(page);
  }
  assert.deepEqual(await valuesOf(page), made);
  assert.equal(new URL(page.url()).hash, new URL(link).hash);

  // Undone to the defaults, the address says nothing; another one is followed without a reload.
  await page.getByRole("button", { name: "Reset all" }).click();
  await settle(page);
  assert.equal(new URL(page.url()).hash, "");
  await page.evaluate(() => (location.hash = "Width=10.2"));
  await settle(page);
  assert.equal((await valuesOf(page)).Width, 10.2);
  assert.equal((await valuesOf(page)).Balcony, true);
  await page.goto(link);
  await settle(page);
  assert.deepEqual(await valuesOf(page), made);
  assert.deepEqual(complaints, []);
  await close();
});

test("the model that is shown, chosen again, stays as it is", async () => {
  const { page, close } = await openPage(browser, { path: "?model=", drawn: false });
  await call(page, "setParameters", { Width: 9.7 });
  await settle(page);
  await openMenu(page);
  await dialog(page).locator("a[aria-current]").click();
  await settle(page);
  assert.equal(await modelOf(page), "house");
  assert.equal((await valuesOf(page)).Width, 9.7);
  assert.equal(await page.evaluate(() => document.querySelector("dimline-editor").canUndo), true);
  await close();
});

test("an address that asks for what cannot be had shows the rest, and says so", async () => {
  const { page, complaints, close } = await openPage(browser, { path: "#Width=wide&Depth=700&Moat=3", drawn: false });
  const parameters = await call(page, "getParameters");
  const depth = parameters.find((p) => p.name === "Depth");
  assert.equal(depth.value, depth.max);
  assert.equal(parameters.find((p) => p.name === "Width").value, parameters.find((p) => p.name === "Width").default);
  assert.match(await page.locator("#status").textContent(), /Width.*number.*Moat/);
  assert.equal(new URL(page.url()).hash, `#Depth=${depth.max}`, "and says what there is");
  assert.deepEqual(complaints, []);
  await close();
});

test("the menu works from the keyboard alone", async () => {
  const { page, close } = await openPage(browser, { drawn: false });
  const models = await call(page, "getModels");
  await page.locator("#model").focus();
  await page.keyboard.press("Enter");
  await dialog(page).waitFor();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await modelOf(page), models[1].name);
  assert.equal(await page.evaluate(() => document.activeElement.id), "model", "the focus is back where it was");
  await close();
});

test("an address that names no model shows the house, and says so", async () => {
  const { page, complaints, close } = await openPage(browser, { path: "?model=castle", drawn: false });
  assert.equal(await modelOf(page), "house");
  assert.match(await page.locator("#status").textContent(), /castle/);
  assert.equal(new URL(page.url()).search, "");
  assert.equal(page.url(), pageUrl());
  assert.deepEqual(complaints, []);
  await close();
});

for (const [width, height, touch] of [
  [360, 740, true],
  [740, 360, true],
  [768, 1024, true],
  [3840, 2160, false],
]) {
  test(`${width} x ${height}: the menu fits, and every card can be reached and is large enough`, async () => {
    const { page, close } = await openPage(browser, { width, height, touch, drawn: false });
    await openMenu(page);
    await page.waitForTimeout(300);
    const box = await dialog(page).boundingBox();
    assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= width + 0.5 && box.y + box.height <= height + 0.5);
    const cards = dialog(page).getByRole("link");
    for (let i = 0; i < (await cards.count()); ++i) {
      const card = cards.nth(i);
      await card.scrollIntoViewIfNeeded();
      const at = await card.boundingBox();
      assert.ok(at.width >= 120 && at.height >= 90, `a card of ${at.width} x ${at.height}`);
      assert.ok(at.x >= box.x && at.x + at.width <= box.x + box.width + 0.5);
    }
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.equal(overflow, 0);
    await close();
  });
}
