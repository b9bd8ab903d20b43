// The dark boxes over the picture, the name of what the mouse is at and the value of what it drags: what they may not hide.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { gripsOf, inside } from "./support/handles.mjs";
import { call, launch, layoutOf, openPage, pictureBox, settle, showModel } from "./support/page.mjs";

let browser, tab, page, picture;
before(async () => {
  browser = await launch();
  tab = await openPage(browser, { width: 1100, height: 760, drawn: false, reducedMotion: "reduce" });
  page = tab.page;
  picture = await pictureBox(page);
});
after(async () => {
  await browser?.close();
});

/** px². A corner of a number, which can be read all the same. */
const kCorner = 30;

/** The box, in the picture. */
async function boxNow() {
  const { x, y, width, height } = await inside(page, ".readout[data-shown]").boundingBox();
  return [x - picture.x, y - picture.y, x - picture.x + width, y - picture.y + height];
}

const overlap = (a, b) => Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));
const contains = ([x0, y0, x1, y1], [x, y]) => x > x0 && x < x1 && y > y0 && y < y1;

/** What a box hides of numbers, switches, choices and arrows. */
async function hiddenBy(box) {
  const { lines, others } = await layoutOf(page);
  const texts = [...lines.filter(({ label }) => label).map((line) => [line.parameter, line.label.box]), ...others.map((other) => [other.parameter, other.box])];
  const covered = texts.map(([name, text]) => [name, overlap(box, text)]).filter(([, px2]) => px2 > kCorner);
  const arrows = lines.flatMap(({ parameter, handles }) => handles.filter(({ screen }) => contains(box, screen)).map(() => `an arrow of ${parameter}`));
  return [...covered.map(([name, px2]) => `${px2.toFixed(0)} px² of ${name}`), ...arrows];
}

async function gripsByName() {
  const { lines } = await layoutOf(page);
  return new Map(lines.filter(({ handles }) => handles.length > 0).map((line) => [line.parameter, gripsOf(line, picture).at(-1)]));
}

for (const model of ["omni-tree", "lever"]) {
  test(`${model}: neither names nor the values of drags hide numbers, switches or arrows, however the lines move meanwhile`, async () => {
    await showModel(page, model);
    const grips = await gripsByName();
    for (const [name, { at, outward }] of grips) {
      await page.mouse.move(...at);
      await settle(page);
      assert.deepEqual(await hiddenBy(await boxNow()), [], `the name of ${name}`);
      await page.mouse.down();
      for (const px of [4, 25, 45, -25]) {
        await page.mouse.move(at[0] + outward[0] * px, at[1] + outward[1] * px);
        await settle(page);
        const box = await boxNow();
        assert.deepEqual(await hiddenBy(box), [], `the value of ${name}, dragged by ${px} px`);
        const { handle } = await page.evaluate(() => document.querySelector("dimline-editor").gestures[0]);
        const away = Math.hypot(Math.max(box[0] - handle[0], handle[0] - box[2], 0), Math.max(box[1] - handle[1], handle[1] - box[3], 0));
        assert.ok(away < 150, `the value of ${name} is ${away.toFixed(0)} px from its arrow`);
      }
      await page.keyboard.press("Escape");
      await page.mouse.up();
      await page.mouse.move(2, 2);
      await settle(page);
    }
    assert.ok(grips.size >= 6);
  });
}

test("where there is room beside the model, the name of what the mouse is at does not stand on it", async () => {
  await showModel(page, "lever");
  const { at } = (await gripsByName()).get("SpringDiameter");
  await page.mouse.move(...at);
  await settle(page);
  const [x0, y0, x1, y1] = await boxNow();
  const { left, right, width } = await call(page, "measureFields", "cpu");
  let rows = 0;
  for (let y = Math.floor(y0); y < Math.ceil(y1); ++y) {
    if (left[y] === null) continue;
    ++rows;
    assert.ok(x1 <= left[y] || x0 >= width - right[y], `it stands on the lever at the height of ${y} px`);
  }
  assert.ok(rows > 10, "beside the lever there is nothing to stand on");
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
