// The page in English, Italian and German: every word comes from the table, and nothing else changes.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { DATA, SPECIAL, launch, openLesson } from "./harness.js";

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

const MODES = ["explore", "clip", "epsilon", "leave-one-out", "worst-line"];

/** The text that a reader meets in all modes, labels for screen readers among it. */
async function words(page) {
  const met = [];
  for (const mode of MODES) {
    const tab = page.locator(`#tab-${mode}`);
    if (await tab.isDisabled()) continue;
    await tab.click();
    if (mode === "clip") await page.locator("#step-slider").fill("2");
    met.push(await page.evaluate(() => {
      const labels = [...document.querySelectorAll("[aria-label]")].map((part) => part.getAttribute("aria-label"));
      return [document.querySelector("main").innerText, ...labels].join("\n");
    }));
  }
  await page.locator("#tab-explore").click();
  return met.join("\n");
}

// Words that are the same in no other language, and that no data set of the tests has.
const ENGLISH = /\b(the|is|are|reading|readings|bound|bounds|vertex|vertices|without|feasible|set)\b/i;

// A command is the same in every language.
const COMMAND = /boundfit (fit|lesson).*/;

for (const name of ["transducer", "steamGenerator", "strip", "norris", "contradiction", "twoRegressors"]) {
  test(`${name}: another language has no English left, and back again every word is as before`, async () => {
    const { page, complaints, close } = await openLesson(browser, DATA[name]);
    for (const summary of await page.locator("details summary").all()) await summary.evaluate((one) => { one.parentElement.open = true; });
    for (const box of await page.locator("#layer-list input:enabled").all()) await box.check();
    const exact = () => page.locator("[data-exact]").evaluateAll((parts) => parts.map(({ dataset }) => dataset.exact));
    const before = await words(page);
    const numbers = await exact();
    for (const code of ["it", "de"]) {
      await page.locator("#language").selectOption(code);
      assert.equal(await page.locator("html").getAttribute("lang"), code);
      const text = await words(page);
      const left = text.split("\n").filter((line) => ENGLISH.test(line.replace(COMMAND, "")));
      assert.deepEqual(left, [], code);
      assert.doesNotMatch(text, /\{|\}|undefined|\[object|\bnull\b/, code);
      assert.doesNotMatch(text, /[a-z]+\.[a-z]+-[a-z]+/, "a key in place of a text");
      // Versions of solvers have a point.
      const pointed = text.split("\n").filter((line) => /\d\.\d/.test(line.replace(COMMAND, "").replace(/(microlp|clarabel|highs)[ -][\d.]+/gi, "")));
      assert.deepEqual(pointed, [], `${code}: a decimal point`);
      assert.deepEqual(await exact(), numbers, "the numbers themselves stay");
    }
    await page.locator("#language").selectOption("en");
    assert.equal(await words(page), before);
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("the option chooses the first language, title and all", async () => {
  const { page, complaints, close } = await openLesson(browser, [...DATA.transducer, "--language", "de"]);
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  assert.equal(await page.title(), "transducer.csv: z gegen Vz");
  assert.equal(await page.locator("#language").inputValue(), "de");
  assert.match(await page.locator("#provenance").textContent(), /23 Messungen von 46 · Fehlerschranke ε = 0,0005/);
  await page.locator("#tab-clip").click();
  assert.match(await page.locator("#step-sentence").textContent(), /^Schritt 0: die ganze Ebene\./);
  assert.match(await page.locator("#status").textContent(), /^Schritt 0/);
  await page.locator("#language").selectOption("it");
  assert.match(await page.locator("#step-sentence").textContent(), /^Passo 0: l’intero piano\./);
  assert.equal(await page.locator("#title").textContent(), "transducer.csv: z in funzione di Vz");
  assert.deepEqual(complaints, []);
  await close();
});

test("the choice of the language outlives another mode, a step and a choice", async () => {
  const { page, complaints, close } = await openLesson(browser, SPECIAL.tooTight);
  await page.locator("#language").selectOption("it");
  await page.locator("#tab-leave-one-out").click();
  await page.locator("#leave-out-1").uncheck();
  assert.match(await page.locator("#switch-sentence").textContent(), /^La lettura 1 è disattivata\. L’insieme è ora un poligono/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("html").getAttribute("lang"), "it");
  assert.deepEqual(complaints, []);
  await close();
});
