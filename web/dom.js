/** Makes elements in few words. */

/**
 * A button that can be used or not. One that has the focus keeps it, or whoever is there by the keyboard would be nowhere; it only says that it does nothing, which
 * its click has to keep to.
 */
export function setEnabled(button, enabled) {
  if (button.getAttribute("aria-disabled") === String(!enabled)) return;
  button.setAttribute("aria-disabled", !enabled);
  if (enabled || !button.matches(":focus")) button.disabled = !enabled;
  else button.addEventListener("blur", () => (button.disabled = button.getAttribute("aria-disabled") === "true"), { once: true });
}

/** @param {Record<string, string | boolean | null>} attributes true is an attribute without a value; false and null are none */
export function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) node.setAttribute(name, "");
    else if (value !== false && value !== null) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}
