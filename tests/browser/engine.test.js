// The engine inside the page: the program's own answers, from a file, without a server.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";

import { DATA, PLAYGROUND, boundfit, fitReport, launch, openLesson, withoutRow } from "./harness.js";

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

/** What the engine of a page answers, or the words of its error. */
const ask = (page, ...question) =>
  page.evaluate((words) => boundfit.engine.ask(...words).catch((error) => `Error: ${error.message}`), question);

const TABLE = "x;y\n1;1,1\n2;2,3\n3;2,9\n";
const ASKED = { x: "x", y: "y", eps: "0.5" };

test("a page from a file answers what the program answers", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  const [file, ...options] = DATA.transducer;
  const text = boundfit("fit", file, ...options, "--no-lp");
  const withoutDoubles = (report) => report.replace(/\nin doubles[^]*?(?=\n\S|\n*$)/, "");
  const own = await page.evaluate(() => JSON.parse(document.getElementById("lesson-data").textContent));
  assert.equal(own.asked.eps, "1/2000");
  const table = readFileSync(new URL(`../../${file}`, import.meta.url), "utf8");
  const asked = { file, x: "Vz", y: "z", rows: [[14, 36]], eps: "0.5e-3", format: "text" };
  assert.equal(withoutDoubles(await ask(page, "run", table, asked)), withoutDoubles(text));
  assert.deepEqual(complaints, []);
  await close();
});

test("questions are answered in their order, and refusals are in the words of the program", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.strip);
  const answers = await page.evaluate(async ([table, asked]) => {
    const { engine } = boundfit;
    const order = [];
    const said = (name, answer) => answer.then(() => order.push(name), (error) => order.push(`${name}: ${error.message}`));
    await Promise.all([
      said("lesson", engine.ask("lesson", table, asked)),
      said("wrong", engine.ask("run", table, { ...asked, x: "z" })),
      said("unknown", engine.ask("sing", table, asked)),
      said("run", engine.ask("run", new TextEncoder().encode(table), asked)),
    ]);
    return order;
  }, [TABLE, ASKED]);
  assert.equal(answers.length, 4);
  assert.equal(answers[0], "lesson");
  assert.match(answers[1], /^wrong: standard input: line 1: there is no column "z"/);
  assert.equal(answers[2], 'unknown: the engine has no answer about "sing"');
  assert.equal(answers[3], "run");
  assert.deepEqual(complaints, []);
  await close();
});

/** In the page, before its script: the Worker can be asked to run out of memory, and then for a table. */
function withTrap() {
  const Own = Blob;
  const trap = `
    answers.trap = () => {
      wasm.memory.grow(2 ** 16 - wasm.memory.buffer.byteLength / 2 ** 16);
      return lesson(new Uint8Array(2 ** 24).fill(49), "{}");
    };`;
  globalThis.Blob = class extends Own {
    constructor(parts, options) {
      super(parts.map((part) => (typeof part === "string" && part.includes("initSync(") ? part + trap : part)), options);
    }
  };
}

test("after a trap the engine is started anew, and what waits is answered", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.strip, { init: withTrap });
  const before = await ask(page, "lesson", TABLE, ASKED);
  assert.equal(JSON.parse(before).readings.length, 3);
  const [trapped, after] = await page.evaluate(([table, asked]) => {
    const { engine } = boundfit;
    return Promise.all([
      engine.ask("trap", "", {}).then(() => "no trap", (error) => error.message),
      engine.ask("lesson", table, asked),
    ]);
  }, [TABLE, ASKED]);
  assert.match(trapped, /stopped.*unreachable/);
  assert.equal(after, before);
  assert.deepEqual(complaints, []);
  await close();
});

test("a table that is typed into the page without readings is fitted", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  assert.equal(await page.locator("#parameter-plane").getAttribute("data-kind"), "plane");
  assert.ok(await page.locator("#start").isVisible());
  const [file, ...options] = DATA.norris;
  const table = readFileSync(new URL(`../../${file}`, import.meta.url), "utf8");
  if (!(await page.locator("#paste-text").isVisible())) await page.locator("#paste summary").click();
  await page.locator("#paste-text").fill(table);
  await page.locator("#paste-use").click();
  await page.waitForFunction(() => boundfit.store.lesson().readings.length > 0);
  const expected = fitReport([file, ...options.slice(0, 4), "--eps", "2*min"]);
  const shown = await page.evaluate(() => boundfit.store.lesson().data.fit.fps);
  assert.deepEqual(shown.vertices.map(({ theta }) => theta.map(({ exact }) => exact)), expected.fps.vertices.map(({ theta }) => theta.map(({ exact }) => exact)));
  assert.ok(!(await page.locator("#start").isVisible()));
  assert.deepEqual(complaints, []);
  await close();
});

/** The page as a program writes it that is built without the feature `engine`. */
const withoutEngine = (html) => {
  const elements = /<script type="application\/octet-stream;base64" id="engine-module">[^]*?<\/script>\n<script type="text\/plain" id="engine-worker">[^]*?<\/script>\n/;
  const policy = " 'wasm-unsafe-eval'; worker-src blob:";
  assert.ok(elements.test(html) && html.includes(policy));
  return html.replace(elements, "").replace(policy, "");
};

test("without the engine the page has everything but what asks it", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer, { edit: withoutEngine });
  assert.equal(await page.evaluate(() => boundfit.engine), null);
  for (const asking of ["#view-choice", "#editor"]) assert.equal(await page.locator(asking).isVisible(), false, asking);
  const vertices = () => page.locator("#parameter-plane [data-vertex]").evaluateAll((marks) => marks.map(({ dataset }) => [dataset.theta1, dataset.theta2].join()).sort());
  const exact = (report) => report.fps.vertices.map(({ theta }) => theta.map((value) => value.exact).join()).sort();
  const all = exact(fitReport(DATA.transducer));
  assert.deepEqual(await vertices(), all);
  await page.click("#tab-clip");
  assert.deepEqual(await vertices(), []);
  await page.click("#step-last");
  assert.deepEqual(await vertices(), all);
  await page.locator("#leave-out-34").uncheck();
  assert.deepEqual(await vertices(), exact(withoutRow(34)));
  for (const tab of ["epsilon", "worst-line", "explore"]) {
    await page.click(`#tab-${tab}`);
    assert.equal(await page.locator(`#tab-${tab}`).getAttribute("aria-selected"), "true");
  }
  assert.deepEqual(complaints, []);
  await close();
});
