// The half of make_pictures.py that runs in node: opens the page in Chromium and takes the pictures.
//
//     DIMLINE_URL=http://… node tools/make_pictures.mjs [MODEL… | *] [readme]
import { mkdir, stat, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";

const { chromium } = createRequire(new URL("../tests/browser/package.json", import.meta.url))("playwright-core");

const kAssets = new URL("../assets/", import.meta.url);

// A thumbnail is shown some 160 CSS pixels wide: this serves screens of three device pixels to one. It is drawn at twice
// its size and scaled down, so that rigging and leaves do not flicker out.
const kThumbnail = { width: 480, height: 360, oversampling: 2, quality: 0.82 };

// The page leaves room for dimension lines about the model; a thumbnail has none.
const kThumbnailDistance = 0.7;

const kReadme = { width: 1360, height: 860, devicePixelRatio: 1.5, quality: 84 };

/** The model by itself, without page, panel or lines, filling a box of the window's size. */
function showAlone() {
  const editor = document.querySelector("dimline-editor");
  editor.style.cssText = "position: fixed; inset: 0; z-index: 10";
  editor.linesShown = false;
}

async function drawThumbnail(page, name) {
  await page.evaluate(async (model) => {
    const editor = document.querySelector("dimline-editor");
    if (editor.model !== model) {
      const loaded = new Promise((resolve, reject) => {
        editor.addEventListener("load", resolve, { once: true });
        editor.addEventListener("error", (event) => reject(event.error), { once: true });
      });
      editor.model = model;
      await loaded;
    }
    await editor.settled();
  }, name);
  await page.evaluate(async (nearer) => {
    const editor = document.querySelector("dimline-editor");
    const camera = editor.getCamera();
    camera.eye = camera.eye.map((x, i) => camera.target[i] + (x - camera.target[i]) * nearer);
    editor.setCamera(camera);
    await editor.settled();
  }, kThumbnailDistance);
  const screenshot = (await page.screenshot()).toString("base64");
  const encoded = await page.evaluate(
    async ([png, { width, height, quality }]) => {
      const bytes = Uint8Array.from(atob(png), (character) => character.charCodeAt(0));
      const picture = await createImageBitmap(new Blob([bytes], { type: "image/png" }), {
        resizeWidth: width,
        resizeHeight: height,
        resizeQuality: "high",
      });
      const canvas = new OffscreenCanvas(width, height);
      canvas.getContext("2d").drawImage(picture, 0, 0);
      const blob = await canvas.convertToBlob({ type: "image/webp", quality });
      return [...new Uint8Array(await blob.arrayBuffer())];
    },
    [screenshot, kThumbnail],
  );
  await save(`thumbnails/${name}.webp`, Uint8Array.from(encoded));
}

async function drawThumbnails(browser, names) {
  const page = await open(browser, kThumbnail.width, kThumbnail.height, kThumbnail.oversampling);
  await page.evaluate(showAlone);
  const models = await page.evaluate(() => document.querySelector("dimline-editor").getModels());
  const known = models.map((model) => model.name);
  for (const name of names.includes("*") ? known : names) {
    if (!known.includes(name)) throw new Error(`There is no model ${name}; there are ${known.join(", ")}.`);
    await drawThumbnail(page, name);
  }
  await page.context().close();
}

async function drawReadme(browser) {
  const page = await open(browser, kReadme.width, kReadme.height, kReadme.devicePixelRatio);
  await save("readme/house.jpg", await page.screenshot({ type: "jpeg", quality: kReadme.quality }));
  await page.context().close();
}

async function open(browser, width, height, deviceScaleFactor) {
  const context = await browser.newContext({ viewport: { width, height }, deviceScaleFactor });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  await page.goto(process.env.DIMLINE_URL);
  await page.evaluate(async () => {
    const editor = document.querySelector("dimline-editor");
    await editor.ready;
    await editor.settled();
    await document.fonts.ready;
  });
  return page;
}

async function save(path, bytes) {
  const file = new URL(path, kAssets);
  await mkdir(new URL(".", file), { recursive: true });
  await writeFile(file, bytes);
  console.log(`assets/${path}  ${Math.round((await stat(file)).size / 1024)} kB`);
}

const words = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.DIMLINE_CHROMIUM || "/usr/bin/chromium",
  args: ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist", "--no-sandbox", "--disable-dev-shm-usage"],
  // The pictures are the same whatever graphics card there is.
  env: { ...process.env, LIBGL_ALWAYS_SOFTWARE: "1" },
});
try {
  const models = words.filter((word) => word !== "readme");
  if (models.length > 0) await drawThumbnails(browser, models);
  if (words.includes("readme")) await drawReadme(browser);
} catch (error) {
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await browser.close();
}
