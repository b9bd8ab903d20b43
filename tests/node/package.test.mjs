// web/ as the package that hosts install: it can be imported where there is no DOM, and its core works there.
import { test } from "node:test";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { brotliCompressSync, constants } from "node:zlib";
import { Core, createCore } from "../../web/core.js";

const url = new URL("../../build/wasm/dimline.js", import.meta.url);
const kWeb = new URL("../../web/", import.meta.url);

async function openCore(t) {
  const core = await createCore({ url });
  t.after(() => core.dispose());
  core.resize(1000, 800, 1);
  core.setModel("house");
  return core;
}

function settle(core) {
  for (let frame = 0; core.frame(frame * 16) || !core.atRest; ++frame)
    assert.ok(frame < 1000, "the core comes to rest");
}

test("the element's module can be imported, and there is no element", async () => {
  const { DimlineEditor } = await import("../../web/dimline_editor.js");
  assert.equal(typeof DimlineEditor, "function");
  assert.equal(globalThis.customElements, undefined);
});

function declaredMembers(file, name) {
  const types = readFileSync(new URL(file, kWeb), "utf8");
  const body = types.slice(types.indexOf(`export class ${name}`));
  const text = body.slice(0, body.indexOf("\n}"));
  const members = [...text.matchAll(/^  (?:readonly |get |set )?(\w+)[(:]/gm)].map(([, member]) => member);
  return [...new Set(members)].sort();
}

test("the types declare exactly what the element has", async () => {
  const { DimlineEditor } = await import("../../web/dimline_editor.js");
  const kLifecycle = ["constructor", "connectedCallback", "disconnectedCallback", "adoptedCallback", "attributeChangedCallback"];
  const members = Object.getOwnPropertyNames(DimlineEditor.prototype).filter((name) => !kLifecycle.includes(name));
  const declared = declaredMembers("dimline_editor.d.ts", "DimlineEditor").filter((name) => name !== "addEventListener");   // inherited
  assert.deepEqual(declared, members.sort());
});

test("the types declare exactly what the core has", () => {
  const members = Object.getOwnPropertyNames(Core.prototype).filter((name) => name !== "constructor");
  assert.deepEqual(declaredMembers("core.d.ts", "Core"), members.sort());
});

test("a core lays out the house, and forgets everything when it is disposed of", async (t) => {
  const core = await openCore(t);
  settle(core);
  const width = core.parameters().find((p) => p.name === "Width").value;
  assert.equal(core.layout().lines.find((line) => line.parameter === "Width").value, width);
  core.dispose();
  assert.throws(() => core.layout());
  core.dispose(); // once more does nothing
});

test("what goes wrong in the core is an Error with its sentence", async (t) => {
  const core = await openCore(t);
  assert.throws(() => core.setModel("castle"), /castle/);
  assert.throws(() => core.setParameters({ Wdith: 9 }), /Wdith/);
  assert.throws(() => core.setParameters({ Width: NaN }), /Width/);
  assert.throws(() => core.setParameterContinuous("Width", undefined), /Width/);
  assert.throws(() => core.setParameters([9]), /object/);
  assert.throws(() => core.setCamera("front"), /camera/i);
  assert.throws(() => core.setStandardView("inside"), /inside/);
  assert.throws(() => core.setScene("not bytes"), /Uint8Array/);
});

test("two cores are two documents", async (t) => {
  const [a, b] = [await openCore(t), await openCore(t)];
  const widthOf = (core) => core.parameters().find((p) => p.name === "Width").value;
  const before = widthOf(b);
  a.setParameters({ Width: before + 1 });
  assert.equal(widthOf(a), before + 1);
  assert.equal(widthOf(b), before);
  a.undo();
  assert.equal(widthOf(a), before);
  assert.ok(a.canRedo && !b.canUndo);
});

test("a module that is not there is an Error that names it", async () => {
  await assert.rejects(createCore({ url: new URL("nowhere.js", url) }), /nowhere\.js/);
  await assert.rejects(createCore({ url: new URL("../../tools/node_reporter.mjs", url) }), /dimline\.wasm|core/);
});

/** The modules of web/ that load when this one does, itself too, and the other files that they name. */
function neededBy(...modules) {
  const needed = { modules: new Set(), files: new Set() };
  const follow = (name) => {
    if (needed.modules.has(name)) return;
    needed.modules.add(name);
    const text = readFileSync(new URL(name, kWeb), "utf8").replace(/\/\*[^]*?\*\//g, "");
    for (const [, imported] of text.matchAll(/^import\s[^;]*?"\.\/([^"]+)";/gm)) follow(imported);
    for (const [, file] of text.matchAll(/new URL\("\.\/([^"]+)", import\.meta\.url\)/g)) needed.files.add(file);
  };
  modules.forEach(follow);
  return needed;
}

test("the page's head names every module that the page runs, so that none is asked for only when another has come", () => {
  const { modules } = neededBy("page.js");
  assert.ok(modules.size > 20);
  const html = readFileSync(new URL("index.html", kWeb), "utf8");
  const preloaded = [...html.matchAll(/<link rel="modulepreload" href="([^"]+)">/g)].map(([, href]) => href);
  assert.deepEqual(preloaded.filter((href) => !href.startsWith("build/")).sort(), [...modules].filter((name) => name !== "page.js").sort());
});

test("the package holds what the element needs, its types, the font's licence, and nothing else", () => {
  const { modules, files } = neededBy("dimline_editor.js", "core.js");
  const needed = [...modules, ...files, "core.d.ts", "dimline_editor.d.ts", "assets/fonts/OFL.txt"];
  assert.deepEqual(JSON.parse(readFileSync(new URL("package.json", kWeb), "utf8")).files.sort(), needed.sort());
});

test("what every page fetches of the core is at most 300 kB, compressed", () => {
  const wasm = readFileSync(new URL("../../build/wasm/dimline.wasm", import.meta.url));
  const { byteLength } = brotliCompressSync(wasm, { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24 } });
  assert.ok(byteLength <= 300_000, `dimline.wasm is ${byteLength} bytes`);
});
