// The formulas of the introduction, for an x that is counted from an origin and for bounds about middles of their own.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { launch, openLesson } from "./harness.js";

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

function table(name, ...lines) {
  const file = join(tmpdir(), `boundfit-${name}-${process.pid}.csv`);
  writeFileSync(file, `${lines.join("\n")}\n`);
  return file;
}

/** The formulas that are shown, as one line each. */
const formulas = (page) =>
  page.locator("#introduction math, section math").evaluateAll((all) =>
    all.filter((own) => own.getClientRects().length > 0).map((own) => {
      const words = (node) => {
        if (node.nodeType === Node.TEXT_NODE) return node.textContent.trim();
        if (node.getClientRects().length === 0) return "";
        const parts = [...node.childNodes].map(words);
        return node.localName === "msub" ? parts.filter((part) => part !== "").join("_") : parts.join("");
      };
      return words(own);
    }));

test("x counted from an origin is a difference in parentheses", async () => {
  const file = table("origin", "year,y", "1980,1", "1981,2.1", "1982,2.9", "1985,6");
  const { page, complaints, close } = await openLesson(browser, [file, "--x", "year", "--y", "y", "--eps", "0.3", "--x-origin", "1980"]);
  const [model] = await formulas(page);
  assert.equal(model, "y_i=θ_1·(year_i−1980)+θ_2+e_i,|e_i|≤ε_i");
  assert.match(await page.locator('[data-text="introduction.agrees"]').textContent(), /Write φi for \(yeari − 1980, 1\)/);
  assert.equal(await page.locator("#title").textContent(), `${file.split("/").pop()}: y against year − 1980`);
  assert.match(await page.locator("#data-plane text", { hasText: "1980" }).textContent(), /^year − 1980\s*$/);
  assert.equal(await page.locator("#readings th").nth(1).textContent(), "year − 1980");
  assert.deepEqual(complaints, []);
  await close();
});

test("bounds that differ above and below are said about their middles", async () => {
  const file = table("asymmetric", "x,y", "1,1.1", "2,1.9", "3,3.2");
  const { page, complaints, close } = await openLesson(browser, [file, "--x", "x", "--y", "y", "--eps", "+0.2/-0.1"]);
  const cells = (row) => page.locator("#readings tr").nth(row).locator("th, td").allTextContents();
  assert.deepEqual((await cells(0)).slice(1, 5), ["x", "y", "m", "ε"]);
  assert.deepEqual((await cells(1)).slice(1, 5), ["1", "1.1", "1.15", "0.15"]);
  const [model, agrees, strips] = await formulas(page);
  assert.equal(model, "y_i=θ_1·x_i+θ_2+e_i");
  assert.equal(agrees, "|m_i−φ_i·θ|≤ε_i");
  assert.equal(strips, "φ_i·θ≤m_i+ε_iandφ_i·θ≥m_i−ε_i");
  assert.match(await page.locator("#epsilon-here").textContent(), /half the distance between the two bounds/);
  assert.doesNotMatch(await page.locator("#data-legend").innerText(), /± ε/);
  assert.deepEqual(complaints, []);
  await close();
});

test("bounds of each reading about y keep y in the formulas", async () => {
  const file = table("symmetric", "x,y,e", "1,1.1,0.1", "2,1.9,0.2", "3,3.2,0.3");
  const { page, complaints, close } = await openLesson(browser, [file, "--x", "x", "--y", "y", "--eps-column", "e"]);
  const [model, agrees] = await formulas(page);
  assert.equal(model, "y_i=θ_1·x_i+θ_2+e_i,|e_i|≤ε_i");
  assert.equal(agrees, "|y_i−φ_i·θ|≤ε_i");
  assert.deepEqual(complaints, []);
  await close();
});
