// The fragment of the page's link: a request as every surface takes it. What it says is read here without the page's script.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { inflateRawSync } from "node:zlib";

import { run, start } from "../../crates/lesson/engine/boundfit.mjs";
import { DATA, boundfit, boundfitOf, launch, openLesson } from "./harness.js";

let browser;

before(async () => {
  const engine = new URL("../../crates/lesson/engine/boundfit_wasm.wasm.gz", import.meta.url);
  await start(readFileSync(fileURLToPath(engine)));
  browser = await launch();
});
after(() => browser?.close());

const settled = (page) => page.locator('#editor[data-busy="false"]').waitFor();

/** A fragment as docs/lesson.md has it: request, table, and the page's own words. */
function parsed(fragment) {
  const [request, page] = [{}, {}];
  let table;
  for (const [key, text] of new URLSearchParams(fragment)) {
    if (key === "table") table = text.includes("\n") ? text : inflateRawSync(Buffer.from(text, "base64url")).toString();
    else if (key.startsWith("page.")) page[key.slice(5)] = text;
    else request[key] = /^([[{"]|true$|false$)/.test(text) ? JSON.parse(text) : text;
  }
  return { request, table, page };
}

/** JSON without what doubles make of least squares, which is the platform's. */
const withoutDoubles = (json) => json.replace(/\n {4}"binary64": (\{\}|\{\n[^]*?\n {4}\})/, "");

/** What the program writes by the command that the page shows, for the readings on standard input. */
const programOf = (command, table) => {
  const words = [...command.matchAll(/'([^']*)'|(\S+)/g)].map(([, quoted, plain]) => quoted ?? plain);
  return boundfitOf(table, "fit", "-", ...words.slice(3), "--format", "json");
};

/** Leaves out the first reading that is fitted, and waits for the link. */
async function linkOfChanged(page) {
  const before = await page.locator("#link").inputValue();
  await page.locator("#edit-toggle").click();
  await page.locator("[data-fitted]:checked").first().uncheck();
  await settled(page);
  await page.waitForFunction((own) => ![own, ""].includes(document.querySelector("#link").value), before);
  return new URL(await page.locator("#link").inputValue());
}

const list = JSON.parse(readFileSync(new URL("../questions.json", import.meta.url), "utf8"));
// The program of these tests is built without the readers of Parquet and Arrow.
const shown = list.about.filter((line) => !line.startsWith("arrow/"));

for (const line of shown) {
  test(`the link of ${line} is the request, and all surfaces answer it with the same bytes`, async () => {
    const [file, ...options] = line.split(" ");
    const { page, complaints, close } = await openLesson(browser, [`fixtures/${file}`, ...options]);
    const { hash } = await linkOfChanged(page);
    const { request, table } = parsed(hash.slice(1));
    assert.deepEqual(request, await page.evaluate(() => boundfit.editor.request()));
    assert.equal(table, await page.evaluate(() => boundfit.editor.csv()));
    const answer = run(table, request);
    assert.equal(await page.evaluate((own) => boundfit.engine.ask("run", ...own), [table, request]), answer);
    assert.equal(withoutDoubles(answer), withoutDoubles(programOf(await page.evaluate(() => boundfit.editor.command()), table)));
    // The page shows what it says.
    const { fps } = JSON.parse(answer);
    assert.equal(await page.locator("#parameter-plane").getAttribute("data-kind"), fps.kind);
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("a link that is typed by hand is followed, about the page's own readings or others", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  const follow = async (hash) => {
    await page.evaluate((own) => { location.hash = own; }, hash);
    await page.evaluate(() => boundfit.editor.settled());
    return page.evaluate(() => [document.querySelector("#edit-notice").textContent, boundfit.editor.request(), boundfit.editor.csv()]);
  };
  const [, { eps: first }, readings] = await follow("#");
  assert.equal(first, "1/2000");
  const [notice, request, same] = await follow('#ask=fit&x=Vz&y=z&eps=0.7e-3&where=["theta1 <= 1"]&without=1..3&page.tab=clip');
  assert.deepEqual([notice, same], ["", readings]);
  const dialect = { header: "yes", delimiter: "comma", decimal: "point", comment: "none" };
  assert.deepEqual(request, { ask: "fit", x: "Vz", y: "z", eps: "0.7e-3", where: ["theta1 <= 1"], without: [[1, 3]], ...dialect });
  assert.equal(await page.locator("body").getAttribute("data-mode"), "clip");
  // Texts that look like JSON, and a table with readable cells.
  const odd = `ask=fit&x="true"&y=[V]&eps={"exact":"1/3"}&reading=binary64&through_origin=true&table=${encodeURIComponent("true,[V]\n1,2\n2,3.9\n")}`;
  const [none, own, csv] = await follow(`#${odd}&page.title=Spring`);
  assert.deepEqual([none, csv], ["", "true,[V]\n1,2\n2,3.9\n"]);
  assert.deepEqual(own, { ask: "fit", x: "true", y: "[V]", eps: { exact: "1/3" }, through_origin: true, reading: "binary64", ...dialect });
  assert.match(await page.locator("h1").textContent(), /Spring/);
  // The program's options have no number that is exact beside doubles.
  assert.equal(await page.evaluate(() => boundfit.editor.command()), null);
  assert.equal(run(csv, own), await page.evaluate((words) => boundfit.engine.ask("run", ...words), [csv, own]));
  await page.waitForFunction(() => document.querySelector("#link").value.includes("&x=%22true%22&y=%22[V]%22&"));
  const link = parsed(new URL(await page.locator("#link").inputValue()).hash.slice(1));
  assert.deepEqual([link.request, link.table, link.page.title], [own, csv, "Spring"]);
  const below = `ask=fit&x=a&y=b&eps=1&skip_lines=1&table=${encodeURIComponent("note\na,b\n1,2\n2,3.9\n")}`;
  assert.deepEqual((await follow(`#${below}`)).filter((_, place) => place !== 1), ["", "a,b\n1,2\n2,3.9\n"]);
  const limited = 'ask=fit&x=Vz&y=z&eps=1&limits={"digits":20000}';
  const [, , cells] = await follow(`#${limited}`);
  const command = await page.evaluate(() => boundfit.editor.command());
  assert.match(command, / --limit digits=20000$/);
  const asked = await page.evaluate(() => boundfit.editor.request());
  assert.equal(withoutDoubles(run(cells, asked)), withoutDoubles(programOf(command, cells)));
  assert.deepEqual(complaints, []);
  await close();
});

test("a link with a wrong key or value says what is wrong, in the language of the page, and changes nothing", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  const before = await page.evaluate(() => boundfit.editor.request());
  const FRAMES = {
    en: /^The address of this page is refused: (.*)\. The page keeps what it shows\.$/,
    it: /^L’indirizzo di questa pagina è rifiutato: (.*)\. La pagina mantiene ciò che mostra\.$/,
    de: /^Die Adresse dieser Seite wird abgelehnt: (.*)\. Die Seite behält, was sie zeigt\.$/,
  };
  for (const [words, problem] of [
    ["epsilon=1", /^epsilon: there is no such key \(expected one of .*\beps_column\b/],
    ["ask=range", /^ask is about a report, and this is a lesson$/],
    ["ask=fit&x=Vz&y=z&eps=1&x_eps=1", /^x_eps is about a report, and this is a lesson$/],
    ["ask=fit&x=Vz&y=z&eps=1&eps_column=z", /^the errors have one bound: eps, or eps_column/],
    ["ask=fit&x=Vz&y=z", /^the bound on the errors is missing/],
    ["ask=fit&x=Vz&y=z&eps=1&strong=yes", /^strong: .*"yes".* expected /],
  ]) {
    for (const [language, frame] of Object.entries(FRAMES)) {
      await page.locator("#language").selectOption(language);
      await page.evaluate((own) => { location.hash = own; }, `#${words}&page.order=${language.length}${language}`);
      await page.evaluate(() => boundfit.editor.settled());
      assert.match((await page.locator("#edit-notice").textContent()).match(frame)[1], problem, `${language} ${words}`);
    }
  }
  assert.deepEqual(await page.evaluate(() => boundfit.editor.request()), before);
  assert.deepEqual(complaints, []);
  await close();
});

/** Changes the first y. */
async function change(page) {
  await page.locator("#edit-toggle").click();
  await page.locator('[data-cell="0 1"]').fill("1.25");
  await page.locator('[data-cell="0 1"]').press("Tab");
  await settled(page);
}

test("a damaged link keeps the readings that are shown, and says so", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.strip);
  await change(page);
  const before = await page.evaluate(() => boundfit.editor.csv());
  await page.evaluate(() => { location.hash = "ask=fit&x=x&y=y&eps=1&table=AAAA"; });
  const notice = page.locator("#edit-notice:not([hidden])");
  await notice.waitFor();
  assert.match(await notice.textContent(), /it was cut or changed\. The page keeps what it shows\.$/);
  for (const [language, words] of [["de", /abgeschnitten oder verändert\. Die Seite behält, was sie zeigt\.$/], ["it", /tagliato o modificato\. La pagina mantiene ciò che mostra\.$/]]) {
    await page.locator("#language").selectOption(language);
    assert.match(await notice.textContent(), words);
  }
  assert.equal(await page.evaluate(() => boundfit.editor.csv()), before);
  assert.deepEqual(complaints, []);
  await close();
});

test("readings in the address outlive a look at half-planes", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.strip);
  await change(page);
  // At once: the readings are written only later.
  await page.locator('[data-view-choice="half-planes"]').click();
  await page.waitForURL(/#view=half-planes&.*&ask=fit&/);
  await page.locator("#plane-text").fill("x >= 1\ny >= 1");
  await page.waitForURL(/planes=x\+%3E%3D\+1%0A.*&ask=fit&.*table=/);
  const csv = await page.evaluate(() => boundfit.editor.csv());
  assert.match(csv, /1\.25/);
  await page.reload();
  await page.evaluate(() => boundfit.editor.settled());
  assert.equal(await page.locator("body").getAttribute("data-view"), "half-planes");
  assert.equal(await page.locator("#plane-text").inputValue(), "x >= 1\ny >= 1");
  assert.equal(await page.evaluate(() => boundfit.editor.csv()), csv);
  await page.waitForTimeout(1000);
  assert.match(page.url(), /#view=half-planes&.*&ask=fit&.*table=/);
  await page.locator('[data-view-choice="readings"]').click();
  await page.waitForURL(/#ask=fit&/);
  await page.reload();
  await settled(page);
  assert.equal(await page.evaluate(() => boundfit.editor.csv()), csv);
  // What is said of half-planes alone is about no readings.
  await page.evaluate(() => { location.hash = "view=half-planes&planes=x+>=+0&step=9"; });
  await page.waitForTimeout(600);
  assert.equal(await page.locator("#edit-notice").textContent(), "");
  assert.deepEqual(complaints, []);
  await close();
});

test("links of older versions are refused, and the page says what to do", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  for (const words of ["readings-1.AAAA", "tab=clip&order=1&step=4", "layers=pui-box"]) {
    await page.evaluate((own) => { location.hash = own; }, `#${words}`);
    await page.evaluate(() => boundfit.editor.settled());
    assert.match(await page.locator("#edit-notice").textContent(), /older version .* export the readings there and open them here\.$/, words);
  }
  assert.equal(await page.locator("body").getAttribute("data-mode"), "explore");
  assert.deepEqual(complaints, []);
  await close();
});

test("the engine takes bytes in any form, and says what it was not given", async () => {
  const table = "x,y\n0,0\n1,1\n2,2\n";
  const asked = { x: "x", y: "y", eps: "1" };
  const bytes = new TextEncoder().encode(table);
  // A view of a part of a buffer has a beginning of its own.
  const shifted = new Uint8Array(bytes.length + 3);
  shifted.set(bytes, 3);
  for (const own of [bytes, bytes.buffer, new DataView(bytes.buffer), shifted.subarray(3), new DataView(shifted.buffer, 3)])
    assert.equal(run(own, asked), run(table, asked));
  for (const wrong of [null, undefined, 7, [1, 2], {}])
    assert.throws(() => run(wrong, asked), { name: "TypeError", message: /^the table is neither text nor bytes/ });
  assert.throws(() => run(table), /x is missing/);
  const fresh = await import("../../crates/lesson/engine/boundfit.mjs?not-started");
  assert.throws(() => fresh.run(table, asked), /the engine has not been started/);
});

test("the link past the header goes to the planes and is no link to readings", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.strip);
  await page.locator("a.skip").focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => location.hash), "#planes");
  await settled(page);
  assert.equal(await page.locator("[role=alert]:visible").count(), 0);
  assert.doesNotMatch(await page.locator("#editor").innerText(), /planes/);
  assert.deepEqual(complaints, []);
  await close();
});

test("readings of a link without a file have a title without one, in each language", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.strip);
  await page.evaluate(() => {
    location.hash = "ask=fit&x=V&y=z&eps=1&table=V,z%0A0,0%0A1,1.5%0A";
  });
  const title = page.locator("#title");
  await page.waitForFunction(() => document.querySelector("#title").textContent === "z against V");
  await page.locator("#language").selectOption("de");
  assert.equal(await title.textContent(), "z gegen V");
  assert.doesNotMatch(await page.locator("#provenance").textContent(), /standard/);
  assert.deepEqual(complaints, []);
  await close();
});
