// Every kind of data, every width, light and dark: no complaints, nothing cut off, nothing inaccessible.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";

import { DATA, fitReport, launch, openLesson, pressIfEnabled } from "./harness.js";

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

const MODES = ["explore", "clip", "epsilon", "leave-one-out"];

for (const [name, options] of Object.entries(DATA)) {
  test(`${name}: the set is that of the report, and every part can be used`, async () => {
    const { page, complaints, close } = await openLesson(browser, options);
    const { fps } = fitReport(options);
    assert.equal(await page.locator("#parameter-plane").getAttribute("data-kind"), fps.kind);
    const shown = await page.locator("#parameter-plane [data-vertex]").evaluateAll((marks) =>
      marks.map(({ dataset }) => [dataset.theta1, dataset.theta2].join()));
    assert.deepEqual(shown.sort(), fps.vertices.map(({ theta }) => theta.map(({ exact }) => exact).join()).sort());
    for (const mode of MODES) {
      const tab = page.locator(`#tab-${mode}`);
      if (await tab.isDisabled()) continue;
      await tab.click();
      assert.equal(await page.locator("body").getAttribute("data-mode"), mode);
    }
    await page.locator("#tab-clip").click();
    for (let index = 0; index < 3; index += 1) {
      await page.locator("#clip-order").selectOption({ index });
      await pressIfEnabled(page, "#step-first");
      while (await page.locator("#step-forward").isEnabled()) await page.locator("#step-forward").click();
      assert.equal(await page.locator("#parameter-plane").getAttribute("data-kind"), fps.kind);
    }
    if (await page.locator("#tab-epsilon").isEnabled()) {
      await page.locator("#tab-epsilon").click();
      const last = Number(await page.locator("#epsilon-slider").getAttribute("max"));
      for (let stop = 0; stop <= last; stop += 7) await page.locator("#epsilon-slider").fill(`${stop}`);
    }
    await page.locator("#tab-explore").click();
    for (const box of await page.locator("#layer-list input:enabled").all()) await box.check();
    for (const box of await page.locator("#readings input").all()) {
      await box.uncheck();
      await box.check();
    }
    for (const summary of await page.locator("details summary").all()) await summary.click();
    assert.deepEqual(complaints, []);
    await close();
  });
}

for (const width of [360, 768, 1600]) {
  for (const colorScheme of ["light", "dark"]) {
    test(`${width} px wide, ${colorScheme}: nothing is cut off`, async () => {
      const { page, complaints, close } = await openLesson(browser, DATA.transducer, { width, colorScheme });
      for (const mode of MODES) {
        await page.locator(`#tab-${mode}`).click();
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `${mode}: ${wide} px`);
        for (const id of ["data-plane", "parameter-plane"]) {
          const box = await page.locator(`#${id}`).boundingBox();
          assert.ok(box.width >= 250 && box.x >= 0 && box.x + box.width <= width, `${mode}: #${id} ${JSON.stringify(box)}`);
        }
      }
      const side = await page.evaluate(() => ["data-plane", "parameter-plane"].map((id) => document.getElementById(id).getBoundingClientRect().top));
      assert.equal(side[0] === side[1], width >= 1000, "side by side only where there is room");
      assert.deepEqual(complaints, []);
      await close();
    });
  }
}

for (const colorScheme of ["light", "dark"]) {
  test(`no accessibility rule is broken, ${colorScheme}`, async () => {
    const rules = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
    // The page forbids foreign scripts, the checker is one.
    const { page, close } = await openLesson(browser, DATA.transducer, { colorScheme, bypassCSP: true });
    await page.evaluate(rules);
    for (const mode of MODES) {
      await page.locator(`#tab-${mode}`).click();
      const { violations } = await page.evaluate(() => window.axe.run());
      const broken = violations.map(({ id, nodes }) => `${mode}: ${id}: ${nodes.map(({ target }) => target).join("; ")}`);
      assert.deepEqual(broken, []);
    }
    await close();
  });
}

test("the page refuses every request", async () => {
  const { page, close } = await openLesson(browser, DATA.transducer);
  const refused = await page.evaluate(() => fetch("https://example.org/").then(() => false, () => true));
  assert.ok(refused);
  await close();
});
