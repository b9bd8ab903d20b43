// In every built-in model: whichever arrow is dragged, it stays with the pointer, and dragged back it leaves nothing behind.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { gripsOf, modelNames } from "./support/handles.mjs";
import { call, launch, layoutOf, openPage, pictureBox, settle, showModel } from "./support/page.mjs";

const kTravelsPx = [10, 40, 200];
const kNearPx = 3;
// How far the search for a value that would bring the handle nearer goes, px.
const kSearchPx = 60;
const kSearchStepPx = 12;

let browser, tab, page, picture;
before(async () => {
  browser = await launch();
  // Without motion a line is at once where it belongs, and a model takes a quarter of the frames.
  tab = await openPage(browser, { width: 720, height: 500, drawn: false, reducedMotion: "reduce" });
  page = tab.page;
  picture = await pictureBox(page);
});
after(async () => {
  await browser?.close();
});

// As the next frame has it: the pointer's movement has been heard of by now, and the editor asked for that frame first.
const gesture = () =>
  page.evaluate(async () => {
    await new Promise(requestAnimationFrame);
    return document.querySelector("dimline-editor").gestures[0] ?? null;
  });
const along = ([x, y], [dx, dy]) => x * dx + y * dy;

/** Where the pointer that is so far from where it took hold finds the dragged handle: px ahead of it along the line. */
async function dragTo(grip, travelPx) {
  await page.mouse.move(grip.at[0] + grip.outward[0] * travelPx, grip.at[1] + grip.outward[1] * travelPx);
  const state = await gesture();
  return { ...state, ahead: along([state.handle[0] - grip.tip[0], state.handle[1] - grip.tip[1]], grip.outward) - travelPx };
}

/** No allowed value brings the handle nearer: the next ones on both sides, found by dragging on, put it farther off. */
async function isNearest(grip, travelPx, reached) {
  for (const sense of [1, -1]) {
    for (let px = kSearchStepPx; px <= kSearchPx; px += kSearchStepPx) {
      const next = await dragTo(grip, travelPx + sense * px);
      if (next.value === reached.value) continue;
      const ahead = next.ahead + sense * px;
      if (Math.abs(ahead) < Math.abs(reached.ahead) - 0.5) return false;
      break;
    }
  }
  return true;
}

/** Drags every end of every line that the model shows; how many those were. */
async function followIn(model) {
  let count = 0;
  await showModel(page, model);
  const start = JSON.stringify(await call(page, "getParameters"));
  // Of a chain's members, which are one parameter, the first. After a drag lines may have found other places.
  const lineNow = async (name) => (await layoutOf(page)).lines.find(({ parameter }) => parameter === name);
  for (const name of new Set((await layoutOf(page)).lines.map(({ parameter }) => parameter))) {
    const ends = (await lineNow(name))?.handles.length ?? 0;
    for (let end = 0; end < ends; ++end) {
      const line = await lineNow(name);
      const grip = gripsOf(line, picture)[end];
      const what = `${model}, ${name}, ${grip.end}`;
      await page.mouse.move(...grip.at);
      await page.mouse.down();
      assert.equal((await gesture())?.parameter, name, `${what}: something else was taken hold of`);
      const sense = ++count % 2 ? 1 : -1;
      for (const travelPx of kTravelsPx) {
        const reached = await dragTo(grip, sense * travelPx);
        if (Math.abs(reached.ahead) <= kNearPx || reached.limit) continue;
        const nearest = await isNearest(grip, sense * travelPx, reached);
        assert.ok(nearest, `${what}, ${sense * travelPx} px: ${reached.value} is ${reached.ahead.toFixed(1)} px off, and another is nearer`);
      }
      await dragTo(grip, 0);
      await page.mouse.up();
      await settle(page);
      assert.equal(JSON.stringify(await call(page, "getParameters")), start, `${what}: there and back`);
      assert.equal(await page.evaluate(() => document.querySelector("dimline-editor").canUndo), false, `${what}: a step that changed nothing`);
    }
  }
  return count;
}

test("an arrow dragged by 10, 40 and 200 px stays within 3 px of the pointer, or is at its limit, or no value is nearer", async (t) => {
  const models = await modelNames(page);
  assert.equal(models.length, 12);
  let count = 0;
  for (const model of models) await t.test(model, async () => (count += await followIn(model)));
  assert.ok(count > 40, `${count} ends`);
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
