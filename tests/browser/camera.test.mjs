// The camera under the visitor's hand: mouse, touch, wheel, keys and buttons.
import assert from "node:assert/strict";
import { after, before, beforeEach, test } from "node:test";
import { fingersOf, freeSpot, freeWay } from "./support/handles.mjs";
import { call, cameraOf, distance, launch, layoutOf, openPage, pictureBox, settle, valueOf } from "./support/page.mjs";

let browser, tab, page, home, free;
before(async () => {
  browser = await launch();
  tab = await openPage(browser, { width: 1000, height: 700, touch: true, drawn: false });
  page = tab.page;
  home = await cameraOf(page);
});
after(async () => {
  await browser?.close();
});
beforeEach(async () => {
  await call(page, "setCamera", home);
  await settle(page);
  free = await freeSpot(page); // lines need not be back where they were
});

async function mouseDrag(from, travel, options = {}) {
  const keys = options.keys ?? [];
  for (const key of keys) await page.keyboard.down(key);
  await page.mouse.move(...from);
  await page.mouse.down({ button: options.button ?? "left" });
  await page.mouse.move(from[0] + travel[0], from[1] + travel[1], { steps: 8 });
  await page.mouse.up({ button: options.button ?? "left" });
  for (const key of keys) await page.keyboard.up(key);
  await settle(page);
}

const subtract = (a, b) => a.map((value, i) => value - b[i]);
const range = (camera) => Math.hypot(...subtract(camera.eye, camera.target));
const azimuthDeg = (camera) =>
  (Math.atan2(camera.eye[0] - camera.target[0], camera.eye[2] - camera.target[2]) * 180) / Math.PI;
const near = (actual, expected, tolerance, what) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual} instead of ${expected} ± ${tolerance}`);

/** Where the world point is in the picture, by the layout's own matrices. */
function project(frame, point) {
  const multiply = (m, v) =>
    [0, 1, 2, 3].map((row) => [0, 1, 2, 3].reduce((sum, column) => sum + m[column * 4 + row] * v[column], 0));
  const clip = multiply(frame.projection, multiply(frame.view, [...point, 1]));
  return [((clip[0] / clip[3] + 1) / 2) * frame.size[0], ((1 - clip[1] / clip[3]) / 2) * frame.size[1]];
}

test("a mouse drag orbits: the target and the distance stay, a viewport's height is a whole turn", async () => {
  const { height } = await pictureBox(page);
  await mouseDrag(free, [height / 8, 0]);
  const camera = await cameraOf(page);
  assert.deepEqual(camera.target, home.target);
  near(range(camera), range(home), 1e-6 * range(home), "distance");
  near((azimuthDeg(home) - azimuthDeg(camera) + 720) % 360, 45, 1, "turned by");
  assert.ok(Math.abs(camera.eye[1] - home.eye[1]) < 1e-6, "a level drag keeps the height");
});

test("lines keep their places while the hand holds the camera, settle nearer to the model when it lets go, and stay there", async () => {
  const { height } = await pictureBox(page);
  const middle = ([[x0, y0], [x1, y1]]) => [(x0 + x1) / 2, (y0 + y1) / 2];
  const meanPx = ({ lines }) => lines.reduce((sum, { line, base }) => sum + distance(middle(line.screen), middle(base.screen)), 0) / lines.length;
  const places = ({ lines }) => lines.map(({ identity, line }) => [identity, ...line.screen.flat()]);
  const pause = () => page.waitForTimeout(600); // longer than a camera that nobody holds has to stand still
  await page.mouse.move(...free);
  await page.mouse.down();
  await page.mouse.move(free[0] + height / 4, free[1], { steps: 60 });
  await settle(page);
  const held = await layoutOf(page);
  await pause();
  assert.deepEqual(places(await layoutOf(page)), places(held));
  await page.mouse.up();
  await settle(page);
  const rests = await layoutOf(page);
  assert.ok(meanPx(rests) < 0.95 * meanPx(held), `${meanPx(rests)} px instead of ${meanPx(held)}`);
  await pause();
  assert.deepEqual(places(await layoutOf(page)), places(rests));
});

test("orbiting never turns the picture over", async () => {
  const { height } = await pictureBox(page);
  await mouseDrag(free, [0, Math.min(height * 0.4, 300)]);
  await mouseDrag(free, [0, Math.min(height * 0.4, 300)]);
  const camera = await cameraOf(page);
  assert.ok(camera.eye[1] > camera.target[1]);
  assert.ok(Object.values(camera).flat().every(Number.isFinite));
});

test("the secondary button, and the primary one with Shift, pan: what is at the target stays under the pointer", async () => {
  for (const options of [{ button: "right" }, { keys: ["Shift"] }, { keys: ["Control"] }]) {
    await call(page, "setCamera", home);
    await settle(page);
    const before = project(await layoutOf(page), home.target);
    await mouseDrag(free, [70, -40], options);
    const frame = await layoutOf(page);
    const after = project(frame, home.target);
    near(after[0] - before[0], 70, 1, `pan in x by ${JSON.stringify(options)}`);
    near(after[1] - before[1], -40, 1, `pan in y by ${JSON.stringify(options)}`);
    near(range(await cameraOf(page)), range(home), 1e-6 * range(home), "distance");
  }
});

test("the wheel zooms, at the pointer, and the page does not scroll", async () => {
  const scrolled = () => page.evaluate(() => [scrollX, scrollY, document.querySelector(".scroller").scrollTop]);
  const before = await scrolled();
  await page.mouse.move(...free);
  await page.mouse.wheel(0, -300);
  await settle(page);
  const nearer = await cameraOf(page);
  assert.ok(range(nearer) < 0.95 * range(home), `from ${range(home)} to ${range(nearer)} m`);
  await page.mouse.wheel(0, 300);
  await settle(page);
  near(range(await cameraOf(page)), range(home), 0.01 * range(home), "back again");
  assert.deepEqual(await scrolled(), before);
});

test("one finger orbits", async () => {
  await touchGesture([free], [[free[0] + 80, free[1]]]);
  const camera = await cameraOf(page);
  assert.deepEqual(camera.target, home.target);
  assert.ok(Math.abs(azimuthDeg(camera) - azimuthDeg(home)) > 5);
});

test("two fingers pinch: spreading them to twice the distance doubles the picture", async () => {
  const [x, y] = free;
  const frame = await layoutOf(page);
  const sample = frame.lines[0].base.world;
  const sizeOf = (f) => distance(project(f, sample[0]), project(f, sample[1]));
  await touchGesture([[x - 40, y], [x + 40, y]], [[x - 80, y], [x + 80, y]]);
  const zoom = sizeOf(await layoutOf(page)) / sizeOf(frame);
  assert.ok(zoom > 1.5 && zoom < 3, `the picture grew by ${zoom}`);
});

test("two fingers side by side pan", async () => {
  const [x, y] = free;
  const before = project(await layoutOf(page), home.target);
  await touchGesture([[x - 30, y], [x + 30, y]], [[x + 20, y + 30], [x + 80, y + 30]]);
  const after = project(await layoutOf(page), home.target);
  near(after[0] - before[0], 50, 6, "pan in x");
  near(after[1] - before[1], 30, 6, "pan in y");
});

test("a finger that came down on a switch orbits when it goes on, two of which one did pinch, and only a tap switches it", async () => {
  const middle = async () => {
    const { x, y, width, height } = await page.locator('.pill[data-name="Balcony"]').boundingBox();
    return [x + width / 2, y + height / 2];
  };
  const was = await valueOf(page, "Balcony");
  const [x, y] = await middle();
  await touchGesture([[x, y]], [[x + 80, y]]);
  const turned = await cameraOf(page);
  assert.ok(Math.abs(azimuthDeg(turned) - azimuthDeg(home)) > 5);
  const at = await middle();
  const way = await freeWay(page, at, 100);
  await touchGesture([at, [at[0] + way[0], at[1] + way[1]]], [at, [at[0] + 2 * way[0], at[1] + 2 * way[1]]]);
  const zoom = range(turned) / range(await cameraOf(page));
  assert.ok(zoom > 1.5 && zoom < 3, `the picture grew by ${zoom}`);
  assert.equal(await valueOf(page, "Balcony"), was);
  await call(page, "setCamera", home);
  await settle(page);
  await touchGesture([await middle()], [await middle()]);
  assert.equal(await valueOf(page, "Balcony"), !was);
  await call(page, "undo");
  await settle(page);
});

/** Fingers go down at `from`, move to `to` in eight steps, and up. */
async function touchGesture(from, to) {
  const fingers = await fingersOf(page);
  const points = (share) => from.map(([x, y], i) => [x + (to[i][0] - x) * share, y + (to[i][1] - y) * share]);
  await fingers.down(...points(0));
  for (let i = 1; i <= 8; ++i) await fingers.move(...points(i / 8));
  await fingers.up();
  await settle(page);
}

test("the view buttons look along the axes, and fit shows the whole model", async () => {
  const directionOf = async () => {
    const { eye, target } = await cameraOf(page);
    return subtract(eye, target).map((v) => v / Math.hypot(...subtract(eye, target)));
  };
  for (const [view, axis] of [
    ["front", [0, 0, 1]],
    ["right", [1, 0, 0]],
    ["top", [0, 1, 0]],
  ]) {
    await page.click(`[data-view="${view}"]`);
    await settle(page);
    const direction = await directionOf();
    assert.ok(
      distance(direction, axis) < 0.01 && Math.abs(direction[2] - axis[2]) < 0.01,
      `${view}: from ${direction}`,
    );
  }
  await page.click('[data-view="three-quarter"]');
  await settle(page);
  await page.mouse.move(...free);
  await page.mouse.wheel(0, -2000);
  await page.click("#fit");
  await settle(page);
  const frame = await layoutOf(page);
  for (const line of frame.lines) {
    for (const [x, y] of line.base.screen) {
      assert.ok(x > 0 && y > 0 && x < frame.size[0] && y < frame.size[1], `${line.parameter} is cut off`);
    }
  }
});

test("keys: F fits, 1 is the front, 5 changes the projection; in a text field they are text", async () => {
  await page.locator("dimline-editor").locator("canvas").focus();
  await page.keyboard.press("1");
  await settle(page);
  const front = await cameraOf(page);
  assert.ok(Math.abs(front.eye[0] - front.target[0]) < 1e-6 * range(front));
  await page.keyboard.press("5");
  await settle(page);
  assert.ok((await cameraOf(page)).orthoHeight > 0);
  await page.keyboard.press("5");
  await settle(page);
  assert.equal((await cameraOf(page)).orthoHeight, undefined);
  await page.mouse.move(...free);
  await page.mouse.wheel(0, 3000);
  await settle(page);
  const far = range(await cameraOf(page));
  await page.keyboard.press("f");
  await settle(page);
  assert.ok(range(await cameraOf(page)) < far);

  const before = await cameraOf(page);
  await page.locator("#panel input.number").first().focus();
  await page.keyboard.type("7");
  await page.keyboard.press("Escape");
  await settle(page);
  assert.deepEqual(await cameraOf(page), before);
});

test("arrow keys turn the picture, with Shift they move it, plus and minus zoom", async () => {
  await page.locator("dimline-editor").locator("canvas").focus();
  const press = async (key) => {
    await call(page, "setCamera", home);
    await page.keyboard.press(key);
    await settle(page);
    return cameraOf(page);
  };
  const left = await press("ArrowLeft");
  near((azimuthDeg(left) - azimuthDeg(home) + 360) % 360, 15, 0.01, "turned by");
  near(range(left), range(home), 1e-6 * range(home), "distance");
  assert.ok((await press("ArrowDown")).eye[1] > home.eye[1] + 1);
  const moved = await press("Shift+ArrowUp");
  assert.ok(moved.target[1] < home.target[1]);
  for (let i = 0; i < 3; ++i) near(moved.eye[i] - moved.target[i], home.eye[i] - home.target[i], 1e-6 * range(home), "the same way");
  assert.ok(range(await press("+")) < range(home));
  assert.ok(range(await press("-")) > range(home));
});

test("a key that is held down switches once", async () => {
  await page.locator("dimline-editor").locator("canvas").focus();
  for (let i = 0; i < 4; ++i) await page.keyboard.down("5"); // but for the first, repeats
  await page.keyboard.up("5");
  await settle(page);
  assert.ok((await cameraOf(page)).orthoHeight > 0);
});

test("another button that is pressed and let go of in the middle of a drag takes nothing back, and the drag goes on", async () => {
  await page.mouse.move(...free);
  await page.mouse.down();
  await page.mouse.move(free[0] + 40, free[1], { steps: 3 });
  await page.mouse.down({ button: "right" });
  await page.mouse.up({ button: "right" });
  await page.mouse.move(free[0] + 80, free[1], { steps: 3 });
  await page.mouse.up();
  await settle(page);
  const { height } = await pictureBox(page);
  near((azimuthDeg(home) - azimuthDeg(await cameraOf(page)) + 720) % 360, (80 / height) * 360, 1, "turned by");

  // And one that is let go of while the other is still down has ended.
  const turned = await cameraOf(page);
  await page.mouse.move(...free);
  await page.mouse.down();
  await page.mouse.move(free[0] + 40, free[1], { steps: 3 });
  await page.mouse.down({ button: "right" });
  await page.mouse.up();
  const ended = await cameraOf(page);
  await page.mouse.move(free[0] + 90, free[1], { steps: 3 });
  await page.mouse.up({ button: "right" });
  await settle(page);
  assert.ok(Math.abs(azimuthDeg(ended) - azimuthDeg(turned)) > 1);
  assert.deepEqual((await cameraOf(page)).eye, ended.eye);
});

test("what is seen at the target keeps its size when the projection changes", async () => {
  const before = await layoutOf(page);
  const up = home.target.map((v, i) => v + (i === 1 ? 1 : 0));
  const size = (frame) => distance(project(frame, home.target), project(frame, up));
  await page.click("#projection");
  await settle(page);
  near(size(await layoutOf(page)), size(before), 0.05 * size(before), "a metre at the target");
  await page.click("#projection");
  await settle(page);
});

test("nothing of all this made the page complain", () => {
  assert.deepEqual(tab.complaints, []);
});
