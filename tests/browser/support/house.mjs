// A tab with the house in it, for all tests of a file, and as it was before each of them.
import { after, before, beforeEach } from "node:test";
import { call, cameraOf, launch, openPage, recordEvents, settle, takeEvents } from "./page.mjs";

/**
 * @param {object} options of openPage()
 * @param {(desk: {browser, tab, page, defaults: Record<string, unknown>, camera: object}) => void} take called once, before the file's own hooks
 */
export function openHouse(options, take) {
  let browser, page, defaults, camera;
  before(async () => {
    browser = await launch();
    const tab = await openPage(browser, options);
    page = tab.page;
    await recordEvents(page);
    defaults = Object.fromEntries((await call(page, "getParameters")).map((p) => [p.name, p.value]));
    camera = await cameraOf(page);
    take({ browser, tab, page, defaults, camera });
  });
  after(async () => {
    await browser?.close();
  });
  beforeEach(async () => {
    await page.mouse.move(2, 2);
    await call(page, "setParameters", defaults);
    await call(page, "setCamera", camera);
    await settle(page);
    await takeEvents(page);
  });
}
