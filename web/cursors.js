/** Cursor shapes that show which way something can be dragged. */

/**
 * The resize cursor for a direction on screen (x right, y down): one of four, by the nearest.
 * @param {[number, number]} direction
 * @returns {"ew" | "nwse" | "ns" | "nesw"}
 */
export function cursorAlong([dx, dy]) {
  const eighths = Math.round((Math.atan2(dy, dx) / Math.PI) * 4);
  return ["ew", "nwse", "ns", "nesw"][((eighths % 4) + 4) % 4];
}

/**
 * The direction in which the handle of a parameter that is nearest to a place can be dragged; null when it has none there.
 * @param {object} layout as Core.layout() gives it
 */
export function dragDirection(layout, name, x, y) {
  let best = null;
  let least = Infinity;
  const consider = (handle, direction) => {
    const away = Math.hypot(handle.screen[0] - x, handle.screen[1] - y);
    if (away < least) [best, least] = [direction, away];
  };
  for (const line of layout.lines.filter(({ parameter }) => parameter === name)) {
    const [[x0, y0], [x1, y1]] = line.line.screen;
    for (const handle of line.handles) consider(handle, [x1 - x0, y1 - y0]);
  }
  for (const { type, handles, anchor } of layout.others.filter(({ parameter }) => parameter === name)) {
    if (type !== "angular") continue;
    for (const handle of handles) consider(handle, [anchor[1] - handle.screen[1], handle.screen[0] - anchor[0]]);
  }
  return best;
}
