// Makes the pictures of the lesson page that README.md and docs/lesson.md show: npm --prefix tests/browser run screenshots

import { mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { DATA, launch, openLesson } from "./harness.js";

const folder = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "docs", "pictures");
mkdirSync(folder, { recursive: true });

const UNITS = ["--x-unit", "V", "--y-unit", "m", "--title", "Position transducer"];

/** One picture of the two planes and what belongs to them, after some use of the page. */
async function picture(browser, name, context, use) {
  const { page, complaints, close } = await openLesson(browser, [...DATA.transducer, ...UNITS], context);
  await use(page);
  await page.mouse.move(0, 0);
  await page.locator("#planes").evaluate((section) => section.scrollIntoView());
  await page.screenshot({ path: join(folder, `${name}.png`) });
  await close();
  if (complaints.length > 0) throw new Error(complaints.join("\n"));
}

const browser = await launch();
await picture(browser, "lesson-vertex", { width: 1200, height: 960 }, async (page) => {
  await page.locator("#layer-pui-box").check();
  await page.locator("#layer-least-squares").check();
  await page.locator('[data-vertex="5"]').click();
});
await picture(browser, "lesson-clipping", { width: 1200, height: 960 }, async (page) => {
  await page.locator("#tab-clip").click();
  await page.locator("#clip-order").selectOption({ label: "worst first" });
  await page.locator("#step-slider").fill("5");
});
await picture(browser, "lesson-phone", { width: 390, height: 844, colorScheme: "dark" }, async (page) => {
  await page.locator("#tab-epsilon").click();
  await page.locator("#epsilon-next").click();
});
await browser.close();
