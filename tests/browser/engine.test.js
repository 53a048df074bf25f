// The engine inside the page: the program's own answers, from a file, without a server.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";

import { DATA, PLAYGROUND, boundfit, fitReport, launch, openLesson } from "./harness.js";

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
