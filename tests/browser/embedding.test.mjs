// The element in pages that are not its own: beside their fields and scripts, moved between documents, followed by other elements.
import assert from "node:assert/strict";
import { Buffer } from "node:buffer";
import { after, before, test } from "node:test";
import { tetrahedronGlb, tetrahedronGltf } from "../support/tetrahedron.mjs";
import { fingersOf, freeSpot, freeWay, gripOf } from "./support/handles.mjs";
import { call, cameraOf, launch, layoutOf, openPage, pageUrl, pictureBox, settle, valueOf } from "./support/page.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser?.close();
});

async function withPage(options, body) {
  const tab = await openPage(browser, { drawn: false, ...options });
  try {
    await settle(tab.page);
    await body(tab.page);
  } finally {
    await tab.close();
  }
}

/** Adds an element and waits until it is ready; `name` keeps it at the window. */
const addEditor = (page, name, attributes = { model: "house" }) =>
  page.evaluate(
    async ([key, given]) => {
      const editor = document.createElement("dimline-editor");
      for (const [attribute, value] of Object.entries(given)) editor.setAttribute(attribute, value);
      editor.style.cssText = "position: fixed; left: 0; top: 0; width: 500px; height: 400px";
      window[key] = editor;
      document.body.append(editor);
      await editor.ready;
    },
    [name, attributes],
  );

test("two editors that follow each other's cameras come to rest", () =>
  withPage({}, async (page) => {
    await addEditor(page, "second");
    const events = await page.evaluate(async () => {
      const first = document.querySelector("dimline-editor");
      let count = 0;
      const follow = (leader, follower) =>
        leader.addEventListener("camera-change", () => {
          ++count;
          follower.setCamera(leader.getCamera());
        });
      follow(first, window.second);
      follow(window.second, first);
      first.setView("front");
      await Promise.all([first.settled(), window.second.settled()]);
      return count;
    });
    assert.ok(events >= 2 && events < 10, `${events} events`);
    assert.deepEqual(await page.evaluate(() => window.second.getCamera()), await cameraOf(page));
  }));

test("an address of the core that is none: ready, settled and calls say so, and nothing is left waiting", () =>
  withPage({}, async (page) => {
    const said = await page.evaluate(async () => {
      const editor = document.createElement("dimline-editor");
      editor.coreUrl = "http://[";
      let event = null;
      editor.addEventListener("error", (error) => (event = error.message));
      document.body.append(editor);
      const messageOf = (promise) => promise.then(() => "resolved", (error) => error.message);
      const messages = [await messageOf(editor.ready), await messageOf(editor.settled()), event, editor.error?.message];
      try {
        editor.getParameters();
      } catch (error) {
        messages.push(error.message);
      }
      editor.remove();
      return messages;
    });
    assert.deepEqual(said, Array(5).fill('The attribute core-url is no address: "http://[".'));
  }));

/** Files of a page's own, each sent after so many milliseconds. */
async function serve(page, files) {
  for (const [name, { body, delayMs = 0 }] of Object.entries(files)) {
    await page.route(pageUrl(`files/${name}`), async (route) => {
      await new Promise((resolve) => setTimeout(resolve, delayMs));
      await route.fulfill({ body: Buffer.from(body) });
    });
  }
}

test("ready and settled wait for the model that was asked for last", () =>
  withPage({}, async (page) => {
    await serve(page, { "slow.glb": { body: tetrahedronGlb(), delayMs: 700 }, "third.glb": { body: tetrahedronGlb(), delayMs: 300 }, "slower.glb": { body: tetrahedronGlb(), delayMs: 900 } });
    const sizes = await page.evaluate(async () => {
      const editor = document.createElement("dimline-editor");
      editor.model = "files/slow.glb";
      document.body.append(editor);
      setTimeout(() => (editor.model = "files/slower.glb"), 300);
      await editor.ready;
      const whenReady = editor.getParameters().length;
      editor.model = "house";
      await editor.settled();
      const built = editor.getParameters().length;
      editor.model = "files/third.glb";
      await editor.settled();
      const loaded = editor.getParameters().length;
      editor.model = "no-such-model";
      await editor.settled();
      return { whenReady, built, loaded, kept: editor.getParameters().length };
    });
    assert.equal(sizes.whenReady, 3);
    assert.ok(sizes.built > 10);
    assert.equal(sizes.loaded, 3);
    assert.equal(sizes.kept, 3);
  }));

test("trying again goes on with the model that is shown, whatever the attribute asks for", () =>
  withPage({}, async (page) => {
    await addEditor(page, "editor");
    const result = await page.evaluate(async () => {
      const { editor } = window;
      editor.setParameters({ Width: 9 });
      editor.setAttribute("model", "nope");
      await new Promise((resolve) => editor.addEventListener("error", resolve, { once: true }));
      const canvas = editor.shadowRoot.querySelector("canvas");
      canvas.getContext("webgl2").getExtension("WEBGL_lose_context").loseContext();
      const message = editor.shadowRoot.querySelector(".message");
      while (message.hidden) await new Promise((resolve) => setTimeout(resolve, 100));
      message.querySelector("button").click();
      await editor.ready;
      return editor.getParameters().find(({ name }) => name === "Width").value;
    });
    assert.equal(result, 9);
  }));

test("a context that is lost before the core has come is waited for", () =>
  withPage({}, async (page) => {
    const lines = await page.evaluate(async () => {
      const editor = document.createElement("dimline-editor");
      editor.model = "house";
      document.body.append(editor);
      const canvas = editor.shadowRoot.querySelector("canvas");
      while (!canvas.hasAttribute("width")) await null;
      const loss = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
      loss.loseContext();
      await editor.ready;
      loss.restoreContext();
      await new Promise((resolve) => canvas.addEventListener("webglcontextrestored", resolve, { once: true }));
      await editor.settled();
      const lineCount = editor.layout().lines.length;
      editor.remove();
      return lineCount;
    });
    assert.ok(lines > 0);
  }));

test("the element moves into a frame's document with its style and its font, and works there", () =>
  withPage({}, async (page) => {
    await addEditor(page, "editor");
    const there = await page.evaluate(async () => {
      const frame = document.createElement("iframe");
      frame.style.cssText = "position: fixed; left: 0; top: 0; width: 500px; height: 450px";
      document.body.append(frame);
      const { editor } = window;
      frame.contentDocument.body.append(editor);
      await editor.ready;
      await editor.settled();
      const { height } = editor.getBoundingClientRect();
      await editor.settled();
      const fonts = [...frame.contentDocument.fonts].map(({ family, status }) => `${family.replaceAll('"', "")} ${status}`);
      return { height, later: editor.getBoundingClientRect().height, fonts, lines: editor.layout().lines.length };
    });
    assert.equal(there.height, 400);
    assert.equal(there.later, 400);
    assert.deepEqual(there.fonts, ["Dimline Label loaded"]);
    assert.ok(there.lines > 0);
  }));

test("numbers keep their order on a page that is written from right to left", () =>
  withPage({}, async (page) => {
    await page.evaluate(() => (document.documentElement.dir = "rtl"));
    const direction = await page.evaluate(
      () => getComputedStyle(document.querySelector("dimline-editor").shadowRoot.querySelector(".label")).direction,
    );
    assert.equal(direction, "ltr");
  }));

test("keys that go into a page's own field are left to it", () =>
  withPage({}, async (page) => {
    await page.evaluate(() => {
      const field = document.createElement("input");
      field.id = "own";
      field.style.position = "fixed"; // or the picture would have another size
      document.body.prepend(field);
      document.addEventListener("keydown", (event) => document.querySelector("dimline-editor").handleKey(event));
      field.focus();
    });
    const camera = await cameraOf(page);
    await page.keyboard.type("half 1357 fm");
    assert.equal(await page.inputValue("#own"), "half 1357 fm");
    assert.deepEqual(await cameraOf(page), camera);
  }));

test("a model that is not there is told to the element's listeners, and counts as no fault of the page", () =>
  withPage({}, async (page) => {
    const told = await page.evaluate(async () => {
      const editor = document.querySelector("dimline-editor");
      let atWindow = 0;
      window.addEventListener("error", () => ++atWindow);
      const event = new Promise((resolve) => editor.addEventListener("error", resolve, { once: true }));
      editor.model = "nope";
      return { message: (await event).message, atWindow };
    });
    assert.match(told.message, /no built-in model "nope"/);
    assert.equal(told.atWindow, 0);
  }));

test("who waits for an element whose first model is not there learns why, and can give it another", () =>
  withPage({}, async (page) => {
    const told = await page.evaluate(async () => {
      const editor = document.createElement("dimline-editor");
      editor.model = "hous";
      document.body.append(editor);
      const message = await editor.ready.then(() => "ready", (error) => error.message);
      editor.model = "house";
      await new Promise((resolve) => editor.addEventListener("load", resolve, { once: true }));
      const names = editor.getParameters().map(({ name }) => name);
      editor.remove();
      return { message, names };
    });
    assert.match(told.message, /no built-in model "hous"/);
    assert.ok(told.names.includes("Width"));
  }));

test("a wheel that goes sideways is the page's", () =>
  withPage({}, async (page) => {
    const { x, y, width, height } = await pictureBox(page);
    await page.mouse.move(x + width / 2, y + height / 2);
    const camera = await cameraOf(page);
    await page.mouse.wheel(200, 3);
    await settle(page);
    assert.deepEqual(await cameraOf(page), camera);
    await page.mouse.wheel(3, 200);
    await settle(page);
    assert.notDeepEqual(await cameraOf(page), camera);
  }));

test("a page may keep the wheel for itself, but for the one with Ctrl", () =>
  withPage({}, async (page) => {
    await page.evaluate(() => document.querySelector("dimline-editor").setAttribute("wheel", "ctrl"));
    const { x, y, width, height } = await pictureBox(page);
    await page.mouse.move(x + width / 2, y + height / 2);
    const camera = await cameraOf(page);
    const turned = page.evaluate(
      () => new Promise((resolve) => window.addEventListener("wheel", (event) => resolve(event.defaultPrevented), { once: true })),
    );
    await page.mouse.wheel(0, 200);
    assert.equal(await turned, false, "the page scrolls");
    await settle(page);
    assert.deepEqual(await cameraOf(page), camera);
    await page.keyboard.down("Control");
    await page.mouse.wheel(0, 200);
    await page.keyboard.up("Control");
    await settle(page);
    assert.notDeepEqual(await cameraOf(page), camera);
  }));

test("a page may let fingers scroll it, but for one that holds an arrow, and for two", () =>
  withPage({ touch: true, width: 400, height: 700 }, async (page) => {
    await page.evaluate(async () => {
      const editor = document.createElement("dimline-editor");
      editor.setAttribute("model", "house");
      editor.setAttribute("touch-action", "pan-y");
      editor.style.height = "600px";
      const below = document.createElement("div");
      below.style.height = "3000px";
      for (const { style } of [document.documentElement, document.body]) style.cssText = "display: block; height: auto; overflow: visible";
      document.body.replaceChildren(editor, below);
      await editor.ready;
    });
    const fingers = await fingersOf(page);
    const move = async (from, to) => {
      await settle(page);
      for (let count = 1; count <= from.length; ++count) await fingers.down(...from.slice(0, count));
      for (let i = 1; i <= 10; ++i) await fingers.move(...from.map(([x, y], k) => [x + ((to[k][0] - x) * i) / 10, y + ((to[k][1] - y) * i) / 10]));
      await fingers.up();
      await settle(page);
    };
    const scrolled = () => page.evaluate(() => window.scrollY);
    const camera = await cameraOf(page);
    const { line, outward, at } = await gripOf(page, "Floors");
    assert.ok(Math.abs(outward[1]) > 0.9, "the arrow points up or down");

    await move([at], [[at[0], at[1] - 40]]);
    assert.equal(await scrolled(), 0, "an arrow that is dragged upwards");
    assert.notEqual(await valueOf(page, "Floors"), line.value);
    assert.deepEqual(await cameraOf(page), camera);

    const first = await freeSpot(page, 1);
    const [dx, dy] = await freeWay(page, first, 100);
    const two = [first, [first[0] + dx, first[1] + dy]];
    await move(two, two.map(([x, y]) => [x, y - 200]));
    assert.equal(await scrolled(), 0, "two fingers");
    assert.notDeepEqual(await cameraOf(page), camera);

    const panned = await cameraOf(page);
    const aside = await freeSpot(page, 1);
    await move([aside], [[aside[0] + 150, aside[1] + 10]]);
    assert.equal(await scrolled(), 0, "a finger that moves sideways");
    assert.notDeepEqual(await cameraOf(page), panned);

    const turned = await cameraOf(page);
    const upwards = await freeSpot(page, 1);
    await move([upwards], [[upwards[0], upwards[1] - 250]]);
    assert.ok((await scrolled()) > 100, "a finger that moves upwards");
    assert.deepEqual(await cameraOf(page), turned);
  }));

test("a glTF file is shown without a picture that is missing, and not without a buffer", () =>
  withPage({}, async (page) => {
    const gltf = tetrahedronGltf();
    const document = JSON.parse(new TextDecoder().decode(gltf.bytes));
    document.images = [{ uri: "gone.png" }];
    const files = { "t.gltf": { body: JSON.stringify(document) } };
    for (const [name, body] of Object.entries(gltf.files)) files[name] = { body };
    await serve(page, files);
    const outcome = await page.evaluate(async () => {
      const editor = document.querySelector("dimline-editor");
      const next = () =>
        new Promise((resolve) => {
          editor.addEventListener("load", () => resolve("load"), { once: true });
          editor.addEventListener("error", (event) => resolve(event.message), { once: true });
        });
      editor.model = "files/t.gltf";
      return next();
    });
    assert.equal(outcome, "load");
    assert.equal((await call(page, "getParameters")).length, 3);
  }));

test("while a handle is dragged, keys that would move the picture do nothing", () =>
  withPage({}, async (page) => {
    const { x, y } = await pictureBox(page);
    const [handle] = (await layoutOf(page)).lines.find((line) => line.parameter === "Width").handles;
    await page.mouse.move(x + handle.screen[0], y + handle.screen[1]);
    await page.mouse.down();
    await page.mouse.move(x + handle.screen[0] + 30, y + handle.screen[1] + 20, { steps: 4 });
    await settle(page);
    const camera = await cameraOf(page);
    const value = await valueOf(page, "Width");
    for (const key of ["1", "7", "f", "5", "m"]) await page.keyboard.press(key);
    await settle(page);
    assert.deepEqual(await cameraOf(page), camera);
    assert.equal((await call(page, "layout")).measures, undefined);
    await page.mouse.move(x + handle.screen[0] + 60, y + handle.screen[1] + 40, { steps: 4 });
    await settle(page);
    assert.notEqual(await valueOf(page, "Width"), value);
    await page.mouse.up();
  }));
