// The two producers of the fields in the page: what WebGL measures against what the CPU does.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { covered, nativeLayout } from "./support/native.mjs";
import { call, launch, openPage, pictureBox, settle } from "./support/page.mjs";

const kCameras = 50;

let browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser?.close();
});

let witness; // of makeCameras(), the same for every pixel ratio
const masksOf = async ({ width, height }) => {
  witness ??= { width, height, masks: (await nativeLayout("house", makeCameras(), { width, height })).masks };
  assert.deepEqual([witness.width, witness.height], [width, height]);
  return witness.masks;
};

/** Cameras all round the house: from far and near, high and low, both projections, some with parts out of view. */
function makeCameras() {
  const cameras = [];
  for (let i = 0; i < kCameras; ++i) {
    // The golden angle spreads directions evenly.
    const azimuth = i * 2.399963;
    const elevation = -0.05 + 1.3 * ((i * 0.618034) % 1);
    const range = 14 + 26 * ((i * 0.414214) % 1);
    const target = [((i * 0.31) % 1) * 4 - 2, 3 + ((i * 0.73) % 1) * 2 - 1, ((i * 0.57) % 1) * 4 - 2];
    const eye = [
      target[0] + range * Math.cos(elevation) * Math.sin(azimuth),
      target[1] + range * Math.sin(elevation),
      target[2] + range * Math.cos(elevation) * Math.cos(azimuth),
    ];
    cameras.push({
      eye,
      target,
      up: [0, 1, 0],
      ...(i % 5 === 4 ? { orthoHeight: 10 + range / 4 } : { fovDeg: 25 + (i % 7) * 6 }),
    });
  }
  return cameras;
}

// How to walk from a viewport's edge into the picture along one row or column.
const kSides = {
  left: (size, i, d) => [d, i],
  right: (size, i, d) => [size.width - 1 - d, i],
  top: (size, i, d) => [i, d],
  bottom: (size, i, d) => [i, size.height - 1 - d],
};

/** Whether the model has a part of two by two whole pixels between two depths of a row (or column), or of one beside it. */
function hasThickPart(mask, side, i, from, to) {
  const at = (row, d) => covered(mask, ...kSides[side](mask, row, d));
  for (let row = i - 1; row <= i; ++row) {
    for (let d = Math.max(0, Math.floor(from)); d + 1 < to; ++d) {
      if (at(row, d) && at(row + 1, d) && at(row, d + 1) && at(row + 1, d + 1)) return true;
    }
  }
  return false;
}

/** Each value replaced by the least of it and its neighbours: an edge that runs along the rows may lie a pixel beside itself. */
const widened = (field) => field.map((_, i) => Math.min(...field.slice(Math.max(0, i - 1), i + 2)));

for (const dpr of [1, 1.5, 3]) {
  test(`${kCameras} cameras at ${dpr} device pixels per CSS pixel`, async () => {
    const { page, complaints, close } = await openPage(browser, { width: 840, height: 456, dpr });
    const box = await pictureBox(page);
    const cameras = makeCameras();
    // Nothing of this needs a picture; without waiting for one it is quick.
    const measured = await page.evaluate((list) => {
      const editor = document.querySelector("dimline-editor");
      return list.map((camera) => {
        editor.setCamera(camera);
        return { cpu: editor.measureFields("cpu"), gpu: editor.measureFields("gpu") };
      });
    }, cameras);
    const masks = await masksOf(box);

    let compared = 0;
    let thin = 0;
    measured.forEach(({ cpu, gpu }, c) => {
      assert.deepEqual(
        [cpu.width, cpu.height, gpu.width, gpu.height],
        [box.width, box.height, box.width, box.height],
      );
      for (const side of Object.keys(kSides)) {
        const count = side === "left" || side === "right" ? box.height : box.width;
        const extent = side === "left" || side === "right" ? box.width : box.height;
        assert.equal(cpu[side].length, count);
        assert.equal(gpu[side].length, count);
        // Where there is no silhouette the field lies behind the opposite edge.
        const [near, far] = [cpu, gpu].map((fields) => fields[side].map((value) => value ?? extent + 2));
        const [nearWidened, farWidened] = [near, far].map(widened);
        for (let i = 0; i < count; ++i) {
          const where = `camera ${c}, ${side} ${i}: cpu ${cpu[side][i]}, gpu ${gpu[side][i]}`;
          if (cpu[side][i] !== null || gpu[side][i] !== null) ++compared;
          assert.ok(nearWidened[i] <= far[i] + 1, `${where}: the CPU's field is farther from the edge`);
          if (farWidened[i] <= near[i] + 1) continue;
          ++thin;
          assert.ok(
            !hasThickPart(masks[c], side, i, near[i], farWidened[i]),
            `${where}: the GPU missed a part that is 2 px wide`,
          );
        }
      }
    });
    assert.ok(
      compared > 0.2 * kCameras * 2 * (box.width + box.height),
      `only ${compared} rows and columns held anything`,
    );
    assert.ok(thin < 0.03 * compared, `${thin} of ${compared} rows and columns differ`);
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("the page can be told which producer to use", async () => {
  const { page, close } = await openPage(browser, { width: 900, height: 600 });
  const layouts = {};
  for (const producer of ["cpu", "gpu"]) {
    await page.evaluate((name) => (document.querySelector("dimline-editor").fieldsFrom = name), producer);
    await settle(page);
    assert.equal(await page.evaluate(() => document.querySelector("dimline-editor").fieldsFrom), producer);
    layouts[producer] = await call(page, "layout");
  }
  assert.deepEqual(
    layouts.gpu.lines.map((l) => l.parameter).sort(),
    layouts.cpu.lines.map((l) => l.parameter).sort(),
  );
  const message = await page.evaluate(() => {
    try {
      document.querySelector("dimline-editor").fieldsFrom = "abacus";
      return "no error";
    } catch (error) {
      return error.message;
    }
  });
  assert.match(message, /abacus/);
  await close();
});

test("however often the producers change while answers are on their way, the picture comes to rest", async () => {
  const { page, complaints, close } = await openPage(browser, { width: 840, height: 456 });
  await page.evaluate(async () => {
    const editor = document.querySelector("dimline-editor");
    for (const from of ["gpu", "cpu", "gpu", "cpu", "gpu", "cpu", "gpu", "cpu", "gpu"]) {
      editor.fieldsFrom = from;
      await new Promise(requestAnimationFrame);
    }
    editor.model = "lever";
  });
  await settle(page);
  assert.ok((await call(page, "layout")).lines.length > 3);
  assert.deepEqual(complaints, []);
  await close();
});

test("the GPU sees the same scopes as the CPU, comes to rest, and keeps up with a moving camera", async () => {
  const { page, complaints, close } = await openPage(browser, { width: 840, height: 456 });
  const cameras = makeCameras().filter((_, i) => i % 8 === 0);
  const seenFrom = async (producer) => {
    await page.evaluate((name) => (document.querySelector("dimline-editor").fieldsFrom = name), producer);
    const seen = [];
    for (const camera of cameras) {
      // Each view begins anew: on the way from one to the next, what was seen lately stays in sight for a while.
      const { eye, target } = camera;
      await call(page, "setCamera", { ...camera, eye: [2 * target[0] - eye[0], eye[1], 2 * target[2] - eye[2]] });
      await settle(page);
      await call(page, "setCamera", camera);
      await settle(page);
      seen.push((await call(page, "layout")).visible.map(([name, index]) => `${name} ${index}`).sort());
    }
    return seen;
  };
  const [cpu, gpu] = [await seenFrom("cpu"), await seenFrom("gpu")];
  cameras.forEach((_, i) => {
    const apart = [...cpu[i].filter((s) => !gpu[i].includes(s)), ...gpu[i].filter((s) => !cpu[i].includes(s))];
    // A scope of which little is seen may be on either side of the threshold.
    assert.ok(cpu[i].length > 3 && apart.length <= 0.03 * cpu[i].length + 1, `camera ${i}: ${apart}`);
  });
  // Twenty views, one a frame, without waiting for any; then the last one's scopes are shown.
  const last = await page.evaluate(async (list) => {
    const editor = document.querySelector("dimline-editor");
    for (let i = 0; i < 20; ++i) {
      editor.setCamera(list[i % list.length]);
      await new Promise(requestAnimationFrame);
    }
    editor.setCamera(list[2]);
    await editor.settled();
    return editor.layout().visible.length;
  }, cameras);
  assert.ok(Math.abs(last - gpu[2].length) <= 0.03 * gpu[2].length + 1, `${last} scopes, not ${gpu[2].length}`);
  assert.deepEqual(complaints, []);
  await close();
});
