// glTF files as the package opens them: read by a module of their own, shown by the core.
import { test } from "node:test";
import assert from "node:assert/strict";
import { copyFile, mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { createCore } from "../../web/core.js";
import { tetrahedronGlb, tetrahedronGltf } from "../support/tetrahedron.mjs";

const kBuilt = new URL("../../build/wasm/", import.meta.url);

async function openCore(t, url = new URL("dimline.js", kBuilt)) {
  const core = await createCore({ url });
  t.after(() => core.dispose());
  core.resize(1000, 800, 1);
  core.setModel("house");
  return core;
}

const sizes = (core) => core.parameters().map((parameter) => [parameter.name, parameter.value]);
const kTetrahedron = [["Width", 2], ["Height", 3], ["Depth", 4]];

test("a .glb is a model with three sizes", async (t) => {
  const core = await openCore(t);
  const scene = await core.readGltf("tetra.glb", { bytes: tetrahedronGlb() });
  assert.notDeepEqual(sizes(core), kTetrahedron, "reading alone changes nothing");
  core.setScene(scene);
  assert.deepEqual(sizes(core), kTetrahedron);
  for (let frame = 0; core.frame(frame * 16) || !core.atRest; ++frame) assert.ok(frame < 1000, "the core comes to rest");
  const width = core.layout().lines.find((line) => line.parameter === "Width");
  assert.equal(width.value, 2);
  core.setParameters({ Width: 5 });
  core.undo();
  assert.deepEqual(sizes(core), kTetrahedron);
});

test("a .gltf takes its buffers from the files that come along, and says which is missing", async (t) => {
  const core = await openCore(t);
  core.setScene(await core.readGltf("tetra.gltf", Promise.resolve(tetrahedronGltf())));
  assert.deepEqual(sizes(core), kTetrahedron);
  await assert.rejects(core.readGltf("tetra.gltf", { bytes: tetrahedronGltf().bytes }), /^Error: tetra\.gltf: .*"tetra\.bin"/);
});

test("what a scene leaves out of its file is told, by the console to who does not ask", async (t) => {
  const core = await openCore(t);
  const { bytes, files } = tetrahedronGltf();
  const document = JSON.parse(new TextDecoder().decode(bytes));
  const { primitives } = document.meshes[0];
  primitives.push({ ...primitives[0], mode: 0 });
  const withPoints = { bytes: new TextEncoder().encode(JSON.stringify(document)), files };
  const sentence = "Mesh 0 has points or lines, which are left out.";
  const told = [];
  assert.ok(await core.readGltf("tetra.gltf", withPoints, (note) => told.push(note)));
  assert.deepEqual(told, [sentence]);
  const warn = t.mock.method(console, "warn", () => {});
  await core.readGltf("tetra.gltf", withPoints);
  await core.readGltf("tetra.gltf", tetrahedronGltf());
  assert.deepEqual(warn.mock.calls.map((call) => call.arguments), [[`tetra.gltf: ${sentence}`]]);
});

test("what is wrong with a file is an Error with its sentence, and the document stays", async (t) => {
  const core = await openCore(t);
  const before = sizes(core);
  await assert.rejects(core.readGltf("x.glb", { bytes: new Uint8Array([1, 2, 3]) }), /^Error: x\.glb: .*no glTF/);
  await assert.rejects(core.readGltf("x.glb", { bytes: "text" }), /Uint8Array/);
  await assert.rejects(core.readGltf("x.glb", Promise.reject(new Error("the network is down"))), /network is down/);
  const scene = await core.readGltf("tetra.glb", { bytes: tetrahedronGlb() });
  assert.throws(() => core.setScene(scene.subarray(0, scene.length - 1)), /damaged/);
  assert.throws(() => core.setScene(tetrahedronGlb()), /another version/);
  assert.throws(() => core.setScene("tetra.glb"), /Uint8Array/);
  assert.deepEqual(sizes(core), before);
});

test("the reader is looked for when a file is opened, and again after it was not there", async (t) => {
  const folder = await mkdtemp(join(tmpdir(), "dimline-"));
  t.after(() => rm(folder, { recursive: true }));
  const copy = (name) => copyFile(new URL(name, kBuilt), join(folder, name));
  await Promise.all(["dimline.js", "dimline.wasm"].map(copy));
  const core = await openCore(t, pathToFileURL(join(folder, "dimline.js")));
  await assert.rejects(core.readGltf("tetra.glb", { bytes: tetrahedronGlb() }), /dimline_gltf\.js/);
  await copy("dimline_gltf.js");
  await assert.rejects(core.readGltf("tetra.glb", { bytes: tetrahedronGlb() }), /dimline_gltf\.wasm/);
  await copy("dimline_gltf.wasm");
  core.setScene(await core.readGltf("tetra.glb", { bytes: tetrahedronGlb() }));
  assert.deepEqual(sizes(core), kTetrahedron);
});

test("the core that every page fetches holds nothing of the reader", async () => {
  const holds = async (name, text) => (await readFile(new URL(name, kBuilt))).includes(text);
  for (const text of ["bufferViews", "KHR_texture_transform"]) {
    assert.ok(await holds("dimline_gltf.wasm", text));
    assert.ok(!(await holds("dimline.wasm", text)), text);
  }
});
