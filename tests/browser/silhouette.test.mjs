// No dimension line crosses the model: the page's layout against the model's pixels, which the command line gives for the very
// camera, size and values of the page.
import assert from "node:assert/strict";
import { test } from "node:test";
import { nativeLayout, covered, eroded } from "./support/native.mjs";
import { call, cameraOf, layoutOf, openPage, pictureBox, settle, withBrowser } from "./support/page.mjs";

/** Points along a segment, half a pixel apart. */
function* along([from, to]) {
  const steps = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) * 2));
  for (let i = 0; i <= steps; ++i)
    yield [from[0] + ((to[0] - from[0]) * i) / steps, from[1] + ((to[1] - from[1]) * i) / steps];
}

function pixelsOnModel(mask, points) {
  let count = 0;
  for (const [x, y] of points) count += covered(mask, Math.floor(x), Math.floor(y)) ? 1 : 0;
  return count;
}

function* inBox([x0, y0, x1, y1]) {
  for (let y = y0; y <= y1; y += 1) for (let x = x0; x <= x1; x += 1) yield [x, y];
}

/** How far (px) the outside line is from the nearest pixel of the model, looked for up to `limit`. */
function clearance(mask, points, limit) {
  let least = limit;
  for (const [x, y] of points) {
    for (let py = Math.floor(y - least); py <= y + least; ++py) {
      for (let px = Math.floor(x - least); px <= x + least; ++px) {
        if (covered(mask, px, py)) least = Math.min(least, Math.hypot(px + 0.5 - x, py + 0.5 - y));
      }
    }
  }
  return least;
}

test("while the visitor orbits, no outside line and no outside label touches the house", async () => {
  await withBrowser(async (browser) => {
    const { page, complaints } = await openPage(browser, { width: 1320, height: 856, drawn: false });
    const box = await pictureBox(page);
    assert.ok(Number.isInteger(box.width) && Number.isInteger(box.height), "the mask needs a picture of whole pixels");
    const cameras = [];
    const frames = [];
    const record = async () => {
      await settle(page);
      cameras.push(await cameraOf(page));
      frames.push(await layoutOf(page));
    };
    await record();
    for (let turn = 0; turn < 8; ++turn) {
      // Near the upper left corner, where no handle is.
      await page.mouse.move(box.x + 40, box.y + 40);
      await page.mouse.down();
      await page.mouse.move(box.x + 40 + 95, box.y + 40 + (turn % 2 ? -30 : 24), { steps: 6 });
      await page.mouse.up();
      await record();
    }
    await page.click("#projection");
    await record();
    for (const view of ["front", "right", "top"]) {
      await page.click(`[data-view="${view}"]`);
      await record();
    }

    const { document, masks } = await nativeLayout("house", cameras, { width: box.width, height: box.height });
    let outside = 0;
    frames.forEach((frame, i) => {
      const witness = document.frames[i];
      for (const matrix of ["view", "projection"]) {
        frame[matrix].forEach((value, k) =>
          assert.ok(
            Math.abs(value - witness[matrix][k]) < 1e-9,
            `camera ${i}: ${matrix} differs from the command line's`,
          ),
        );
      }
      const mask = eroded(masks[i]);
      assert.ok(mask.pixels.filter(Boolean).length > 0.02 * mask.pixels.length, `camera ${i}: the mask is empty`);
      for (const line of frame.lines) {
        if (line.placement === "inside") continue;
        ++outside;
        const where = `camera ${i} (${JSON.stringify(cameras[i])}), ${line.parameter}`;
        assert.equal(pixelsOnModel(mask, along(line.line.screen)), 0, `${where}: the line crosses the house`);
        assert.ok(clearance(masks[i], along(line.line.screen), 40) > 28, `${where}: the line is nearer than 28 px`);
        if (line.label)
          assert.equal(pixelsOnModel(mask, inBox(line.label.box)), 0, `${where}: the label is on the house`);
      }
    });
    assert.ok(outside > 3 * frames.length, `only ${outside} lines lay outside in ${frames.length} views`);
    assert.deepEqual(complaints, []);
  });
});

test("the test can fail: a line through the middle of the house is found", async () => {
  const camera = { eye: [0, 3, 30], target: [0, 3, 0], up: [0, 1, 0], fovDeg: 35 };
  const { document, masks } = await nativeLayout("house", [camera], { width: 600, height: 400 });
  const mask = eroded(masks[0]);
  const base = document.frames[0].lines.find((line) => line.parameter === "Width").base.screen;
  const middle = [300, 200];
  assert.ok(
    pixelsOnModel(
      mask,
      along([
        [middle[0] - 20, middle[1]],
        [middle[0] + 20, middle[1]],
      ]),
    ) > 20,
  );
  assert.ok(clearance(masks[0], along(base), 40) < 5);
});
