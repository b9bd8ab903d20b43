// The command line's program in WebAssembly, which is there to measure what pages run, beside the native one.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const built = (path) => fileURLToPath(new URL(`../../build/${path}`, import.meta.url));
const run = (command, ...args) => spawnSync(command, args, { encoding: "utf8" });
const native = (...args) => run(built("native/dimline"), ...args);
const inNode = (...args) => run(process.execPath, built("wasm/dimline_node.cjs"), ...args);

/** What differs between two values of JSON, beyond the last digits, in which the hosts' sines are not the same. */
function difference(a, b, path = "") {
  if (typeof a === "number" && typeof b === "number") return Math.abs(a - b) <= 1e-9 * (1 + Math.abs(a)) ? null : `${path}: ${a} and ${b}`;
  if (typeof a !== "object" || typeof b !== "object" || a === null || b === null) return a === b ? null : `${path}: ${a} and ${b}`;
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  for (const key of keys) {
    const found = difference(a[key], b[key], `${path}/${key}`);
    if (found) return found;
  }
  return null;
}

test("every model is laid out in WebAssembly as it is natively", (t) => {
  const folder = mkdtempSync(join(tmpdir(), "dimline-"));
  t.after(() => rmSync(folder, { recursive: true }));
  const cameras = Array.from({ length: 8 }, (_, i) => {
    const rad = (45 * i + 20) * (Math.PI / 180);
    return { eye: [60 * Math.sin(rad), 20 + 2 * i, 60 * Math.cos(rad)], target: [0, 4, 0], fovDeg: 35 };
  });
  writeFileSync(join(folder, "cameras.json"), JSON.stringify(cameras));
  const models = JSON.parse(native("models", "--json").stdout).map((model) => model.name);
  assert.ok(models.length >= 12);
  for (const model of models) {
    const layouts = [native, inNode].map((program) => {
      const { status, stderr } = program("layout", model, "--cameras", join(folder, "cameras.json"), "-o", join(folder, "layout.json"));
      assert.equal(status, 0, `${model}: ${stderr}`);
      return JSON.parse(readFileSync(join(folder, "layout.json"), "utf8"));
    });
    assert.equal(layouts[0].frames.length, cameras.length);
    assert.ok(layouts[0].frames.some((frame) => frame.lines.length > 0), model);
    assert.equal(difference(...layouts), null, model);
  }
});

test("times are measured in node as they are natively, but for the GPU's", () => {
  const { status, stdout, stderr } = inNode("bench", "lever", "--frames", "2", "--json");
  assert.equal(status, 0, stderr);
  const [lever] = JSON.parse(stdout);
  assert.equal(lever.model, "lever");
  for (const key of ["preprocessMs", "placerMs", "cpuFieldsMs", "visibilityMs", "rebuildMs", "straightforwardMs"]) assert.ok(lever[key] > 0, key);
  assert.equal(lever.gpuFieldsMs, null);

  const gpu = inNode("bench", "lever", "--frames", "2", "--gpu");
  assert.equal(gpu.status, 1);
  assert.match(gpu.stderr, /no OpenGL here outside a page\. Or leave --gpu out\.\n$/);
});
