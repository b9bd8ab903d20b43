/** The font in which labels are set. The layout measures text by its advance table, so that very font is loaded before the first label shows. */

const kFamily = "Dimline Label";
const kUrl = new URL("./assets/fonts/barlow-500.woff2", import.meta.url).href;

/** Adds it to a document, because a shadow tree's own @font-face rules count for nothing. Without it, labels show in another font. */
export async function loadLabelFont(document) {
  const known = [...document.fonts].find((face) => face.family.replaceAll('"', "") === kFamily);
  const face = known ?? new (document.defaultView?.FontFace ?? FontFace)(kFamily, `url("${kUrl}") format("woff2")`, { weight: "500" });
  if (!known) document.fonts.add(face);
  try {
    await face.load();
  } catch (error) {
    console.warn(`The label font could not be loaded from ${kUrl}; labels are shown in another one.`, error);
  }
}
