// The page of every fit in fixtures/tables, by geometry: no two labels cover each other, nothing leaves its frame, ticks stand
// where the readings are, and the first screen has the pictures.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";

import { DATA, launch, openLesson } from "./harness.js";

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

const lines = readFileSync(new URL("../../fixtures/tables/fits.txt", import.meta.url), "utf8").trimEnd().split("\n");
/** The fits: options of the program. Every fourth one on a phone as well. */
const FITS = lines.filter((line) => !line.startsWith("#")).map((line) => line.split(" ").slice(1))
  .map(([file, ...options]) => [`fixtures/${file}`, ...options, "--limit", "readings=400"]);

/** The boxes of some labels on the screen, with their texts. */
function boxes(page, selector) {
  return page.locator(selector).evaluateAll((labels) =>
    labels
      .filter((label) => label.textContent.trim() !== "" && label.checkVisibility())
      .map((label) => {
        // Of a text, the box of its letters.
        const range = document.createRange();
        range.selectNodeContents(label);
        const { left, top, right, bottom } = range.getBoundingClientRect();
        return { text: label.textContent.trim(), left, top, right, bottom };
      }),
  );
}

function overlapping(all) {
  // Letters of a line do not fill its height.
  const cover = (p, q) => p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 4 && q.top < p.bottom - 4;
  return all.flatMap((one, k) => all.slice(0, k).filter((other) => cover(one, other)).map((other) => [one, other]));
}

async function checkLabels(page, name) {
  for (const plane of ["#data-plane", "#parameter-plane"]) {
    const labels = await boxes(page, `${plane} text`);
    assert.deepEqual(overlapping(labels), [], `${name} ${plane}`);
    const frame = await page.locator(plane).boundingBox();
    for (const { text, left, right, top, bottom } of labels) {
      const inside = left >= frame.x - 1 && right <= frame.x + frame.width + 1 && top >= frame.y - 4 && bottom <= frame.y + frame.height + 4;
      assert.ok(inside, `${name} ${plane}: "${text}" leaves its frame`);
    }
  }
}

for (const [k, options] of FITS.entries()) {
  test(options.join(" "), async () => {
    for (const width of k % 4 === 0 ? [1280, 390] : [1280]) {
      const { page, complaints, close } = await openLesson(browser, options, { width, height: 800 });
      await checkLabels(page, `${width}`);
      if (options[options.indexOf("--x") + 1].includes(",")) {
        // Ticks of rows stand under the readings of these rows.
        const ticks = await page.locator("#data-plane text.tick[text-anchor=middle]").evaluateAll((marks) =>
          marks.map((mark) => [mark.textContent, Number(mark.getAttribute("x"))]));
        for (const [row, x] of ticks) {
          const reading = page.locator(`#data-plane [data-reading="${row}"] .hit`);
          assert.ok(Math.abs(Number(await reading.getAttribute("x")) + 9 - x) < 0.1, `tick ${row}`);
        }
      }
      if (width === 1280) {
        for (const plane of ["#data-plane", "#parameter-plane"]) {
          const { y, height } = await page.locator(plane).boundingBox();
          assert.ok(y + height <= 800, `${plane} ends at ${y + height}: not on the first screen`);
        }
      }
      if (await page.locator("#tab-epsilon").isEnabled()) {
        await page.locator("#tab-epsilon").click();
        assert.deepEqual(overlapping(await boxes(page, "#epsilon-ticks .stop")), [], "labels of the slider");
        for (const id of ["#epsilon-least", "#epsilon-given"]) {
          if (await page.locator(id).isDisabled()) continue;
          await page.locator(id).click();
          const value = await page.locator("#epsilon-value .decimal").textContent();
          const shown = await page.locator("#shown strong").textContent();
          if (!/as given\.$/.test(shown)) assert.ok(shown.includes(value), `${value} and "${shown}"`);
        }
        await checkLabels(page, "as given");
      }
      assert.deepEqual(complaints, []);
      await close();
    }
  });
}

test("the names at the ends of bars that meet a vertex do not cover each other", async () => {
  for (const width of [360, 1280]) {
    const { page, complaints, close } = await openLesson(browser, DATA.transducer, { width });
    for (const language of ["de", "it", "en"]) {
      await page.locator("#language").selectOption(language);
      for (const index of [0, 1, 2, 3, 4, 5]) {
        await page.evaluate((own) => boundfit.store.change({ selection: { kind: "vertex", index: own } }), index);
        const ends = await boxes(page, ".end-label");
        const where = `${width} px, ${language}, vertex ${index + 1}`;
        assert.equal(ends.length, 2, where);
        assert.deepEqual(overlapping(ends), [], where);
      }
    }
    assert.deepEqual(complaints, []);
    await close();
  }
});

test("on low screens the buttons leave the pictures their room", async () => {
  for (const [width, height, position] of [[640, 360, "static"], [640, 450, "static"], [390, 844, "sticky"], [360, 560, "sticky"]]) {
    const { page, close } = await openLesson(browser, DATA.transducer, { width, height });
    for (const panel of ["#panel-clip", "#plane-panel"])
      assert.equal(await page.locator(panel).evaluate((part) => getComputedStyle(part).position), position, `${panel} at ${width} × ${height}`);
    await close();
  }
});
