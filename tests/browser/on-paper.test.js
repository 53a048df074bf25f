// The page on paper and without scripts, and the notes for whoever teaches.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { DATA, SPECIAL, fitReport, launch, openLesson } from "./harness.js";

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

const shown = (page, selector) =>
  page.locator(selector).evaluateAll((parts) => parts.filter((part) => part.checkVisibility()).length);

for (const [name, options] of Object.entries(DATA)) {
  test(`${name}: without scripts there are both pictures, the tables and the questions`, async () => {
    const { page, complaints, close } = await openLesson(browser, options, { javaScriptEnabled: false });
    const report = fitReport(options);
    const { vertices } = report.fps;
    const pictures = page.locator("noscript svg");
    assert.equal(await pictures.count(), 2);
    for (const picture of await pictures.all()) {
      assert.ok((await picture.boundingBox()).width > 300);
      const letters = await picture.locator("text").evaluateAll((texts) =>
        texts.filter((text) => text.textContent.trim() !== "").map((text) => text.getBoundingClientRect()).map(({ width, height }) => Math.min(width, height)));
      assert.ok(Math.max(...letters) > 9, `letters of ${Math.max(...letters)} pixels`);
      assert.notEqual(await picture.getAttribute("aria-label"), "");
    }
    const tables = await page.locator("noscript table").count();
    assert.equal(tables, 1 + Number(report.fps.kind !== "empty") + Number(vertices.length > 0));
    assert.ok(await page.locator("noscript li summary").count() >= 6);
    assert.equal(await shown(page, "noscript li p"), 0, "answers are closed");
    await page.locator("noscript li summary").first().click();
    assert.equal(await shown(page, "noscript li p"), 1, "and open without a script");
    // Nothing that needs a script is there, and no sentence has a gap.
    assert.equal(await shown(page, "#planes, #readings, #language, #theme-toggle, #teacher"), 0);
    assert.equal(await shown(page, "[data-model]:not([data-off])"), await shown(page, "[data-model]"));
    const text = await page.locator("body").innerText();
    assert.doesNotMatch(text, / ,|\(, |\{|\}|NaN|undefined/);
    for (const picture of await pictures.all()) assert.doesNotMatch(await picture.innerHTML(), /NaN|[ "]-?inf\b/);
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("without scripts the page has the numbers and the words of the one with scripts", async () => {
  for (const language of ["en", "it", "de"]) {
    const options = [...DATA.transducer, "--language", language, "--x-unit", "V", "--y-unit", "m"];
    const still = await openLesson(browser, options, { javaScriptEnabled: false });
    const lively = await openLesson(browser, options);
    const texts = (page, selector) => page.locator(selector).allTextContents();
    assert.deepEqual(await texts(still.page, "noscript li summary"), await texts(lively.page, "#question-list summary"), language);
    assert.deepEqual(await texts(still.page, "noscript li p"), await texts(lively.page, "#question-list p"), language);
    for (const selector of ["#introduction", "footer"])
      assert.deepEqual(await texts(still.page, selector), await texts(lively.page, selector), `${language}: ${selector}`);
    const [data, set] = await texts(still.page, "noscript svg");
    for (const name of ["Vz [V]", "z [m]"]) assert.ok(data.includes(name), `${language}: ${name}`);
    for (const name of ["θ₁", "θ₂"]) assert.ok(set.includes(name), `${language}: ${name}`);
    await still.close();
    await lively.close();
  }
});

/** The page as it is on paper, with what a reader has opened before. */
async function printed(page) {
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
}

test("a printed page is a handout: no answers, no controls, whole pictures and tables", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer, { width: 794 });
  await page.locator("#question-list summary").first().click();
  assert.equal(await shown(page, "#question-list p"), 1);
  await printed(page);
  assert.equal(await shown(page, "#question-list p, .show-me"), 0, "an answer that was opened stays at home");
  assert.equal(await shown(page, "button:not(.plain), select, input, .panel, #teacher"), 0);
  assert.equal(await shown(page, "#readings tbody tr"), 23);
  assert.equal(await shown(page, "#readings-note, #active"), 0, "which readings matter is asked for");
  assert.deepEqual(await page.locator("#readings thead th").evaluateAll((heads) => heads.filter((head) => head.getClientRects().length > 0).map((head) => head.textContent)), ["row", "Vz", "z", "ε"]);
  for (const selector of ["#data-plane", "#parameter-plane", "#readings"]) {
    for (const part of await page.locator(selector).all()) {
      const box = await part.boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= 794, `${selector}: ${JSON.stringify(box)}`);
    }
  }
  const cut = await page.locator(".tall").first().evaluate((box) => box.scrollHeight > box.clientHeight + 1);
  assert.ok(!cut, "the table goes on");
  assert.equal((await page.pdf({ format: "A4" })).subarray(0, 5).toString(), "%PDF-");
  assert.deepEqual(complaints, []);
  await close();
});

test("the teacher's notes are closed, speak of these data, and are printed when they are open", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  assert.equal(await shown(page, "#teacher h3"), 0);
  await page.locator("#teacher summary").first().click();
  const notes = await page.locator("#teacher").innerText();
  for (const words of ["give, and what do they leave? Expected: 46; the set is a polygon with 6 vertices.", "all but 14, 21, 23, 24, 34 and 36", "ε = 0.00039444"])
    assert.ok(notes.includes(words), words);
  assert.equal(await page.locator("#teacher-answers dt").count(), await page.locator("#question-list li").count());
  await page.locator("#language").selectOption("de");
  assert.match(await page.locator("#teacher").innerText(), /Erwartet: 46; die Menge ist ein Polygon mit 6 Ecken\.[^]*ε = 0,00039444/);
  await printed(page);
  assert.ok(await shown(page, "#teacher h3") >= 7);
  assert.equal(await shown(page, "#teacher dd"), await page.locator("#teacher dd").count());
  assert.deepEqual(complaints, []);
  await close();
});

test("the teacher's notes are true of sets without area, equal readings and bounds that cannot shrink", async () => {
  for (const [name, ...expected] of [
    ["duplicates", "do 100 readings give, and what do they leave? Expected: 200;", "saved? Expected: each one alone, yet not all of these together.", "Expected: the set shrinks, but even ε = 0 leaves something."],
    ["tooTight", "saved? Expected: all but 1, 2 and 3: the set is empty without the others, too.", "Expected: the set is empty already, and stays empty."],
    ["least", "Expected: the set is gone at once."],
    ["noError", "saved? Expected: each one alone, yet not all of these together.", "Expected: nothing, since no error bound here can become smaller."],
    ["oneReading", "does 1 reading give, and what does it leave with the condition? Expected: 2;", "saved? Expected: all but 1."],
  ]) {
    const { page, complaints, close } = await openLesson(browser, SPECIAL[name]);
    await page.locator("#teacher summary").first().click();
    const notes = await page.locator("#teacher").innerText();
    for (const words of expected) assert.ok(notes.includes(words), `${name}: ${words} in ${notes}`);
    assert.deepEqual(complaints, []);
    await close();
  }
});
