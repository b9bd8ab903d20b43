// Opens the page in headless Chromium with software WebGL, and keeps what it complains of. The software is Mesa's, which draws a
// frame several times faster than the SwiftShader that comes with Chromium.
import assert from "node:assert/strict";
import { chromium } from "playwright-core";

const kChromiumArguments = [
  "--use-gl=angle",
  "--use-angle=gl-egl",
  "--ignore-gpu-blocklist",
  "--no-sandbox",
  "--disable-dev-shm-usage",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

// Starting the core and drawing the first frame takes a second or two on software GL, and far longer on a busy machine.
const kPatienceMs = 60_000;

export function pageUrl(path = "") {
  assert.ok(
    process.env.DIMLINE_URL,
    "DIMLINE_URL is not set: run the browser tests by python3 tools/test.py --only browser",
  );
  return new URL(path, process.env.DIMLINE_URL).href;
}

/** One browser for the tests of a file; `moreArguments` go to Chromium. */
export async function launch(moreArguments = []) {
  return chromium.launch({
    executablePath: process.env.DIMLINE_CHROMIUM || "/usr/bin/chromium",
    args: [...kChromiumArguments, ...moreArguments],
    // Where there is a graphics card as well, the picture is the same as where there is none.
    env: { ...process.env, LIBGL_ALWAYS_SOFTWARE: "1" },
  });
}

/** Runs `body` with a browser that is closed in any case. */
export async function withBrowser(body, moreArguments) {
  const browser = await launch(moreArguments);
  try {
    return await body(browser);
  } finally {
    await browser.close();
  }
}

/**
 * In a tab that nobody looks at: WebGL draws nothing, as if a graphics card were done at once. Everything else is as ever, but that it calls itself software, as
 * which it has nothing measured by what it draws: on a graphics card too the core would measure an empty picture otherwise.
 */
function drawNothing() {
  const { getParameter } = WebGL2RenderingContext.prototype;
  const names = [WebGL2RenderingContext.RENDERER, 0x9246 /* UNMASKED_RENDERER_WEBGL */];
  WebGL2RenderingContext.prototype.getParameter = function (name) {
    return names.includes(name) ? "software that draws nothing" : getParameter.call(this, name);
  };
  for (const name of ["drawArrays", "drawElements", "drawElementsInstanced", "clear", "blitFramebuffer", "generateMipmap"]) {
    WebGL2RenderingContext.prototype[name] = () => {};
  }
}

/**
 * A tab with the page in it.
 * @param {import("playwright-core").Browser} browser
 * @param {object} [options] width, height: of the window in CSS px; dpr: device pixels per CSS pixel; touch: as on a phone;
 *   path: what to open; prepare: called with the tab before it loads anything; reducedMotion; drawn: false leaves the picture blank, for tests that look at
 *   no pixel, because software takes most of their time for it; waitReady: false leaves it loading
 * @returns {Promise<{page: import("playwright-core").Page, complaints: string[], close: () => Promise<void>}>}
 *   complaints: console errors and warnings, uncaught exceptions and refused requests so far
 */
export async function openPage(browser, options = {}) {
  const {
    width = 1000,
    height = 700,
    dpr = 1,
    touch = false,
    path = "",
    prepare,
    reducedMotion = "no-preference",
    drawn = true,
    waitReady = true,
  } = options;
  const context = await browser.newContext({
    viewport: { width, height },
    deviceScaleFactor: dpr,
    hasTouch: touch,
    isMobile: touch,
    reducedMotion,
  });
  const page = await context.newPage();
  page.setDefaultTimeout(kPatienceMs);
  const complaints = [];
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning")
      complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => complaints.push(`uncaught: ${error.stack ?? error.message}`));
  page.on("requestfailed", (request) => complaints.push(`failed: ${request.url()} ${request.failure()?.errorText}`));
  if (!drawn) await page.addInitScript(drawNothing);
  await prepare?.(page);
  await page.goto(pageUrl(path));
  if (waitReady) {
    await ready(page);
    await settle(page);
  }
  return { page, complaints, close: () => context.close() };
}

/** Calls a method of the element, and gives back what it returns. */
export function call(page, method, ...args) {
  return page.evaluate(([name, list]) => document.querySelector("dimline-editor")[name](...list), [method, args]);
}

/** Awaits a promise of the element's, and fails when it takes longer than anything may. */
function awaited(page, name) {
  return page.evaluate(
    ([member, limitMs]) => {
      const editor = document.querySelector("dimline-editor");
      const promise = member === "ready" ? editor.ready : editor[member]();
      const late = new Promise((_, reject) => {
        setTimeout(() => reject(new Error(`${member} took longer than ${limitMs / 1000} s`)), limitMs);
      });
      return Promise.race([promise, late]);
    },
    [name, kPatienceMs],
  );
}
export const settle = (page) => awaited(page, "settled");

/** Until the first frame is drawn and, where there is one, the panel is built, which comes a moment later. */
export async function ready(page) {
  await awaited(page, "ready");
  if ((await page.locator("#panel").count()) > 0) await page.locator('#panel[data-state="ready"]').waitFor({ state: "attached" });
}

/** Shows another built-in model, and waits until it rests. */
export async function showModel(page, model) {
  await page.evaluate(
    (name) =>
      new Promise((resolve) => {
        const editor = document.querySelector("dimline-editor");
        if (editor.model === name) return resolve();
        editor.addEventListener("load", resolve, { once: true });
        editor.model = name;
      }),
    model,
  );
  await settle(page);
}

export const layoutOf = (page) => call(page, "layout");
export const cameraOf = (page) => call(page, "getCamera");

export async function valueOf(page, name) {
  const parameter = (await call(page, "getParameters")).find((p) => p.name === name);
  assert.ok(parameter, `there is no parameter ${name}`);
  return parameter.value;
}

/** Where the picture lies in the window: {x, y, width, height} in CSS pixels. */
export const pictureBox = (page) => page.locator("dimline-editor").boundingBox();

/** The line of a parameter in a layout, and the handle that can be dragged. */
export function lineOf(layout, parameter) {
  const line = layout.lines.find((candidate) => candidate.parameter === parameter);
  const hidden = layout.hidden.find((entry) => entry.parameter === parameter);
  assert.ok(line, `${parameter} has no line${hidden ? `: ${hidden.reason}` : ""}`);
  return line;
}

export const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Listens to the element from now on; the list grows in the page and is read by takeEvents. */
export function recordEvents(page) {
  return page.evaluate(() => {
    window.recordedEvents = [];
    const editor = document.querySelector("dimline-editor");
    for (const type of ["load", "error", "input", "change", "camera-change"]) {
      editor.addEventListener(type, (event) => event.target === editor && window.recordedEvents.push(type));
    }
  });
}
export const takeEvents = (page) => page.evaluate(() => window.recordedEvents.splice(0));

/** A screenshot as PNG bytes, kept among the artifacts under that name. */
export async function screenshot(page, name, options = {}) {
  const folder = process.env.DIMLINE_ARTIFACTS;
  return page.screenshot({ ...options, ...(folder ? { path: `${folder}/${name}.png` } : {}) });
}
