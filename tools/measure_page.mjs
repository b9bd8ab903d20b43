// The half of measure_speed.py that runs in node: how long the page takes to its first picture, and how much of the core it fetches.
//
//     DIMLINE_URL=http://… node tools/measure_page.mjs
//
// Prints JSON: firstPictureMs, from the beginning of the navigation until the first frame is drawn, the median of several reloads by a browser that has all files in its cache;
// and brotliBytes, of dimline.wasm as servers compress it once.
import { readFile } from "node:fs/promises";
import { brotliCompressSync, constants } from "node:zlib";
import { openPage, withBrowser } from "../tests/browser/support/page.mjs";

const kReloads = 9;

const firstPictureMs = () => document.querySelector("dimline-editor").ready.then(() => performance.now());

const times = await withBrowser(async (browser) => {
  const { page } = await openPage(browser, { width: 1280, height: 800 });
  const measured = [];
  for (let i = 0; i < kReloads; ++i) {
    await page.reload({ waitUntil: "commit" });
    await page.waitForFunction(() => document.querySelector("dimline-editor")?.ready !== undefined);
    measured.push(await page.evaluate(firstPictureMs));
  }
  return measured.sort((a, b) => a - b);
});

const wasm = await readFile(new URL("../build/wasm/dimline.wasm", import.meta.url));
const { byteLength } = brotliCompressSync(wasm, { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24 } });

console.log(JSON.stringify({ firstPictureMs: times[kReloads >> 1], brotliBytes: byteLength }));
