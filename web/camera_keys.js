/** Keys that turn, move and zoom the picture while it has the focus. They do what a mouse would that is dragged as far, or whose wheel is turned. */

const kPointer = -1; // no browser has a pointer of this number
const kSecondary = 2;
const kCtrl = 2; // with the secondary button: it turns; without: it moves
const kTurn = 1 / 24; // of the picture's height, which is a whole turn: 15 degrees
const kMove = 1 / 12;
const kNotchPx = 100;

const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const kZooms = { "+": -1, "=": -1, "-": 1, _: 1 };

/**
 * What a pressed key does to the camera, to be called with the core; null for nothing.
 * @param {KeyboardEvent} event
 * @param {HTMLElement} picture that fills the viewport
 */
export function cameraMoveOf(event, { offsetWidth: width, offsetHeight: height }) {
  if (event.altKey || event.ctrlKey || event.metaKey) return null;
  const [x, y] = [width / 2, height / 2];
  const zoom = kZooms[event.key];
  if (zoom) return (core) => core.wheel(x, y, zoom * kNotchPx, 0);
  const arrow = kArrows[event.key];
  if (!arrow) return null;
  const way = height * (event.shiftKey ? kMove : kTurn);
  const modifiers = event.shiftKey ? 0 : kCtrl;
  return (core) => {
    core.pointerDown(kPointer, "mouse", kSecondary, x, y, modifiers);
    core.pointerUp(kPointer, "mouse", kSecondary, x + way * arrow[0], y + way * arrow[1], modifiers);
  };
}
