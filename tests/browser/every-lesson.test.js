// Every kind of data, every width, light and dark: no complaints, nothing cut off, nothing inaccessible.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";

import { DATA, LONG_NAME, SPECIAL, fitReport, launch, openLesson, pressIfEnabled } from "./harness.js";

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

for (const name of ["wholeLine", "touchingStrips", "equalReadings"]) {
  test(`${name}: half-planes are active along the sides of a set without vertices`, async () => {
    const { page, complaints, close } = await openLesson(browser, SPECIAL[name]);
    const active = fitReport(SPECIAL[name]).fps.boundaries.flatMap((side) => side.active);
    const shown = await page.locator("#active .name").allTextContents();
    const words = ({ row, bound }) => `${row} ${bound === "upper" ? "▾" : "▴"}`;
    assert.deepEqual(shown.map((text) => text.replace(/\s/g, " ").trim()).sort(), active.map(words).sort());
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

const LOOKS = [{ colorScheme: "light" }, { colorScheme: "dark" }, { colorScheme: "light", forcedColors: "active" }];
for (const look of LOOKS) {
  test(`no accessibility rule is broken, ${Object.values(look).join(", ")}, in any language`, async () => {
    const rules = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
    // The page forbids foreign scripts, the checker is one.
    const { page, close } = await openLesson(browser, DATA.transducer, { ...look, bypassCSP: true });
    await page.evaluate(rules);
    await page.locator("#teacher summary").first().click();
    for (const language of ["en", "it", "de"]) {
      await page.locator("#language").selectOption(language);
      for (const mode of MODES) {
        await page.locator(`#tab-${mode}`).click();
        const { violations } = await page.evaluate(() => window.axe.run());
        const broken = violations.map(({ id, nodes }) => `${language}, ${mode}: ${id}: ${nodes.map(({ target }) => target).join("; ")}`);
        assert.deepEqual(broken, []);
      }
    }
    await close();
  });
}

test("conditions have the decimal mark of the language in the conflict and in the questions", async () => {
  for (const conditions of [["theta1>=1.5", "theta1<=0.5"], ["theta1>=2.25"], ["theta1<=1.05"]]) {
    const options = [...SPECIAL.badCondition.slice(0, -2), ...conditions.flatMap((condition) => ["--where", condition])];
    const { page, complaints, close } = await openLesson(browser, options);
    await page.locator("#language").selectOption("de");
    for (const summary of await page.locator("details summary").all()) await summary.evaluate((one) => { one.parentElement.open = true; });
    const words = await page.evaluate(() => {
      for (const code of document.querySelectorAll("code, input, noscript")) code.remove();
      return document.querySelector("main").innerText;
    });
    assert.match(words, /theta1[<>]=\d,\d/);
    assert.doesNotMatch(words, /theta1[<>]=\d\.\d/, conditions.join());
    assert.deepEqual(complaints, []);
    await close();
  }
});

test("the live region says what changed, in the language of the page", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  const status = () => page.locator("#status").textContent();
  await page.locator("#tab-clip").click();
  assert.match(await status(), /^Step 0: the whole plane\./);
  await page.locator("#step-forward").click();
  assert.equal(await status(), await page.locator("#step-sentence").textContent());
  await page.locator("#language").selectOption("de");
  await page.locator("#step-forward").click();
  assert.match(await status(), /^Schritt 2: untere Schranke von Messung 14: /);
  await page.locator("#tab-epsilon").click();
  await page.locator("#epsilon-least").click();
  assert.match(await status(), /^ε = 0,00039444\. Hier entsteht die Menge/);
  await page.locator("#tab-leave-one-out").click();
  await page.locator("#leave-out").selectOption("34");
  assert.match(await status(), /^Messung 34 ist ausgeschaltet\. Die Menge ist jetzt ein Polygon mit/);
  await page.locator("#layer-pui-box").check();
  assert.equal(await status(), "1 Einblendung sichtbar.");
  assert.deepEqual(complaints, []);
  await close();
});

test("whoever asked for less motion gets no smooth scrolling and more time between steps", async () => {
  for (const [reducedMotion, behaviour, least, most] of [["reduce", "auto", 2000, 9000], ["no-preference", "smooth", 900, 2000]]) {
    const { page, close } = await openLesson(browser, DATA.transducer, { reducedMotion });
    assert.equal(await page.evaluate(() => getComputedStyle(document.documentElement).scrollBehavior), behaviour);
    const delay = await page.evaluate(() => {
      const own = window.setInterval;
      return new Promise((resolve) => {
        window.setInterval = (run, delay) => { resolve(delay); return own(run, delay); };
        document.getElementById("step-play").click();
      });
    });
    assert.ok(delay > least && delay < most, `${delay} ms`);
    await close();
  }
});

test("an error bound found from the readings says so", async () => {
  const { page, complaints, close } = await openLesson(browser, SPECIAL.fromLeast);
  assert.equal(
    await page.locator("#epsilon-here").textContent(),
    " = 0.9, 1.2 times the smallest bound under which any parameter fits, 0.75. It was found from these very readings, which cannot show that errors are no larger",
  );
  assert.deepEqual(complaints, []);
  await close();
});

test("long names and numbers fit onto a phone", async () => {
  const { page, complaints, close } = await openLesson(browser, SPECIAL.longNames, { width: 360 });
  for (const mode of MODES) {
    await page.locator(`#tab-${mode}`).click();
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 360, mode);
  }
  assert.match(await page.locator("#provenance").textContent(), /ε = 1e299/);
  for (const id of ["data-plane", "parameter-plane"]) {
    const picture = await page.locator(`#${id}`).boundingBox();
    for (const name of await page.locator(`#${id} .axis`).all()) {
      const box = await name.boundingBox();
      assert.ok(box.x >= picture.x - 1 && box.x + box.width <= picture.x + picture.width + 1, `#${id}: ${JSON.stringify(box)}`);
    }
  }
  assert.ok((await page.locator("#readings").textContent()).includes(LONG_NAME), "in full where there is room");
  assert.deepEqual(complaints, []);
  await close();
});

test("why the set is empty, and whether an error bound helps", async () => {
  const cases = [
    [DATA.contradiction, /no error bound, however large, helps/, /^Empty\. The conditions contradict each other/],
    [SPECIAL.badCondition, /a reading or a condition is\. Change ε/, /too small for these readings and the condition/],
    [SPECIAL.tooTight, /a reading is\. Change ε/, /too small for these readings\./],
  ];
  for (const [options, cause, story] of cases) {
    const { page, complaints, close } = await openLesson(browser, options);
    assert.match(await page.locator("#conflict-cause").textContent(), cause);
    for (const mode of ["explore", "epsilon"]) {
      await page.locator(`#tab-${mode}`).click();
      if (options === DATA.contradiction)
        assert.equal(await page.locator("#parameter-plane .condition .line").count(), 2, `both boundaries, ${mode}`);
    }
    await page.locator("#epsilon-slider").fill("0");
    assert.match(await page.locator("#epsilon-story").textContent(), story);
    assert.deepEqual(complaints, []);
    await close();
  }
});

test("readings that hardly differ do not look alike", async () => {
  const { page, complaints, close } = await openLesson(browser, SPECIAL.near);
  const last = ["000000000000", "000000000001", "000000000002", "000000000003"];
  const cells = await page.locator("#readings tbody tr").evaluateAll((rows) => rows.map((row) => row.querySelectorAll("td")[0].textContent));
  assert.deepEqual(cells, ["1000000", ...last.slice(1).map((digits) => `1000000.${digits}`)]);
  const spoken = await page.locator("#data-plane [data-reading]").evaluateAll((own) => own.map((each) => each.getAttribute("aria-label")));
  assert.equal(spoken[1], "Reading 2: x = 1000000.000000000001, y = 1000000.000000000015 ± 1e−11");
  await page.locator("#data-plane [data-reading='2']").press("Enter");
  assert.match(await page.locator("#inspector").innerText(), /θ₁·\(1000000\.000000000001\) \+ θ₂ ≤ 1000000\.000000000025/);
  assert.deepEqual(complaints, []);
  await close();
});

test("many active bounds are listed in short, and in full on demand", async () => {
  const { page, complaints, close } = await openLesson(browser, SPECIAL.duplicates);
  assert.ok((await page.locator("#active").textContent()).length < 150);
  await page.locator("#active-more summary").click();
  assert.equal(await page.locator("#active .name, #active-more .name").count(), 200);
  await page.locator('[data-vertex="0"]').press("Enter");
  assert.match(await page.locator("#inspector").textContent(), /and \d+ more/);
  assert.deepEqual(complaints, []);
  await close();
});

test("the text holds for readings without any error, too", async () => {
  const { page, complaints, close } = await openLesson(browser, SPECIAL.noError);
  assert.equal(await page.locator("#kind").getAttribute("data-kind"), "point");
  assert.match(await page.locator("#introduction").textContent(), /may be wrong by an error e/);
  assert.match(await page.locator("#readings-note").textContent(), /None of the readings matters alone/);
  assert.deepEqual(complaints, []);
  await close();
});

test("on paper: chosen layers only, the explanation but no answer that nobody opened, no hints for the mouse", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  await page.locator("#layer-pui-box").check();
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  const printed = (selector) => page.locator(selector).evaluateAll((parts) => parts.filter((part) => part.checkVisibility()).length);
  assert.equal(await printed("#layer-list li"), 1);
  assert.equal(await printed("#inspector p, #plane-keys, .tabs, .panel, .tools"), 0);
  assert.equal(await printed("#question-list details > p"), 0);
  assert.ok(await printed("#introduction math") >= 4);
  await page.locator("#question-list details").first().evaluate((box) => box.scrollIntoView());
  assert.deepEqual(complaints, []);
  await close();
});

test("the page refuses every request", async () => {
  const { page, close } = await openLesson(browser, DATA.transducer);
  const refused = await page.evaluate(() => fetch("https://example.org/").then(() => false, () => true));
  assert.ok(refused);
  await close();
});
