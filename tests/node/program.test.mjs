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

/** A turn by 120 degrees in small steps, from near enough for lines of some size: lines keep their places, change them and are mended on the way. */
function cameras({ min, max }) {
  const center = min.map((low, i) => (low + max[i]) / 2);
  const distance = 1.8 * Math.hypot(...min.map((low, i) => max[i] - low));
  return Array.from({ length: 30 }, (_, i) => {
    const azimuth = (4 * i + 20) * (Math.PI / 180);
    const elevation = 20 * (Math.PI / 180);
    const direction = [Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation)];
    return { eye: center.map((c, axis) => c + distance * direction[axis]), target: center, fovDeg: 35 };
  });
}

test("every model is laid out in WebAssembly as it is natively, all along a turn", (t) => {
  const folder = mkdtempSync(join(tmpdir(), "dimline-"));
  t.after(() => rmSync(folder, { recursive: true }));
  const layout = (program, model, ...options) => {
    const { status, stderr } = program("layout", model, ...options, "-o", join(folder, "layout.json"));
    assert.equal(status, 0, `${model}: ${stderr}`);
    return JSON.parse(readFileSync(join(folder, "layout.json"), "utf8"));
  };
  const models = JSON.parse(native("models", "--json").stdout).map((model) => model.name);
  assert.ok(models.length >= 12);
  for (const model of models) {
    const turn = cameras(layout(native, model).bounds);
    writeFileSync(join(folder, "cameras.json"), JSON.stringify(turn));
    const [expected, found] = [native, inNode].map((program) => layout(program, model, "--cameras", join(folder, "cameras.json")));
    assert.equal(expected.frames.length, turn.length);
    assert.ok(expected.frames.filter((frame) => frame.lines.length > 0).length > turn.length / 2, model);
    const differs = difference(expected, found);
    assert.equal(differs, null, `${model}: ${differs}`);
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
