/** What keys mean to the editor as a whole, wherever in it the focus is. Lines, switches and choices take theirs first. */

const kViewKeys = { 0: "three-quarter", 1: "front", 3: "right", 7: "top" };

/** Whether a key goes into a field of some page, as text or as its value. */
export function isTyped(event) {
  const target = event.composedPath()[0];
  if (!target?.matches) return false;
  return target.isContentEditable || target.matches("select, textarea, input:not([type=range], [type=checkbox], [type=radio], [type=button], [type=submit])");
}

/**
 * The command that a pressed key stands for, to be called; null for none.
 * @param {KeyboardEvent} event
 * @param {import("./dimline_editor.js").DimlineEditor} editor
 * @param {() => void} peek shows hidden lines until the key is let go
 */
export function commandOf(event, editor, peek) {
  const step = travelOf(event);
  if (step) return () => editor[step]();
  if (event.altKey || event.ctrlKey || event.metaKey) return null;
  const command = plainKeyOf(event, editor, peek);
  // A key that is held down switches once.
  if (command && event.repeat && command !== peek) return () => {};
  // What moves the picture or the lines under a hand that drags waits until it lets go; undo takes the drag back.
  return command && editor.gestures.length > 0 ? () => {} : command;
}

function plainKeyOf(event, editor, peek) {
  const key = event.shiftKey ? "" : event.key.toLowerCase();
  if (key === "f") return () => editor.fitToView();
  if (key === "h") return peek;
  if (key === "m") return () => (editor.measuresShown = !editor.measuresShown);
  if (event.key === "5") return () => (editor.orthographic = !editor.orthographic);
  const view = kViewKeys[event.key];
  return view && (() => editor.setView(view));
}

/** The step through the history, "undo" or "redo", that a pressed key stands for; null for none. */
export function travelOf(event) {
  if (event.altKey || !(event.ctrlKey || event.metaKey)) return null;
  const key = event.key.toLowerCase();
  if (key === "z") return event.shiftKey ? "redo" : "undo";
  return key === "y" ? "redo" : null;
}
