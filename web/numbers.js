/** Numbers and words of a parameter as controls need them. */

/** How many decimals a parameter's values are shown with: as many as its step has, two when any value will do. */
export function decimalsOf(parameter) {
  if (parameter.type === "int") return 0;
  if (!parameter.step) return 2;
  for (let decimals = 0; decimals < 6; ++decimals) {
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

export const kUnits = { m: "m", deg: "°", m2: "m²", "": "" };

/** The name of a choice, for people: "half-hip" is "Half hip". */
export const choiceTitle = (choice) => choice.charAt(0).toUpperCase() + choice.slice(1).replaceAll("-", " ");
