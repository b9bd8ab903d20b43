// The page around the picture: the panel's form controls, the toolbar, and how it fits small and large windows.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { fingersOf, labelOf } from "./support/handles.mjs";
import { call, launch, layoutOf, openPage, pictureBox, ready, screenshot, settle, valueOf } from "./support/page.mjs";
import { colourStatistics, decodePng } from "./support/png.mjs";

let browser, tab, page;
before(async () => {
  browser = await launch();
  tab = await openPage(browser, { drawn: false });
  page = tab.page;
});
after(async () => {
  await browser?.close();
});

const parameters = () => call(page, "getParameters");
const row = (name) => page.locator(`[data-name="${name}"].row`);

test("the page opens under its strict policy without a complaint, and shows a picture", async () => {
  const { page: drawn, complaints, close } = await openPage(browser);
  const response = await drawn.request.get(drawn.url());
  const policy = response.headers()["content-security-policy"];
  assert.match(policy, /script-src 'self' 'wasm-unsafe-eval'(;|$)/);
  assert.match(policy, /style-src 'self'(;|$)/);
  const { colours, commonest } = colourStatistics(
    decodePng(await screenshot(drawn, "opening", { clip: await pictureBox(drawn) })),
  );
  assert.ok(colours > 30 && commonest < 0.95, `${colours} colours, one of them on ${(commonest * 100).toFixed(0)} %`);
  assert.deepEqual(complaints, []);
  await close();
});

test("every parameter has a labelled control with its value, its unit and its help", async () => {
  for (const p of await parameters()) {
    const controls = row(p.name).locator("input, select");
    assert.ok((await controls.count()) > 0, p.name);
    const described = row(p.name).locator("[aria-describedby]").first();
    const [helpId] = (await described.getAttribute("aria-describedby")).split(" ");
    const help = await page.locator(`#${helpId}`).textContent();
    assert.equal(help, p.help);
    if (["float", "int", "angle"].includes(p.type)) {
      const number = page.getByLabel(p.title, { exact: true }).and(page.locator("input.number"));
      const slider = page.getByLabel(p.title, { exact: true }).and(page.locator("input[type=range]"));
      assert.equal(Number(await number.inputValue()), p.value, p.name);
      assert.equal(Number(await slider.inputValue()), p.value, p.name);
      assert.deepEqual([await slider.getAttribute("min"), await slider.getAttribute("max")].map(Number), [
        p.min,
        p.max,
      ]);
    } else if (p.type === "bool") {
      assert.equal(await page.getByRole("switch", { name: p.title }).isChecked(), p.value);
    } else {
      assert.equal(
        await page
          .getByRole("radiogroup", { name: p.title })
          .getByRole("radio", { checked: true })
          .getAttribute("value"),
        p.value,
      );
    }
  }
  const groups = await page.locator("#panel section:not(.measures) h2").allTextContents();
  assert.deepEqual(groups, [...new Set((await parameters()).map((p) => p.group))]);
});

test("a slider in motion changes the house as it moves, and is one undo step", async () => {
  const start = await valueOf(page, "Width");
  const slider = row("Width").locator("input[type=range]");
  const box = await slider.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  const values = [];
  for (const share of [0.6, 0.7, 0.8, 0.9]) {
    await page.mouse.move(box.x + box.width * share, box.y + box.height / 2);
    await settle(page);
    values.push(await valueOf(page, "Width"));
    const line = (await layoutOf(page)).lines.find((l) => l.parameter === "Width");
    assert.equal(line.value, values.at(-1), "the picture is behind");
    assert.equal(Number(await row("Width").locator("input.number").inputValue()), values.at(-1));
  }
  await page.mouse.up();
  assert.ok(new Set(values).size === 4 && values.every((v, i) => i === 0 || v > values[i - 1]), `${values}`);
  await page.click("#undo");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), start);
  assert.equal(Number(await slider.inputValue()), start);
  await page.click("#redo");
  await settle(page);
  assert.equal(await valueOf(page, "Width"), values.at(-1));
});

test("a slider that is let go of where it began has ended, and one in motion asks for no layout", async () => {
  const slider = row("Width").locator("input[type=range]");
  const box = await slider.boundingBox();
  const { min, max } = (await parameters()).find((p) => p.name === "Width");
  const thumb = Number(await slider.evaluate((node) => parseFloat(getComputedStyle(node).getPropertyValue("--thumb")) * 16));
  const at = box.x + thumb / 2 + ((await valueOf(page, "Width")) - min) / (max - min) * (box.width - thumb);
  await page.evaluate(() => {
    const editor = document.querySelector("dimline-editor");
    const { layout } = editor;
    window.layouts = 0;
    editor.layout = function () {
      ++window.layouts;
      return layout.call(this);
    };
  });
  const y = box.y + box.height / 2;
  await page.mouse.move(at, y);
  await page.mouse.down();
  for (let i = 1; i <= 10; ++i) await page.mouse.move(at + 4 * i, y);
  for (let i = 9; i >= 0; --i) await page.mouse.move(at + 4 * i, y);
  assert.equal(await page.evaluate(() => window.layouts), 0);
  await page.mouse.up();
  await settle(page);
  assert.ok((await page.evaluate(() => window.layouts)) <= 4);
  await page.evaluate(() => delete document.querySelector("dimline-editor").layout);
  // A value that is set now is a step by itself.
  const before = await valueOf(page, "Depth");
  await call(page, "setParameterContinuous", "Depth", before + 1);
  await row("Depth").and(page.locator("[data-live]")).waitFor(); // the panel hears of it with the next frame
  assert.equal(await row("Depth").getAttribute("data-live"), "");
  await call(page, "endContinuous");
  await page.click("#undo");
  await settle(page);
  assert.equal(await valueOf(page, "Depth"), before);
});

test("a button that comes to nothing by its own click keeps the focus, and is told", async () => {
  const focused = () => page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute("aria-label"));
  await call(page, "setParameters", { Depth: 9 });
  await settle(page);
  const reset = page.getByRole("button", { name: "Reset Depth", exact: true });
  await reset.focus();
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await focused(), "Reset Depth");
  assert.equal(await reset.getAttribute("aria-disabled"), "true");
  assert.equal(await page.textContent("#told"), "Depth is reset.");
  await page.keyboard.press("Enter"); // and does nothing
  await page.focus("#reset-all");
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await focused(), "reset-all");
  assert.equal(await page.textContent("#told"), "All values are reset.");
  await page.focus("#undo");
  assert.ok(await page.isDisabled("#reset-all"));
  for (let i = 0; i < 30 && (await page.getAttribute("#undo", "aria-disabled")) !== "true"; ++i) await page.keyboard.press("Enter");
  assert.equal(await focused(), "undo");
  await page.evaluate(() => {
    const editor = document.querySelector("dimline-editor");
    while (editor.canRedo) editor.redo();
  });
  await settle(page);
});

test("a typed number is taken and clamped, an empty field is filled again, and Escape takes back what was typed", async () => {
  const { min, max } = (await parameters()).find((p) => p.name === "Depth");
  const number = row("Depth").locator("input.number");
  for (const [typed, expected] of [
    ["9.37", 9.37],
    ["1000", max],
    ["-3", min],
    ["", min],
  ]) {
    await number.fill(typed);
    await number.press("Enter");
    await settle(page);
    assert.equal(await valueOf(page, "Depth"), expected, `typed "${typed}"`);
    assert.ok(
      Math.abs(Number(await number.inputValue()) - expected) < 0.051,
      `typed "${typed}", shown ${await number.inputValue()}`,
    );
  }
  await number.fill("8");
  await number.press("Escape");
  assert.equal(await valueOf(page, "Depth"), min);
  assert.equal(Number(await number.inputValue()), min);
});

test("a number beyond the range becomes its end, and the row says so until the next one", async () => {
  const { max, default: start } = (await parameters()).find((p) => p.name === "Width");
  const number = row("Width").locator("input.number");
  const said = row("Width").locator(".problem");
  for (const key of ["Enter", "Tab"]) {
    await number.fill("999");
    await number.press(key);
    await settle(page);
    assert.equal(await valueOf(page, "Width"), max);
    assert.equal(await said.textContent(), `Width is at most ${max.toFixed(2)} m.`);
    assert.equal(await number.getAttribute("aria-invalid"), "false");
    await number.fill(String(start));
    await number.press("Enter");
    await settle(page);
    assert.equal(await said.textContent(), "");
  }
});

test("in a number's field Ctrl+Z takes back the last value, but the typing while something is typed", async () => {
  const number = row("Depth").locator("input.number");
  const start = await valueOf(page, "Depth");
  await number.fill("9");
  await number.press("Enter");
  await settle(page);
  assert.equal(await valueOf(page, "Depth"), 9);
  await number.press("Control+z");
  await settle(page);
  assert.equal(await valueOf(page, "Depth"), start);
  assert.equal(Number(await number.inputValue()), start);
  await number.press("Control+Shift+z");
  await settle(page);
  assert.equal(await valueOf(page, "Depth"), 9);
  await number.pressSequentially("11");
  await number.press("Control+z");
  await settle(page);
  assert.equal(await valueOf(page, "Depth"), 9);
  await number.press("Escape");
  await number.press("Control+z");
  await settle(page);
  assert.equal(await valueOf(page, "Depth"), start);
});

test("the row under the mouse, or else the one in use, marks its line in the picture", async () => {
  const marked = async () => {
    await settle(page);
    return page.evaluate(() => [...document.querySelector("dimline-editor").shadowRoot.querySelectorAll(".label[data-active]")].map(({ ariaLabel }) => ariaLabel));
  };
  await row("Width").locator("input[type=range]").focus();
  assert.deepEqual(await marked(), ["Width"]);
  await row("Depth").locator("label").hover();
  assert.deepEqual(await marked(), ["Depth"]);
  await page.mouse.move(5, 5);
  assert.deepEqual(await marked(), ["Width"]);
  // In the picture the mouse points for itself, though the row is still in use.
  await page.mouse.move(...(await labelOf(page, "Floors")));
  assert.deepEqual(await marked(), ["Number of floors"]);
  await page.mouse.move(5, 5);
  await page.evaluate(() => document.activeElement.blur());
  assert.deepEqual(await marked(), []);
});

test("switches and choices change the house", async () => {
  const { name, title, value } = (await parameters()).find((p) => p.type === "bool");
  await page.getByRole("switch", { name: title }).click();
  await settle(page);
  assert.equal(await valueOf(page, name), !value);
  const choice = (await parameters()).find((p) => p.type === "choice");
  for (const option of choice.choices) {
    await row(choice.name).locator(`input[value="${option}"]`).click();
    await settle(page);
    assert.equal(await valueOf(page, choice.name), option);
  }
});

test("reset brings back one value, reset all brings back all, and both can be undone", async () => {
  const changed = (await parameters()).filter((p) => p.value !== p.default);
  assert.ok(changed.length >= 3);
  const [first] = changed;
  await page.getByRole("button", { name: `Reset ${first.title}`, exact: true }).click();
  await settle(page);
  assert.equal(await valueOf(page, first.name), first.default);
  await page.click("#reset-all");
  await settle(page);
  assert.ok((await parameters()).every((p) => p.value === p.default));
  assert.ok(await page.isDisabled("#reset-all"));
  assert.ok(
    await page.getByRole("button", { name: `Reset ${first.title}`, exact: true, includeHidden: true }).isDisabled(),
  );
  await page.click("#undo");
  await settle(page);
  assert.equal((await parameters()).filter((p) => p.value !== p.default).length, changed.length - 1);
  await page.click("#reset-all");
  await settle(page);
});

test("everything that can be clicked has a name and is at least 24 px in both directions", async () => {
  const small = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select")]
      .filter((node) => node.checkVisibility({ visibilityProperty: true }))
      .flatMap((node) => {
        const { width, height } = node.getBoundingClientRect();
        const name = node.getAttribute("aria-label") ?? node.labels?.[0]?.textContent ?? node.textContent;
        return name?.trim() && width >= 23.5 && height >= 23.5
          ? []
          : [`${node.outerHTML.slice(0, 90)} ${width} x ${height}`];
      }),
  );
  assert.deepEqual(small, []);
});

test("what has no effect as the model is now is pale, says so, and can be set all the same", async () => {
  const pitch = row("RoofPitch");
  const opacity = () => pitch.locator("input[type=range]").evaluate((node) => Number(getComputedStyle(node).opacity));
  const sentence = pitch.getByText("No effect");
  assert.equal(await opacity(), 1);
  assert.ok(await sentence.isHidden());
  await call(page, "setParameters", { RoofType: "flat" });
  await settle(page);
  assert.ok((await opacity()) < 0.7);
  assert.ok(await sentence.isVisible());
  assert.equal(await page.locator(".row[data-idle]").count(), 1);
  await pitch.locator("input.number").fill("30");
  await page.keyboard.press("Enter");
  await call(page, "setParameters", { RoofType: "gable" });
  await settle(page);
  assert.equal(await valueOf(page, "RoofPitch"), 30);
  assert.equal(await opacity(), 1);
  assert.equal(await page.locator(".row[data-idle]").count(), 0);
  await page.click("#reset-all");
  await settle(page);
});

test("reloading keeps what was changed and forgets the camera, without a complaint", async () => {
  const opening = await call(page, "getCamera");
  await call(page, "setParameters", { Width: 9 });
  await call(page, "setView", "front");
  await settle(page);
  await page.reload();
  await ready(page);
  await settle(page);
  assert.equal(await valueOf(page, "Width"), 9);
  // It looks from where it did at first, from nearer by: the house is narrower.
  const { eye, target } = await call(page, "getCamera");
  for (const axis of [0, 1, 2]) assert.ok(eye[axis] - target[axis] > 0.8 * (opening.eye[axis] - opening.target[axis]));
  assert.ok(Math.hypot(...eye.map((x, i) => x - target[i])) < Math.hypot(...opening.eye.map((x, i) => x - opening.target[i])));
  await page.click("#reset-all");
  await settle(page);
  assert.deepEqual(tab.complaints, []);
});

for (const [name, width, height, dpr, touch] of [
  ["phone", 360, 740, 3, true],
  ["landscape phone", 740, 360, 2, true],
  ["tablet", 768, 1024, 1.5, true],
  ["4K", 3840, 2160, 1, false],
]) {
  test(`${name}, ${width} x ${height}: nothing is cut off, the picture dominates, and lines are shown`, async () => {
    const { page: other, complaints, close } = await openPage(browser, { width, height, dpr, touch });
    const overflow = await other.evaluate(() => [
      document.documentElement.scrollWidth - innerWidth,
      document.documentElement.scrollHeight - innerHeight,
    ]);
    assert.deepEqual(overflow, [0, 0], "the page scrolls");
    const box = await pictureBox(other);
    assert.ok(box.width * box.height > 0.4 * width * height, `the picture has ${box.width} x ${box.height}`);
    assert.ok((await layoutOf(other)).lines.length >= 3);
    const device = await other.evaluate(() => {
      const canvas = document.querySelector("dimline-editor").shadowRoot.querySelector("canvas");
      return [canvas.width, canvas.height];
    });
    assert.ok(
      Math.abs(device[0] - box.width * dpr) <= 1 && Math.abs(device[1] - box.height * dpr) <= 1,
      `the canvas has ${device} pixels`,
    );
    const cut = await other.evaluate(() =>
      [...document.querySelectorAll(".views button, .history button, #title")]
        .filter((node) => {
          const r = node.getBoundingClientRect();
          return r.right > innerWidth + 0.5 || r.bottom > innerHeight + 0.5 || r.left < 0 || r.top < 0;
        })
        .map((node) => node.id || node.dataset.view),
    );
    assert.deepEqual(cut, []);
    if (touch) {
      const narrowTargets = await other.evaluate(
        () =>
          [...document.querySelectorAll("#panel input[type=range], .views button, .history button")].filter(
            (n) => n.getBoundingClientRect().height < 40,
          ).length,
      );
      assert.equal(narrowTargets, 0, "targets for fingers are too small");
    }
    await screenshot(other, `size-${name.replace(" ", "-")}`);
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("the phone's sheet folds away and gives its room to the picture", async () => {
  const { page: phone, close } = await openPage(browser, { width: 360, height: 740, touch: true, drawn: false });
  const before = await pictureBox(phone);
  await phone.tap("#fold");
  await settle(phone);
  const folded = await pictureBox(phone);
  assert.ok(folded.height > before.height + 150);
  assert.equal(await phone.getAttribute("#fold", "aria-expanded"), "false");
  assert.deepEqual((await layoutOf(phone)).size, [folded.width, folded.height]);
  await phone.tap("#fold");
  await settle(phone);
  assert.deepEqual(await pictureBox(phone), before);
  await close();
});

test("a finger that scrolls the panel changes no value, wherever on a slider it came down", async () => {
  const { page: phone, close } = await openPage(browser, { width: 390, height: 844, touch: true });
  const fingers = await fingersOf(phone);
  const before = await call(phone, "getParameters");
  const box = await phone.locator("#parameters input[type=range]").first().boundingBox();
  const at = (movedPx) => [box.x + 0.9 * box.width + (movedPx % 2), box.y + box.height / 2 - movedPx];
  await fingers.down(at(0));
  for (let movedPx = 10; movedPx <= 120; movedPx += 10) {
    await fingers.move(at(movedPx));
    await phone.waitForTimeout(16);
  }
  await fingers.up();
  await settle(phone);
  assert.ok(await phone.evaluate(() => document.querySelector("#parameters").parentElement.scrollTop > 50), "it scrolled");
  assert.deepEqual(await call(phone, "getParameters"), before);
  assert.equal(await phone.isEnabled("#undo"), false);
  await close();
});
