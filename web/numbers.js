/** Numbers and words of a parameter as controls need them. What a visitor types is read by the core, not here. */

/**
 * How many decimals a parameter's values are shown with: as many as its step has, two when any value will do. Lengths and numbers without a unit have two at least, as in
 * the picture.
 */
export function decimalsOf(parameter) {
  if (parameter.type === "int") return 0;
  if (!parameter.step) return 2;
  for (let decimals = ["deg", "m2"].includes(parameter.unit) ? 0 : 2; decimals < 6; ++decimals) {
    const scaled = parameter.step * 10 ** decimals;
    if (Math.abs(scaled - Math.round(scaled)) < 1e-9 * scaled) return decimals;
  }
  return 6;
}

/** The value, so many steps on: within the range, and without the noise that adding up decimal fractions leaves. */
export function stepped(parameter, steps) {
  const step = parameter.step || (parameter.max - parameter.min) / 100;
  const value = Math.min(Math.max(parameter.value + steps * step, parameter.min), parameter.max);
  return Number(value.toFixed(Math.max(decimalsOf(parameter), 3)));
}

const kPageSteps = 10; // steps of Page Up and Page Down, and of Shift with an arrow

/** By how many steps a pressed key moves a slider; ±Infinity to its ends, null when it does not. */
export function keySteps(event) {
  const large = event.shiftKey ? kPageSteps : 1;
  switch (event.key) {
    case "ArrowUp":
    case "ArrowRight":
      return large;
    case "ArrowDown":
    case "ArrowLeft":
      return -large;
    case "PageUp":
      return kPageSteps;
    case "PageDown":
      return -kPageSteps;
    case "Home":
      return -Infinity;
    case "End":
      return Infinity;
  }
  return null;
}

export const kUnits = { m: "m", deg: "°", m2: "m²", "": "" };

/** The mark between whole numbers and fractions, "." or ",", that people with these languages write (BCP 47 tags, the first that is known counts). */
export function decimalMark(languages) {
  for (const language of languages) {
    try {
      const parts = new Intl.NumberFormat(language).formatToParts(0.5);
      return parts.find(({ type }) => type === "decimal")?.value === "," ? "," : ".";
    } catch {} // not a language tag
  }
  return ".";
}

/** The number with so many decimals, and with more when it has them, so that what stands there is the value. */
export function numberText(value, decimals, mark) {
  const kMostDecimals = 4;
  const exact = Number(value.toFixed(kMostDecimals));
  const needed = String(exact).split(".")[1]?.length ?? 0;
  return value.toFixed(Math.max(decimals, Math.min(needed, kMostDecimals))).replace(".", mark);
}

/** A parameter's value as a phrase: "9.40 m", "30°". */
export function valueText(parameter, mark) {
  const number = numberText(parameter.value, decimalsOf(parameter), mark);
  const unit = kUnits[parameter.unit] ?? parameter.unit;
  return unit === "°" ? `${number}°` : `${number} ${unit}`.trim();
}

/** The name of a choice, for people: "half-hip" is "Half hip". */
export const choiceTitle = (choice) => choice.charAt(0).toUpperCase() + choice.slice(1).replaceAll("-", " ");
