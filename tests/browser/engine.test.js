// The engine inside the page: the program's own answers, from a file, without a server.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";

import { DATA, boundfit, launch, openLesson } from "./harness.js";

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
