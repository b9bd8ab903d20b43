// What can go wrong around the element: lost contexts, wrong input, missing pieces, coming and going.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import {
  call,
  launch,
  layoutOf,
  openPage,
  pictureBox,
  ready,
  screenshot,
  settle,
  valueOf,
  withBrowser,
} from "./support/page.mjs";
import { colourStatistics, decodePng } from "./support/png.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser?.close();
});

async function assertPicture(page, name) {
  const { colours, commonest } = colourStatistics(
    decodePng(await screenshot(page, name, { clip: await pictureBox(page) })),
  );
  assert.ok(
    colours > 30 && commonest < 0.9,
    `${name}: ${colours} colours, one of them on ${(commonest * 100).toFixed(0)} %`,
  );
}

test("a lost graphics context comes back with the picture, the values and the camera", async () => {
  const { page, complaints, close } = await openPage(browser);
  await call(page, "setParameters", { Width: 10 });
  await settle(page);
  const before = { layout: await layoutOf(page), camera: await call(page, "getCamera") };
  for (let round = 0; round < 2; ++round) {
    await page.evaluate(async () => {
      const gl = document.querySelector("dimline-editor").shadowRoot.querySelector("canvas").getContext("webgl2");
      const extension = gl.getExtension("WEBGL_lose_context");
      extension.loseContext();
      await new Promise((resolve) => setTimeout(resolve, 200));
      extension.restoreContext();
      await new Promise((resolve) => setTimeout(resolve, 200));
    });
    await settle(page);
    await assertPicture(page, `context-restored-${round}`);
  }
  assert.equal(await valueOf(page, "Width"), 10);
  assert.deepEqual(await call(page, "getCamera"), before.camera);
  assert.deepEqual((await layoutOf(page)).lines, before.layout.lines);
  assert.deepEqual(
    complaints.filter((line) => !/CONTEXT_LOST|context lost/i.test(line)),
    [],
  );
  await close();
});

test("while the context is away the page lives on", async () => {
  const { page, close } = await openPage(browser);
  await page.evaluate(async () => {
    const gl = document.querySelector("dimline-editor").shadowRoot.querySelector("canvas").getContext("webgl2");
    window.lost = gl.getExtension("WEBGL_lose_context");
    window.lost.loseContext();
    await new Promise((resolve) => setTimeout(resolve, 100));
  });
  await call(page, "setParameters", { Width: 8 });
  await page.mouse.move(300, 300);
  await page.mouse.down();
  await page.mouse.move(340, 310, { steps: 3 });
  await page.mouse.up();
  await page.mouse.wheel(0, 100);
  await settle(page);
  assert.equal(await valueOf(page, "Width"), 8);
  await page.evaluate(() => window.lost.restoreContext());
  await page.waitForTimeout(200);
  await settle(page);
  await assertPicture(page, "context-restored-after-work");
  await close();
});

test("a context that does not come back: trying again goes on with the values and the camera", async () => {
  const { page, close } = await openPage(browser);
  await call(page, "setParameters", { Width: 8 });
  await page.evaluate(() => (document.querySelector("dimline-editor").measuresShown = true));
  await call(page, "setView", "left");
  await settle(page);
  const camera = await call(page, "getCamera");
  await page.evaluate(() => {
    const gl = document.querySelector("dimline-editor").shadowRoot.querySelector("canvas").getContext("webgl2");
    gl.getExtension("WEBGL_lose_context").loseContext();
  });
  await page.locator("dimline-editor").getByRole("button", { name: "Try again" }).click();
  await ready(page);
  await settle(page);
  assert.equal(await valueOf(page, "Width"), 8);
  assert.deepEqual(await call(page, "getCamera"), camera);
  assert.equal(await page.evaluate(() => document.querySelector("dimline-editor").measuresShown), true);
  await assertPicture(page, "after-a-lost-context");
  await close();
});

test("without WebGL 2 the page says so", async () => {
  await withBrowser(
    async (without) => {
      const { page, close } = await openPage(without, { waitReady: false });
      const reason = await page.evaluate(() =>
        document.querySelector("dimline-editor").ready.then(
          () => "ready",
          (error) => error.message,
        ),
      );
      assert.match(reason, /WebGL 2/);
      const shown = page.locator("dimline-editor").getByRole("alert");
      assert.match(await shown.textContent(), /WebGL 2/);
      assert.ok(await shown.isVisible());
      await close();
    },
    ["--disable-3d-apis"],
  );
});

test("a core that cannot be loaded: a message, and trying again works", async () => {
  let broken = true;
  const { page, close } = await openPage(browser, {
    waitReady: false,
    prepare: (tab) =>
      tab.route(/dimline\.wasm/, (route) => (broken ? route.fulfill({ status: 404, body: "gone" }) : route.continue())),
  });
  const reason = await page.evaluate(() =>
    document.querySelector("dimline-editor").ready.then(
      () => "ready",
      (error) => error.message,
    ),
  );
  assert.match(reason, /dimline\.wasm/);
  assert.match(await page.locator("dimline-editor").getByRole("alert").textContent(), /cannot be shown.*dimline\.wasm/);
  broken = false;
  await page.locator("dimline-editor").getByRole("button", { name: "Try again" }).click();
  await ready(page);
  await settle(page);
  await assertPicture(page, "after-second-try");
  assert.ok((await page.locator("#panel .row").count()) >= 14);
  await close();
});

test("a module that cannot be loaded: the same", async () => {
  let broken = true;
  const { page, close } = await openPage(browser, {
    waitReady: false,
    prepare: (tab) => tab.route(/dimline\.js/, (route) => (broken ? route.abort() : route.continue())),
  });
  const reason = await page.evaluate(() =>
    document.querySelector("dimline-editor").ready.then(
      () => "ready",
      (error) => error.message,
    ),
  );
  assert.match(reason, /dimline\.js/);
  broken = false;
  await page.locator("dimline-editor").getByRole("button", { name: "Try again" }).click();
  await ready(page);
  await settle(page);
  await assertPicture(page, "after-second-try-of-module");
  await close();
});

test("an unknown model in the attribute: a message in the picture, and another model mends it", async () => {
  const { page, complaints, close } = await openPage(browser, { drawn: false });
  const message = await page.evaluate(async () => {
    const other = document.createElement("dimline-editor");
    other.id = "other";
    other.setAttribute("model", "igloo");
    other.style.cssText = "position: fixed; left: 0; top: 0; width: 400px; height: 300px";
    const failed = new Promise((resolve) =>
      other.addEventListener("error", (event) => resolve(event.message), { once: true }),
    );
    document.body.append(other);
    await other.ready.catch(() => {});
    return failed;
  });
  assert.match(message, /igloo.*house/s);
  assert.match(await page.locator("#other").getByRole("alert").textContent(), /igloo/);
  const lines = await page.evaluate(async () => {
    const other = document.querySelector("#other");
    other.model = "house";
    await other.settled();
    return other.layout().lines.length;
  });
  assert.ok(lines > 0);
  assert.equal(await page.locator("#other").getByRole("alert").isVisible(), false);
  assert.deepEqual(complaints, []);
  await close();
});

test("two elements on a page do not know each other; one that leaves frees what it held", async () => {
  const { page, complaints, close } = await openPage(browser, { drawn: false });
  const state = await page.evaluate(async () => {
    const first = document.querySelector("#editor");
    const second = document.createElement("dimline-editor");
    second.model = "house";
    second.style.cssText = "position: fixed; left: 0; top: 0; width: 500px; height: 400px";
    document.body.append(second);
    await second.ready;
    second.setParameters({ Width: 9 });
    await second.settled();
    const widthOf = (editor) => editor.getParameters().find((p) => p.name === "Width").value;
    const before = [widthOf(first), widthOf(second), second.layout().size];
    const gl = second.shadowRoot.querySelector("canvas").getContext("webgl2");
    const waiting = second.settled().then(
      () => "settled",
      (error) => error.message,
    );
    second.remove();
    await new Promise((resolve) => setTimeout(resolve, 50));
    let thrown = "";
    try {
      second.getParameters();
    } catch (error) {
      thrown = error.message;
    }
    const lost = gl.isContextLost();
    const why = await waiting;
    document.body.append(second);
    await second.ready;
    const again = widthOf(second);
    // Moving is not leaving.
    document.querySelector("main").append(second);
    second.setParameters({ Width: 11 });
    await second.settled();
    const moved = widthOf(second);
    second.remove();
    return {
      before,
      thrown,
      lost,
      why,
      again,
      moved,
      first: widthOf(first),
      default: first.getParameters().find((p) => p.name === "Width").default,
    };
  });
  assert.deepEqual(state.before, [state.default, 9, [500, 400]]);
  assert.match(state.thrown, /ready/);
  assert.equal(state.lost, true);
  assert.match(state.why, /left/);
  assert.equal(state.again, state.default);
  assert.equal(state.moved, 11);
  assert.equal(state.first, state.default);
  assert.deepEqual(
    complaints.filter((line) => !/CONTEXT_LOST|context lost/i.test(line)),
    [],
  );
  await close();
});

test("before it is ready, a call says what to wait for", async () => {
  const { page, close } = await openPage(browser, { drawn: false });
  const message = await page.evaluate(() => {
    const other = document.createElement("dimline-editor");
    try {
      other.layout();
      return "no error";
    } catch (error) {
      return error.message;
    }
  });
  assert.match(message, /ready/);
  await close();
});

test("a viewport of no size loses nothing", async () => {
  const { page, complaints, close } = await openPage(browser);
  const before = await layoutOf(page);
  for (const style of [
    "display: none",
    "width: 0",
    "height: 0",
    "width: 1px; height: 1px",
    "width: 0.4px; height: 300px",
  ]) {
    await page.evaluate((css) => {
      const editor = document.querySelector("#editor");
      editor.style.cssText = `inset: auto; ${css}`;
      editor.setParameters({ Width: 9 });
      editor.undo();
    }, style);
    await page.waitForTimeout(100);
    await settle(page);
  }
  await page.evaluate(() => document.querySelector("#editor").removeAttribute("style"));
  await page.waitForTimeout(100);
  await settle(page);
  const after = await layoutOf(page);
  assert.deepEqual(after.size, before.size);
  assert.deepEqual(after.lines.map((l) => l.parameter).sort(), before.lines.map((l) => l.parameter).sort());
  await assertPicture(page, "after-no-size");
  assert.deepEqual(complaints, []);
  await close();
});

test("a camera inside the house gives a picture and a layout", async () => {
  const { page, complaints, close } = await openPage(browser);
  await call(page, "setCamera", { eye: [0, 1.5, 0], target: [2, 1.5, 1], up: [0, 1, 0], fovDeg: 60 });
  await settle(page);
  const frame = await layoutOf(page);
  assert.ok(Array.isArray(frame.lines));
  assert.ok(JSON.stringify(frame).includes("null") === false || !/NaN/.test(JSON.stringify(frame)));
  for (const line of frame.lines) assert.ok(line.line.screen.flat().every(Number.isFinite), line.parameter);
  await call(page, "fitToView");
  await settle(page);
  await assertPicture(page, "out-of-the-house-again");
  assert.deepEqual(complaints, []);
  await close();
});

test("a view in which no size can be shown says so, once", async () => {
  const { page, close } = await openPage(browser, { drawn: false, path: "?model=facade" });
  await call(page, "setView", "top");
  await settle(page);
  const layout = await call(page, "layout");
  assert.equal(layout.lines.length + layout.others.length, 0);
  const said = page.locator("dimline-editor").locator(".readout[data-shown]");
  assert.equal(await said.textContent(), "From here no size can be shown. Turn the model.");
  await call(page, "setView", "three-quarter");
  await settle(page);
  assert.ok((await call(page, "layout")).lines.length > 0);
  await close();
});

test("people who asked for less motion get none: labels are there at once, and do not fade in", async () => {
  // In how many frames a label is to be seen through, until all has come to rest.
  const fadingFrames = async (reducedMotion) => {
    const { page, close } = await openPage(browser, { reducedMotion, drawn: false });
    const count = await page.evaluate(async () => {
      const editor = document.querySelector("#editor");
      let frames = 0;
      let rests = false;
      editor.setView("front");
      editor.settled().then(() => (rests = true));
      while (!rests) {
        await new Promise(requestAnimationFrame);
        if ([...editor.shadowRoot.querySelectorAll(".label")].some((label) => label.style.opacity !== "")) ++frames;
      }
      return frames;
    });
    await close();
    return count;
  };
  assert.equal(await fadingFrames("reduce"), 0);
  assert.ok((await fadingFrames("no-preference")) > 0, "others see them fade, or this test could see nothing");
});

test("a still page draws nothing", async () => {
  const { page, close } = await openPage(browser, { drawn: false });
  const asked = await page.evaluate(async () => {
    let count = 0;
    const original = window.requestAnimationFrame;
    window.requestAnimationFrame = (callback) => {
      ++count;
      return original.call(window, callback);
    };
    await new Promise((resolve) => setTimeout(resolve, 600));
    window.requestAnimationFrame = original;
    return count;
  });
  assert.equal(asked, 0);
  await close();
});
