// A glTF file in the page: its reader is fetched with the first file, under the page's strict policy, and not before.
import assert from "node:assert/strict";
import { Buffer } from "node:buffer";
import { after, before, test } from "node:test";
import { tetrahedronGlb, tetrahedronGltf } from "../support/tetrahedron.mjs";
import { call, launch, layoutOf, openPage, pageUrl, settle, valueOf } from "./support/page.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser?.close();
});

/** A tab in which files/ holds a .glb, a .gltf with its buffer and a file that is neither; `fetched` grows with every file that the page asks for. */
async function openPageWithFiles(options) {
  const tab = await openPage(browser, { drawn: false, ...options });
  const gltf = tetrahedronGltf();
  const files = { "tetra.glb": tetrahedronGlb(), "tetra.gltf": gltf.bytes, ...gltf.files, "broken.glb": new Uint8Array([1, 2, 3]) };
  for (const [name, bytes] of Object.entries(files)) {
    await tab.page.route(pageUrl(`files/${name}`), (route) => route.fulfill({ body: Buffer.from(bytes) }));
  }
  return tab;
}

/** Sets the element's model: "load", or the message of the error event. */
function show(page, model) {
  return page.evaluate(
    (name) =>
      new Promise((resolve) => {
        const editor = document.querySelector("dimline-editor");
        editor.addEventListener("load", () => resolve("load"), { once: true });
        editor.addEventListener("error", (event) => resolve(event.message), { once: true });
        editor.model = name;
      }),
    model,
  );
}

const namesOf = async (page) => (await call(page, "getParameters")).map((parameter) => parameter.name);
const kSizes = ["Width", "Height", "Depth"];

test("a .glb and a .gltf by their addresses are models; what reads them is fetched with the first", async () => {
  const { page, complaints, close } = await openPageWithFiles();
  const fetched = () => page.evaluate(() => performance.getEntriesByType("resource").map((entry) => new URL(entry.name).pathname));
  assert.deepEqual((await fetched()).filter((path) => path.includes("dimline_gltf")), []);

  assert.equal(await show(page, "files/tetra.glb"), "load");
  await settle(page);
  assert.deepEqual(await namesOf(page), kSizes);
  assert.equal(await valueOf(page, "Depth"), 4);
  assert.ok((await layoutOf(page)).lines.some((line) => line.parameter === "Width" && line.value === 2));
  for (const file of ["dimline_gltf.js", "dimline_gltf.wasm"]) assert.ok((await fetched()).some((path) => path.endsWith(`/${file}`)), file);

  assert.equal(await show(page, "house"), "load");
  assert.equal(await show(page, "files/tetra.gltf"), "load");
  assert.deepEqual(await namesOf(page), kSizes);
  assert.deepEqual(complaints, []);
  await close();
});

test("a file that is none is an error event, and the document stays", async () => {
  const { page, close } = await openPageWithFiles();
  const before = await namesOf(page);
  assert.match(await show(page, "files/broken.glb"), /broken\.glb.*neither/);
  assert.deepEqual(await namesOf(page), before);
  await close();
});

test("without its reader a file cannot be shown, and the next one asks for the reader again", async () => {
  const { page, close } = await openPageWithFiles();
  await page.route("**/dimline_gltf.js*", (route) => route.abort());
  assert.match(await show(page, "files/tetra.glb"), /dimline_gltf\.js could not be loaded/);
  await page.unroute("**/dimline_gltf.js*");
  assert.equal(await show(page, "files/tetra.gltf"), "load");
  assert.deepEqual(await namesOf(page), kSizes);
  await close();
});

test("another model that is chosen while a file is read is the one that is shown", async () => {
  const { page, close } = await openPageWithFiles();
  await page.route("**/dimline_gltf.wasm", async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 500));
    await route.continue();
  });
  const reader = page.waitForResponse("**/dimline_gltf.wasm");
  await page.evaluate(() => (document.querySelector("dimline-editor").model = "files/tetra.glb"));
  assert.equal(await show(page, "lever"), "load");
  const names = await namesOf(page);
  assert.notDeepEqual(names, kSizes);
  await reader;
  await page.waitForTimeout(500);
  assert.deepEqual(await namesOf(page), names);
  await close();
});

test("what is done while a file is on its way, or after it could not be had, is not written under its address", async () => {
  const { page, complaints, close } = await openPageWithFiles();
  let arrived;
  const arrival = new Promise((resolve) => (arrived = resolve));
  await page.route(pageUrl("files/slow.glb"), async (route) => {
    await arrival;
    await route.fulfill({ body: Buffer.from(tetrahedronGlb()) });
  });
  const visit = (address) => page.evaluate((url) => (history.pushState(null, "", url), dispatchEvent(new PopStateEvent("popstate"))), address);
  await visit("?model=files/slow.glb#Height=6");
  await call(page, "setParameters", { Width: 9.7 });
  await page.waitForTimeout(100);
  assert.equal(page.url(), pageUrl("?model=files/slow.glb#Height=6"));
  const loaded = page.evaluate(() => new Promise((resolve) => document.querySelector("dimline-editor").addEventListener("load", resolve, { once: true })).then(() => {}));
  arrived();
  await loaded;
  await settle(page);
  assert.equal(await valueOf(page, "Height"), 6);

  await visit("?model=files/broken.glb");
  await page.waitForFunction(() => document.querySelector("#status").textContent !== "");
  const back = new URL(page.url());
  assert.deepEqual([back.searchParams.get("model"), back.hash], ["files/slow.glb", "#Height=6"], "the address is that of what is shown");
  await call(page, "setParameters", { Height: 5 });
  await settle(page);
  assert.equal(new URL(page.url()).hash, "#Height=5");
  assert.deepEqual(complaints, []);
  await close();
});
