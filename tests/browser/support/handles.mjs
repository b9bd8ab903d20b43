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

/** Places in the window, at least 100 px apart, at which fingers take hold of nothing: in the picture, far from arrows, numbers and pills. */
export async function emptyPlaces(page, count) {
  const picture = await pictureBox(page);
  const { lines, others } = await layoutOf(page);
  const taken = [...lines, ...others].flatMap(({ handles, label, box }) => [...handles.map(({ screen: [x, y] }) => [x, y, x, y]), ...(label ? [label.box] : []), ...(box ? [box] : [])]);
  const away = ([x, y]) => Math.min(...taken.map(([x0, y0, x1, y1]) => Math.hypot(Math.max(x0 - x, x - x1, 0), Math.max(y0 - y, y - y1, 0))));
  const places = [];
  for (let x = 30; x < picture.width - 20; x += 10) {
    for (let y = 30; y < picture.height - 20; y += 10) places.push([x, y]);
  }
  places.sort((a, b) => away(b) - away(a));
  const found = [];
  for (const place of places) {
    if (found.length < count && found.every((other) => distance(place, other) >= 100)) found.push(place);
  }
  assert.ok(found.length === count && found.every((place) => away(place) > 44), "a picture has empty places");
  return found.map(([x, y]) => [picture.x + x, picture.y + y]);
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
