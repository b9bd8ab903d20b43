// The command line as an independent witness: what the same core, built natively, says of the same camera.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

const kProgram = fileURLToPath(new URL("../../../build/native/dimline", import.meta.url));

/**
 * Layouts and coverage masks of a built-in model.
 * @param {string} model
 * @param {object[]} cameras as in CAMS.json
 * @param {{width: number, height: number, values?: object}} options whole CSS pixels; values by parameter name
 * @returns {Promise<{document: object, masks: {width: number, height: number, pixels: Uint8Array}[]}>}
 */
export async function nativeLayout(model, cameras, { width, height, values = {} }) {
  const folder = await mkdtemp(join(tmpdir(), "dimline-browser-test-"));
  try {
    await writeFile(join(folder, "cameras.json"), JSON.stringify(cameras));
    const settings = Object.entries(values).flatMap(([name, value]) => ["--set", `${name}=${value}`]);
    await promisify(execFile)(kProgram, [
      "layout",
      model,
      ...settings,
      "--cameras",
      join(folder, "cameras.json"),
      "--size",
      `${width}x${height}`,
      "--masks",
      folder,
      "-o",
      join(folder, "layout.json"),
    ]);
    const document = JSON.parse(await readFile(join(folder, "layout.json"), "utf8"));
    assert.equal(document.frames.length, cameras.length);
    const masks = await Promise.all(
      cameras.map(async (_, i) => decodePgm(await readFile(join(folder, `${String(i).padStart(4, "0")}.pgm`)))),
    );
    return { document, masks };
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

function decodePgm(file) {
  const match = /^P5\s+(\d+)\s+(\d+)\s+255\s/.exec(file.toString("latin1", 0, 64));
  assert.ok(match, "a mask is not a binary PGM of 8 bits");
  const [width, height] = [Number(match[1]), Number(match[2])];
  const pixels = new Uint8Array(file.subarray(match[0].length));
  assert.equal(pixels.length, width * height);
  return { width, height, pixels };
}

/** Whether the pixel belongs to the model; what lies outside the mask does not. */
export function covered({ width, height, pixels }, x, y) {
  return x >= 0 && y >= 0 && x < width && y < height && pixels[y * width + x] === 255;
}

/** The mask without its outermost pixel all round: what surely is the model, whatever was rounded how. */
export function eroded(mask) {
  const pixels = new Uint8Array(mask.pixels.length);
  for (let y = 0; y < mask.height; ++y) {
    for (let x = 0; x < mask.width; ++x) {
      let all = true;
      for (let dy = -1; dy <= 1 && all; ++dy)
        for (let dx = -1; dx <= 1 && all; ++dx) all = covered(mask, x + dx, y + dy);
      pixels[y * mask.width + x] = all ? 255 : 0;
    }
  }
  return { ...mask, pixels };
}
