// Tables that are taken into the page: cells stay as they were written, nothing is passed over in silence, and what is refused is said in
// the language of the page.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { PLAYGROUND, fitReport, launch, openLesson } from "./harness.js";

const FIXTURE = "fixtures/lesson/trailing-zeros.tsv";
const TABLE = readFileSync(fileURLToPath(new URL(`../../${FIXTURE}`, import.meta.url)), "utf8");
const CELLS = TABLE.trim().split("\n").slice(1).flatMap((line) => line.split("\t"));
const WRITTEN = [FIXTURE, "--x", "U", "--y", "I", "--eps", "written"];

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

const settled = (page) => page.locator('#editor[data-busy="false"]').waitFor();
const cells = (page) => page.locator("[data-cell]").evaluateAll((inputs) => inputs.map(({ value }) => value));
const kind = (page) => page.locator("#parameter-plane").getAttribute("data-kind");
const request = (page) => page.evaluate(() => boundfit.editor.sheet().request);
const noCells = (page) => page.waitForFunction(() => boundfit.editor.sheet().rows.every(({ cells }) => cells.every((cell) => cell === "")));

async function filled(page, id, text) {
  await page.locator(id).fill(text);
  await page.locator(id).press("Enter");
  await settled(page);
}

/** Ways to bring a table into the page, each waits until it is there or is asked about. */
const WAYS = {
  async box(page, text) {
    await page.locator("#paste-text").fill(text);
    await page.locator("#paste-use").click();
  },
  async cells(page, text) {
    await page.locator('[data-cell="0 0"]').evaluate((input, pasted) => {
      const data = new DataTransfer();
      data.setData("text/plain", pasted);
      input.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
    }, text);
  },
  async drop(page, text) {
    await page.evaluate((own) => {
      const data = new DataTransfer();
      data.items.add(new File([own], "dropped.tsv"));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    }, text);
  },
};

test("half a unit of the last digit is the same in every order of gestures, and the cells keep their text", async () => {
  const { fps } = fitReport(WRITTEN);
  assert.equal(fps.kind, "empty");
  for (const [way, bring] of Object.entries(WAYS)) {
    for (const isFirst of [true, false]) {
      const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
      if (isFirst) await filled(page, "#eps", "written");
      await bring(page, TABLE);
      await page.waitForFunction(() => boundfit.editor.sheet().columns[0] === "U");
      await settled(page);
      if (!isFirst) await filled(page, "#eps", "written");
      assert.deepEqual(await cells(page), CELLS, way);
      assert.equal(await kind(page), fps.kind, `${way}, the bound ${isFirst ? "first" : "last"}`);
      assert.equal(await page.locator("#bounds-kind").inputValue(), "eps");
      const csv = await page.evaluate(() => boundfit.editor.csv());
      assert.match(csv, /^U;I\n0,50;1,00\n1,00;2,10\n/, "what is taken away has the text too");
      await page.locator("#undo").click();
      await page.locator("#undo").click();
      await noCells(page);
      await page.locator("#redo").click();
      await page.locator("#redo").click();
      await settled(page);
      assert.deepEqual(await cells(page), CELLS);
      assert.equal(await kind(page), fps.kind);
      assert.deepEqual(complaints, []);
      await close();
    }
  }
});

test("a lesson of the program has the cells of its file, and one rule about them is the program's", async () => {
  for (const [options, asked] of [[WRITTEN, "written"], [[...WRITTEN.slice(0, -1), "0.5"], "1/2"]]) {
    const { page, complaints, close } = await openLesson(browser, options);
    await page.locator("#edit-toggle").click();
    assert.equal(await page.locator("#eps").inputValue(), asked);
    assert.deepEqual(await cells(page), CELLS);
    await filled(page, "#eps", "written");
    assert.equal(await kind(page), "empty");
    assert.match(await page.evaluate(() => boundfit.editor.command()), /--decimal comma .*--eps written/);
    // By another link the same.
    await page.waitForTimeout(1000);
    if (asked !== "written") {
      const other = await page.context().newPage();
      await other.goto(page.url());
      await other.waitForFunction(() => boundfit.editor?.sheet().request.eps === "written");
      await settled(other);
      await other.locator("#edit-toggle").click();
      assert.deepEqual(await cells(other), CELLS);
      assert.equal(await kind(other), "empty");
    }
    assert.deepEqual(complaints, []);
    await close();
  }
});

test("a reading that is moved has as many decimals as before, with the mark of its table", async () => {
  const { page, complaints, close } = await openLesson(browser, WRITTEN);
  await page.locator("#edit-toggle").click();
  await page.locator('#data-plane [data-reading="2"]').focus();
  for (const key of ["Shift+ArrowUp", "Shift+PageUp", "Shift+ArrowRight"]) {
    await page.keyboard.press(key);
    await settled(page);
    assert.equal(await page.locator("#sheet-problem").count(), 0, key);
  }
  const moved = (await cells(page)).slice(2, 4);
  for (const [k, text] of moved.entries()) {
    assert.match(text, /^\d+,\d{2,}$/);
    assert.notEqual(text, CELLS[2 + k]);
  }
  assert.deepEqual((await cells(page)).slice(4), CELLS.slice(4));
  assert.deepEqual(complaints, []);
  await close();
});

test("bounds and conditions are typed with the decimal mark that the page shows", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  await page.locator("#language").selectOption("de");
  await page.locator("#edit-example").click();
  await settled(page);
  assert.equal((await cells(page))[1], "0,1");
  await filled(page, "#eps", "9,5");
  assert.deepEqual([(await request(page)).eps, await page.locator("#eps").inputValue()], ["9.5", "9,5"]);
  await filled(page, "#eps", "+0,5/-,25*|y|");
  assert.equal((await request(page)).eps, "+0.5/-.25*|y|");
  await filled(page, "#where", "theta1 <= 5,5; theta2 >= -0,5");
  assert.deepEqual((await request(page)).where, ["theta1 <= 5.5", "theta2 >= -0.5"]);
  assert.equal(await page.locator("#where").inputValue(), "theta1 <= 5,5; theta2 >= -0,5");
  assert.equal(await page.locator("#sheet-problem").count(), 0);
  assert.match(await page.locator("#eps-hint").textContent(), /0,5e-3/);
  assert.match(await page.locator("#where-hint").textContent(), /theta1 >= 0,5/);
  // Three numbers in a row are none.
  await filled(page, "#eps", "1,2,3");
  assert.match(await page.locator("#eps-hint").textContent(), /^„1,2,3“: /);
  // 1.234 may mean thousands: it is asked back, as in a cell.
  for (const text of ["1.234", "1.234,5"]) {
    await filled(page, "#eps", text);
    assert.match(await page.locator("#eps-hint").textContent(), new RegExp(`^„${text}“: ein Punkt, aber das Dezimalzeichen ist hier das Komma`));
    assert.equal(await page.locator("#eps").inputValue(), text);
  }
  await filled(page, "#eps", "1,234");
  assert.equal((await request(page)).eps, "1.234");
  const conditions = await page.locator("#where").inputValue();
  await filled(page, "#where", "theta1 >= 1.234");
  assert.match(await page.locator("#where-hint").textContent(), /ein Punkt, aber das Dezimalzeichen ist hier das Komma/);
  await filled(page, "#where", conditions);
  await page.locator("#language").selectOption("en");
  await page.waitForFunction(() => document.querySelector("#eps").value === "1,234", null, { timeout: 2000 });
  assert.match(await page.locator("#eps-hint").textContent(), /0,5e-3/, "the cells have commas");
  await page.locator("#edit-back").click();
  await settled(page);
  await page.locator("#edit-example").click();
  await settled(page);
  await filled(page, "#eps", "9,5");
  assert.match(await page.locator("#eps-hint").textContent(), /^“9,5”: a comma, but the decimal mark is a point here/);
  assert.deepEqual(complaints, []);
  await close();
});

test("a comma that is typed where the page shows commas is a decimal one, also before three digits", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  await page.locator("#language").selectOption("it");
  for (const [place, text] of [["0 0", "1"], ["0 1", "1,234"], ["1 0", "2,500"], ["1 1", "2"]]) {
    await page.locator(`[data-cell="${place}"]`).fill(text);
    await page.locator(`[data-cell="${place}"]`).press("Tab");
    await settled(page);
  }
  assert.equal(await page.locator("#sheet-problem").count(), 0);
  assert.equal(await page.evaluate(() => boundfit.editor.csv()), "x;y\n1;1,234\n2,500;2\n");
  // Whoever gets the link reads the same, in any language.
  await page.waitForTimeout(1000);
  const other = await page.context().newPage();
  await other.goto(page.url());
  await other.locator('#data-plane [data-reading="2"]').waitFor();
  assert.equal(await other.evaluate(() => boundfit.editor.csv()), "x;y\n1;1,234\n2,500;2\n");
  assert.deepEqual(complaints, []);
  await close();
});

test("a column of numbers that is left over is asked about, however the table comes", async () => {
  for (const [way, bring] of Object.entries(WAYS)) {
    const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
    await bring(page, "x\ty\tu(y)\n1\t2\t0,1\n2\t4,1\t0,2\n3\t5,9\t0,1\n");
    await page.locator("#import").waitFor();
    await page.locator("#import-eps_column").selectOption({ label: "3: u(y)" });
    await page.locator("#import-apply").click();
    await page.locator("#import").waitFor({ state: "detached" });
    await settled(page);
    assert.deepEqual((await cells(page)).slice(0, 3), ["1", "2", "0,1"], way);
    assert.deepEqual(complaints, []);
    await close();
  }
  const { page, close } = await openLesson(browser, PLAYGROUND);
  // Cells without names, three wide.
  await WAYS.cells(page, "1\t2\t0,1\n2\t4,1\t0,2\n3\t5,9\t0,1\n");
  await page.locator("#import").waitFor();
  await page.locator("#import-cancel").click();
  // One wrong cell makes no column of words.
  await WAYS.box(page, "x\ty\tu(y)\n1\t2\t0,1\n2\t4,1\t?!\n3\t5,9\t0,1\n");
  await page.locator("#import").waitFor();
  await page.locator("#import-cancel").click();
  // Names of samples are no numbers.
  await WAYS.box(page, "sample\tU\tI\nfirst\t1\t2\nlast\t2\t4,1\n");
  await page.waitForFunction(() => boundfit.editor.sheet().columns.join() === "U,I");
  await close();
});

test("the form comes into sight with the focus, and says in the page's language what is wrong and what can be done there", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND, { width: 1280, height: 800 });
  const problem = page.locator("#import-problem");
  const use = async (text) => {
    if ((await page.locator("#import-cancel").count()) > 0) await page.locator("#import-cancel").click();
    await WAYS.box(page, text);
    await page.locator("#import").waitFor();
  };
  await page.locator("#language").selectOption("de");
  await use("t (s)\tx (m)\tv (m/s)\n1\t2\t3\n2\t4\t3\n3\t6\t3\n");
  const place = await page.locator("#import").evaluate((form) => {
    const { top, bottom } = form.getBoundingClientRect();
    return [top >= 0 && bottom <= innerHeight, document.activeElement.id];
  });
  assert.deepEqual(place, [true, "import-x"]);
  // Units below the names.
  await use("U\tI\nV\tmA\n0,5\t1,0\n1,0\t2,1\n1,5\t2,9\n");
  assert.match(await problem.textContent(), /^Zeile 2, Spalte U: „V“: die Zeile unter den Namen hat keine Zahl\. Bitte „Einheiten unter den Namen“ ankreuzen/);
  await page.locator("#import-units").check();
  await page.waitForFunction(() => document.querySelector("#import-problem") === null);
  await page.locator("#import-apply").click();
  await page.locator("#import").waitFor({ state: "detached" });
  await settled(page);
  assert.deepEqual((await cells(page)).slice(0, 2), ["0,5", "1,0"]);
  assert.match(await page.locator("#data-plane").textContent(), /U \(V\)/);
  // Digits in groups.
  await use("x\ty\n1.000,5\t2,5\n2.000,5\t5,1\n3.000,5\t7,4\n");
  await page.locator("#import-thousands").selectOption({ label: "Punkt (1.000)" });
  await page.locator("#import-apply").click();
  await page.locator("#import").waitFor({ state: "detached" });
  await settled(page);
  assert.deepEqual((await cells(page)).slice(0, 2), ["1000,5", "2,5"]);
  // A cell without a number.
  await use("x\ty\n1\t2\n2\t\n3\t5,9\n4\t8,1\n");
  assert.match(await problem.textContent(), /^Zeile 3, Spalte y: in einer Zeile fehlt eine Zahl\. Bitte „Zeilen mit fehlenden Werten weglassen“ ankreuzen/);
  await page.locator("#import-skip").check();
  await page.locator("#import-apply").click();
  await page.locator("#import").waitFor({ state: "detached" });
  await settled(page);
  assert.equal(await page.locator("#data-plane [data-reading]").count(), 3);
  // Of no message is an option of the program part.
  for (const text of ["x\ty\n1\t2±0,1\n2\t4\n", "x,y\n1,5,2,5\n2,5,3,5\n", "x\ty\n1\t1,000.5\n", "x;y\n1;2\n2;2026-11-23\n", "x y\n1 2\n2 3 4 5\n", "x\ty\n1\t\n"]) {
    if ((await page.locator("#import-cancel").count()) > 0) await page.locator("#import-cancel").click();
    await WAYS.box(page, text);
    await page.locator("#import-problem, #edit-notice:not([hidden])").first().waitFor();
    const said = await page.locator("#import-problem, #edit-notice:not([hidden])").first().textContent();
    assert.doesNotMatch(said, /--|not a number|the row has|value is missing/, text);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test("what a table was taken for is said, where it is asked about and where it is not", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  await WAYS.box(page, "1;2,5\n2;4,1\n");
  await page.locator("#edit-taken:not([hidden])").waitFor();
  assert.equal(await page.locator("#edit-taken").textContent(), "Read as: no names, line 1 is a reading, columns separated by semicolons and decimal comma.");
  await page.locator("#edit-back").click();
  assert.ok(await page.locator("#edit-taken").isHidden());
  await WAYS.box(page, "10\t20\t30\n1\t2.5\t3\n2\t4.1\t3\n");
  await page.locator("#import").waitFor();
  for (const [language, words] of [
    ["en", "Read as: no names, line 1 is a reading, columns separated by tabs and decimal point."],
    ["it", "Letta così: senza nomi, la riga 1 è una lettura, colonne separate da tabulazioni e punto decimale."],
    ["de", "Gelesen als: ohne Namen, Zeile 1 ist eine Messung, Spalten durch Tabulatoren getrennt und Dezimalpunkt."],
  ]) {
    await page.locator("#language").selectOption(language);
    assert.equal(await page.locator("#import-notes").textContent(), words);
  }
  // Line 1 has names after all.
  await page.locator("#import-header").selectOption("yes");
  await page.waitForFunction(() => /Namen in Zeile 1/.test(document.querySelector("#import-notes").textContent));
  assert.deepEqual(await page.locator("#import-x option").allTextContents(), ["1: 10", "2: 20", "3: 30"]);
  assert.deepEqual(complaints, []);
  await close();
});

test("1.500 is asked back where the page shows decimal commas, whatever was typed first", async () => {
  /** @param {[number, number, string][]} typed */
  const told = async (language, typed) => {
    const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
    await page.locator("#language").selectOption(language);
    for (const [row, column, text] of typed) {
      await page.locator(`[data-cell="${row} ${column}"]`).fill(text);
      await page.locator(`[data-cell="${row} ${column}"]`).press("Tab");
      await settled(page);
    }
    const problem = page.locator("#sheet-problem");
    const words = (await problem.count()) === 0 ? "" : await problem.textContent();
    const readings = await page.locator("#data-plane [data-reading]").count();
    assert.deepEqual(complaints, []);
    await close();
    return [words, readings];
  };
  const asked = /^„1\.500“: ein Punkt, aber das Dezimalzeichen ist hier das Komma/;
  for (const typed of [
    [[0, 0, "1.500"], [0, 1, "2"], [1, 0, "2.500"], [1, 1, "4"]],
    [[0, 1, "2,5"], [0, 0, "1.500"]],
    [[0, 0, "1.500"], [0, 1, "2,5"]],
  ]) {
    const [words, readings] = await told("de", typed);
    assert.match(words, asked);
    assert.equal(readings, 0);
  }
  // A point that can only be a decimal mark says what the others are.
  assert.deepEqual(await told("de", [[0, 0, "1.5"], [0, 1, "2"], [1, 0, "2.500"], [1, 1, "4"]]), ["", 2]);
  assert.deepEqual(await told("de", [[0, 0, "1500"], [0, 1, "0.125"]]), ["", 1]);
  assert.deepEqual(await told("en", [[0, 0, "1.500"], [0, 1, "2"]]), ["", 1]);
});

test("cells that are pasted with 1.500 and 1.25 have decimal points; with 1.500 alone they are asked back", async () => {
  for (const [text, count] of [["1.500\t2\n2.25\t4", 2], ["2.25\t4\n1.500\t2", 2], ["1.500\t2\n2.250\t4", 0]]) {
    const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
    await page.locator("#language").selectOption("it");
    await WAYS.cells(page, text);
    await settled(page);
    assert.equal(await page.locator("#data-plane [data-reading]").count(), count, text);
    assert.equal(await page.locator("#sheet-problem").count(), count === 0 ? 1 : 0, text);
    assert.deepEqual(complaints, []);
    await close();
  }
});

test("a header with digits that is pasted into a cell has the names of columns", async () => {
  for (const names of [["U1", "I1"], ["x1", "y"], ["CO2", "T (°C)"], ["θ₁", "U/V 2"]]) {
    const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
    await WAYS.cells(page, `${names.join("\t")}\n1\t2\n2\t4.1\n3\t6\n`);
    await page.waitForFunction((own) => boundfit.editor.sheet().columns[0] === own, names[0]);
    await settled(page);
    assert.deepEqual(await cells(page), ["1", "2", "2", "4.1", "3", "6"]);
    assert.deepEqual(complaints, []);
    await close();
  }
  const { page, close } = await openLesson(browser, PLAYGROUND);
  await WAYS.cells(page, "1e3\t2e3\n2e3\t4e3");
  await settled(page);
  assert.deepEqual((await cells(page)).slice(0, 4), ["1e3", "2e3", "2e3", "4e3"], "numbers are no names");
  await close();
});

test("names without rows are refused, and the readings stay", async () => {
  const { page, complaints, close } = await openLesson(browser, WRITTEN);
  await page.locator("#edit-toggle").click();
  await page.locator("#paste summary").click();
  await WAYS.box(page, "hello world");
  await page.locator("#import-problem").waitFor();
  assert.match(await page.locator("#import-problem").textContent(), /^There are names but no rows of numbers/);
  await page.locator("#language").selectOption("de");
  assert.match(await page.locator("#import-problem").textContent(), /^Es gibt Namen, aber keine Zeile mit Zahlen/);
  assert.deepEqual(await cells(page), CELLS);
  await page.locator("#import-cancel").click();
  assert.equal(await page.locator("#undo").getAttribute("aria-disabled"), "true");
  assert.deepEqual(complaints, []);
  await close();
});

test("a pasted table has no name of one language, and what is said of it follows the language of the page", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  const says = async (selector, words) => {
    for (const [language, expected] of Object.entries(words)) {
      await page.locator("#language").selectOption(language);
      assert.equal(await page.locator(selector).textContent(), expected);
    }
  };
  await page.locator("#language").selectOption("de");
  await WAYS.box(page, "x;y;z\n1;2,5;3\n2;4,1;3\n3;6,2;3\n");
  await page.locator("#import").waitFor();
  await says("#import legend", { it: "Scegliere le colonne della tabella incollata", en: "Choose columns of the pasted table", de: "Welche Spalten der eingefügten Tabelle?" });
  await page.locator("#import-apply").click();
  await page.locator("#import").waitFor({ state: "detached" });
  await settled(page);
  assert.match(await page.locator("#status").textContent(), /^Die eingefügte Tabelle wurde übernommen\. /);
  await page.locator("#language").selectOption("de");
  assert.equal(await page.title(), "y gegen x");
  await says("#title", { de: "y gegen x", it: "y in funzione di x", en: "y against x" });
  assert.doesNotMatch(await page.locator("#provenance").textContent(), /Tabelle|table|input/);
  await says("#edit-taken", {
    de: "Gelesen als: Namen in Zeile 1, Spalten durch Semikolons getrennt und Dezimalkomma.",
    en: "Read as: names in line 1, columns separated by semicolons and decimal comma.",
  });
  await page.locator("#language").selectOption("de");
  await WAYS.box(page, " ");
  await page.locator("#edit-notice:not([hidden])").waitFor();
  await says("#edit-notice", { de: "Eingefügte Tabelle: Die Tabelle ist leer", en: "Pasted table: There is nothing in the table", it: "Tabella incollata: La tabella è vuota" });
  assert.deepEqual(complaints, []);
  await close();
});

test("tables with two empty lines between them are refused with a way out", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  await WAYS.box(page, "x;y\n1;2\n2;4\n\n\n3;6\n4;8\n");
  const said = page.locator("#import-problem, #edit-notice:not([hidden])").first();
  await said.waitFor();
  for (const [language, words] of [
    ["en", /\. Two empty lines in a row separate tables: delete them\.$/],
    ["de", /\. Zwei Leerzeilen hintereinander trennen Tabellen: Bitte die Leerzeilen löschen\.$/],
    ["it", /\. Due righe vuote di seguito separano le tabelle: eliminarle\.$/],
  ]) {
    await page.locator("#language").selectOption(language);
    assert.match(await said.textContent(), words);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test("a file that is no text is refused with the page's way out", async () => {
  const { page, close } = await openLesson(browser, PLAYGROUND);
  const file = join(tmpdir(), `boundfit-tables-${process.pid}.xlsx`);
  writeFileSync(file, "PK\u0003\u0004nothing");
  await page.locator("#open-file").setInputFiles(file);
  await page.locator("#edit-notice:not([hidden])").waitFor();
  assert.match(await page.locator("#edit-notice").textContent(), /\.xlsx: This file is no table of text\. Save its table as CSV, or copy its cells and paste them here\.$/);
  await close();
});

test("names that are keys of JSON and underscores between digits are told as they are", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  await WAYS.box(page, '[{"x":0,"y":1},{"x":1,"y":2.1}]');
  await page.waitForFunction(() => document.body.innerText.includes("Read as: "));
  assert.match(await page.locator("body").innerText(), /Read as: names from the keys\./);
  await settled(page);
  await filled(page, '[data-cell="0 1"]', "1_000");
  assert.match(await page.locator("#sheet-problem").textContent(), /“1_000”: digits are not grouped with _ here/);
  assert.deepEqual(complaints, []);
  await close();
});
