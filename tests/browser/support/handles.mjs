// Handles and labels as a visitor finds them: where they are in the window, and how they are taken hold of.
import assert from "node:assert/strict";
import { distance, layoutOf, lineOf, pictureBox } from "./page.mjs";

// px behind an arrow's tip: there a visitor takes hold of it.
const kBehindTipPx = 5;

/** The built-in models by name. */
export const modelNames = (page) => page.evaluate(() => document.querySelector("dimline-editor").getModels().map(({ name }) => name));

/** Something in the element's shadow tree. */
export const inside = (page, selector) => page.locator("dimline-editor").locator(selector);

/** The slider of a parameter. */
export const sliderOf = (page, name) => inside(page, `.label[role=slider][data-name="${name}"]`);

export const cursorOf = (page) =>
  page.evaluate(() => getComputedStyle(document.querySelector("dimline-editor").shadowRoot.querySelector(".stage")).cursor);

/** The middle of a box of the layout, in the window. */
export async function middleOf(page, [x0, y0, x1, y1]) {
  const picture = await pictureBox(page);
  return [picture.x + (x0 + x1) / 2, picture.y + (y0 + y1) / 2];
}

/** Where the number of a parameter's line stands, in the window. */
export async function labelOf(page, name) {
  const { lines, others } = await layoutOf(page);
  const line = lines.find(({ parameter, label }) => parameter === name && label);
  const arc = others.find(({ parameter }) => parameter === name);
  assert.ok(line || arc, `${name} has no label`);
  return middleOf(page, line?.label.box ?? arc.box);
}

/**
 * The ends of a line that can be dragged: where a visitor takes hold of each, in the window, and the way outwards on screen.
 * @param {object} line of a layout
 * @param {{x: number, y: number}} picture
 */
export function gripsOf({ line, handles }, picture) {
  return handles.map(({ end, screen }) => {
    const [from, to] = end === "end" ? line.screen : [...line.screen].reverse();
    const length = distance(from, to);
    const outward = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    const behind = Math.min(kBehindTipPx, length / 2);
    return { end, tip: screen, outward, at: [picture.x + screen[0] - outward[0] * behind, picture.y + screen[1] - outward[1] * behind] };
  });
}

/** The moving end of a parameter's line. */
export async function gripOf(page, name) {
  const line = lineOf(await layoutOf(page), name);
  const grips = gripsOf(line, await pictureBox(page));
  return { line, ...(grips.find(({ end }) => end === "end") ?? grips[0]) };
}

/** The moving end of an angle: where a visitor takes hold of it, in the window, and where that is after a turn about the centre on screen. */
export function arcGripOf({ handles, anchor }, picture) {
  const [x, y] = [handles[0].screen[0] - anchor[0], handles[0].screen[1] - anchor[1]];
  const turned = (rad) => [
    picture.x + anchor[0] + x * Math.cos(rad) - y * Math.sin(rad),
    picture.y + anchor[1] + x * Math.sin(rad) + y * Math.cos(rad),
  ];
  return { at: turned(0), turned };
}

/** How far a point is from a box [x0, y0, x1, y1]. */
const fromBox = ([x, y], [x0, y0, x1, y1]) => Math.hypot(Math.max(x0 - x, 0, x - x1), Math.max(y0 - y, 0, y - y1));

/** How far a point of the picture is from the nearest handle, and whether it is on or near a number, a switch or a choice. */
async function surroundings(page) {
  const frame = await layoutOf(page);
  const handles = [...frame.lines, ...frame.others].flatMap((shown) => shown.handles.map((handle) => handle.screen));
  const boxes = [...frame.lines.flatMap(({ label }) => (label ? [label.box] : [])), ...frame.others.map(({ box }) => box)];
  return (point, awayPx) => ({
    clearance: Math.min(...handles.map((handle) => distance(handle, point))),
    onBox: boxes.some((box) => fromBox(point, box) < awayPx),
  });
}

// px from the next handle, and from numbers, switches and choices, at which one finger, and two beside each other, touch nothing.
const kOneFinger = { fromHandlePx: 40, fromBoxPx: 25 };
const kTwoFingers = { fromHandlePx: 75, fromBoxPx: 45 };

/** A place in the picture, in the window's pixels, near its middle, at which so many fingers, one or two, are far from every handle and on no number, switch or choice. */
export async function freeSpot(page, fingers = 2) {
  const { fromHandlePx, fromBoxPx } = fingers === 1 ? kOneFinger : kTwoFingers;
  const box = await pictureBox(page);
  const around = await surroundings(page);
  let best = null;
  for (let x = 60; x < box.width - 60; x += 20) {
    for (let y = 60; y < box.height - 60; y += 20) {
      const { clearance, onBox } = around([x, y], fromBoxPx);
      const toMiddle = Math.hypot(x - box.width / 2, y - box.height / 2);
      if (clearance > fromHandlePx && !onBox && (!best || toMiddle < best.toMiddle)) best = { toMiddle, at: [box.x + x, box.y + y] };
    }
  }
  assert.ok(best, "the picture has a free place");
  return best.at;
}

/** The way of about so many pixels from a place in the window to one where a finger touches nothing, and on which it stays in the picture when it goes on as far again. Level or upright if may be. */
export async function freeWay(page, [x, y], px) {
  const { fromHandlePx, fromBoxPx } = kOneFinger;
  const box = await pictureBox(page);
  const around = await surroundings(page);
  const turns = [0, 0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875, 0.0625, 0.1875, 0.3125, 0.4375, 0.5625, 0.6875, 0.8125, 0.9375];
  const ways = [1, 0.85, 1.2].flatMap((far) => turns.map((turn) => [far * px * Math.cos(2 * Math.PI * turn), far * px * Math.sin(2 * Math.PI * turn)]));
  const way = ways.find(([dx, dy]) => {
    const { clearance, onBox } = around([x + dx - box.x, y + dy - box.y], fromBoxPx);
    const inPicture = fromBox([x + 2 * dx, y + 2 * dy], [box.x, box.y, box.x + box.width, box.y + box.height]) === 0;
    return inPicture && clearance > fromHandlePx && !onBox;
  });
  assert.ok(way, "a second finger has a free place");
  return way;
}

/**
 * Fingers on the screen, by the browser's own input. Each call has where they are, always in the same order, null for one that it is not about; lift() lifts
 * those that it is given, up() all.
 */
export async function fingersOf(page) {
  const session = await page.context().newCDPSession(page);
  const send = (type, ...points) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints: points.flatMap((at, id) => (at ? [{ x: at[0], y: at[1], id }] : [])) });
  return {
    down: (...points) => send("touchStart", ...points),
    move: (...points) => send("touchMove", ...points),
    lift: (...points) => send("touchEnd", ...points),
    up: () => send("touchEnd"),
  };
}
