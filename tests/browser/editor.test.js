// Readings changed on the page: with the mouse, a finger, the keyboard, by typing, pasting, dropping; and what is taken away.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { deflateRawSync } from "node:zlib";

import { DATA, PLAYGROUND, SPECIAL, boundfit, checkPicture, fitReport, launch, openLesson } from "./harness.js";

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

const LINE = ["fixtures/claims/strip.csv", "--x", "x", "--y", "y", "--eps", "0.2"];

/** Waits until the page shows what was asked last. */
const settled = (page) => page.locator('#editor[data-busy="false"]').waitFor();

const vertices = (page) =>
  page.locator("#parameter-plane [data-vertex]").evaluateAll((marks) => marks.map(({ dataset }) => [dataset.theta1, dataset.theta2].join()));

/** What the program says of the readings that the page shows, by the command that the page shows. */
async function programOf(page) {
  const { csv, command } = await page.evaluate(() => ({ csv: boundfit.editor.csv(), command: boundfit.editor.command() }));
  const file = join(tmpdir(), `boundfit-editor-${process.pid}.csv`);
  writeFileSync(file, csv);
  const words = [...command.matchAll(/'([^']*)'|(\S+)/g)].map(([, quoted, plain]) => quoted ?? plain);
  assert.deepEqual(words.slice(0, 3), ["boundfit", "fit", "readings.csv"]);
  return fitReport([file, ...words.slice(3)]);
}

async function assertAsTheProgram(page) {
  await settled(page);
  const { fps } = await programOf(page);
  assert.equal(await page.locator("#parameter-plane").getAttribute("data-kind"), fps.kind);
  assert.deepEqual((await vertices(page)).sort(), fps.vertices.map(({ theta }) => theta.map(({ exact }) => exact).join()).sort());
}

async function opened(options, context) {
  const lesson = await openLesson(browser, options, context);
  await lesson.page.locator("#edit-toggle").click();
  return lesson;
}

const cell = (page, row, column) => page.locator(`[data-cell="${row} ${column}"]`);
const cells = (page) => page.locator("[data-cell]").evaluateAll((inputs) => inputs.map(({ value }) => value));

async function typed(page, row, column, text) {
  await cell(page, row, column).fill(text);
  await cell(page, row, column).press("Tab");
  await settled(page);
}

test("a number that is typed is computed with as it stands, with a comma or as a fraction too", async () => {
  const { page, complaints, close } = await opened(LINE);
  for (const text of ["1.50", "1,25", "4/3", "1e-3"]) {
    await typed(page, 0, 1, text);
    assert.equal(await cell(page, 0, 1).inputValue(), text);
    await assertAsTheProgram(page);
    assert.match(await page.locator("#status").textContent(), /^y of reading 1 is now .*\. The set is /);
  }
  assert.equal(await page.locator('#readings tbody tr:first-child td:nth-child(3)').textContent(), "0.001");
  assert.deepEqual(complaints, []);
  await close();
});

test("a wrong number is marked with the engine's words, and the last right set stays", async () => {
  const { page, complaints, close } = await opened(LINE);
  const before = await vertices(page);
  await typed(page, 1, 1, "2..5");
  const problem = page.locator("#sheet-problem");
  assert.match(await problem.textContent(), /^“2\.\.5”: not a number/);
  assert.equal(await cell(page, 1, 1).getAttribute("aria-invalid"), "true");
  assert.equal(await cell(page, 1, 1).getAttribute("aria-describedby"), "sheet-problem");
  assert.deepEqual(await vertices(page), before);
  await typed(page, 1, 1, "2.5");
  assert.equal(await problem.count(), 0);
  await assertAsTheProgram(page);
  // What was refused is no step of its own.
  await page.locator("#undo").click();
  await settled(page);
  assert.deepEqual(await vertices(page), before);
  assert.deepEqual(complaints, []);
  await close();
});

test("thousands or a decimal comma: what cannot be told is asked back", async () => {
  const { page, close } = await opened(LINE);
  await typed(page, 0, 1, "1,000");
  assert.match(await page.locator("#sheet-problem").textContent(), /“1,000”/);
  await close();
});

test("error bounds, conditions, the origin: any words of the program, and its own refusals", async () => {
  const { page, complaints, close } = await opened(DATA.transducer);
  for (const eps of ["1/1000", "2*min", "0.1%*|y|+0.4e-3", "+0.5e-3/-0.6e-3"]) {
    await page.locator("#eps").fill(eps);
    await page.locator("#eps").press("Enter");
    await assertAsTheProgram(page);
  }
  await page.locator("#eps").fill("a lot");
  await page.locator("#eps").press("Enter");
  await settled(page);
  assert.match(await page.locator("#eps-hint").textContent(), /^“a lot”: /);
  await page.locator("#eps").fill("0.5e-3");
  await page.locator("#where").fill("theta1 >= 0.0018; theta2 <= 0.0228");
  await page.locator("#where").press("Enter");
  await assertAsTheProgram(page);
  assert.equal(await page.locator("#parameter-plane .bound.condition").count(), 2);
  await page.locator("#where").fill("theta3 >= 0");
  await page.locator("#where").press("Enter");
  await settled(page);
  assert.match(await page.locator("#where-hint").textContent(), /theta3/);
  await page.locator("#where").fill("");
  await page.locator("#where").press("Enter");
  await page.locator("#through-origin").check();
  await assertAsTheProgram(page);
  assert.deepEqual(complaints, []);
  await close();
});

test("readings are added, left out and deleted", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  const count = await page.locator("[data-sheet-row]").count();
  await page.locator("#add-reading").click();
  assert.equal(await page.evaluate(() => document.activeElement.dataset.cell), `${count} 0`);
  await page.keyboard.type("500");
  await page.keyboard.press("Tab");
  await settled(page);
  assert.equal(await page.locator("#sheet-problem").count(), 0, "a row that is not finished is no mistake");
  assert.equal(await page.locator("#data-plane [data-reading]").count(), count);
  await page.keyboard.type("501.5");
  await page.keyboard.press("Enter");
  await settled(page);
  assert.equal(await page.locator("#data-plane [data-reading]").count(), count + 1);
  await assertAsTheProgram(page);
  await page.locator('[data-fitted="3"]').uncheck();
  await assertAsTheProgram(page);
  assert.equal(await page.locator('#data-plane [data-reading="4"]').count(), 0);
  await page.locator('[data-delete="0"]').click();
  await assertAsTheProgram(page);
  assert.deepEqual(complaints, []);
  await close();
});

test("without the last reading everything is possible, and undo brings it back", async () => {
  const { page, complaints, close } = await opened(SPECIAL.noError);
  const kind = page.locator("#parameter-plane");
  for (let left = 3; left > 0; left -= 1) {
    await page.locator('[data-delete="0"]').click();
    await settled(page);
  }
  assert.equal(await kind.getAttribute("data-kind"), "plane");
  assert.equal(await page.locator("#sheet-problem").count(), 0);
  await page.locator("#undo").click();
  await assertAsTheProgram(page);
  assert.equal(await kind.getAttribute("data-kind"), "line");
  assert.deepEqual(complaints, []);
  await close();
});

test("a reading is dragged with the mouse; the page follows, and one step undoes it", async () => {
  const { page, complaints, close } = await opened(DATA.transducer);
  const before = [await cells(page), await vertices(page)];
  await page.locator("#data-plane").scrollIntoViewIfNeeded();
  const place = await page.locator('#data-plane [data-reading="20"] .dot').boundingBox();
  await page.mouse.move(place.x + 3, place.y + 3);
  await page.mouse.down();
  await page.mouse.move(place.x + 23, place.y - 20, { steps: 12 });
  await settled(page);
  assert.notDeepEqual(await cells(page), before[0], "while it is dragged");
  await page.mouse.up();
  await assertAsTheProgram(page);
  const moved = await cells(page);
  const changed = moved.flatMap((text, k) => (text === before[0][k] ? [] : [[k, text]]));
  assert.deepEqual(changed.map(([k]) => k), [38, 39]);
  for (const [, text] of changed) assert.ok(text.length <= 9, `a short decimal: ${text}`);
  assert.equal(await page.locator('#data-plane [data-reading="20"]').getAttribute("aria-pressed"), "true");
  await page.locator("#undo").click();
  await settled(page);
  assert.deepEqual([await cells(page), await vertices(page)], before);
  await page.locator("#redo").click();
  await settled(page);
  assert.deepEqual(await cells(page), moved);
  // Straight up or down, x stays.
  const there = await page.locator('#data-plane [data-reading="25"] .dot').boundingBox();
  await page.mouse.move(there.x + 3, there.y + 3);
  await page.mouse.down();
  await page.mouse.move(there.x + 6, there.y + 30, { steps: 9 });
  await page.mouse.up();
  await assertAsTheProgram(page);
  assert.deepEqual((await cells(page)).flatMap((text, k) => (text === moved[k] ? [] : [k])), [49]);
  assert.deepEqual(complaints, []);
  await close();
});

test("a finger scrolls over a reading until it is chosen, and drags it then", async () => {
  const { page, complaints, close } = await opened(DATA.transducer, { hasTouch: true });
  const before = await cells(page);
  const reading = page.locator('#data-plane [data-reading="20"]');
  const session = await page.context().newCDPSession(page);
  const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  const drag = async () => {
    await reading.scrollIntoViewIfNeeded();
    const { x, y } = await reading.locator(".dot").boundingBox();
    await touch("touchStart", [{ x: x + 3, y: y + 3 }]);
    for (let k = 1; k <= 8; k += 1) await touch("touchMove", [{ x: x + 3 + 3 * k, y: y + 3 - 3 * k }]);
    await touch("touchEnd", []);
    await settled(page);
  };
  await drag();
  assert.deepEqual(await cells(page), before);
  await reading.scrollIntoViewIfNeeded();
  const place = () => reading.locator(".dot").boundingBox();
  // The page scrolls on after the finger has left it, and a tap would only stop it.
  let there = await place();
  for (let frames = 0; frames < 10; frames += 1) {
    await page.evaluate(() => new Promise(requestAnimationFrame));
    const now = await place();
    if (now.x !== there.x || now.y !== there.y) frames = 0;
    there = now;
  }
  await page.touchscreen.tap(there.x + 3, there.y + 3);
  await page.locator('#data-plane [data-reading="20"][aria-pressed="true"]').waitFor();
  await drag();
  assert.notDeepEqual(await cells(page), before);
  await assertAsTheProgram(page);
  assert.deepEqual(complaints, []);
  await close();
});

test("the keyboard moves, adds and deletes readings, and undoes", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  const before = await cells(page);
  const status = page.locator("#status");
  await page.locator('#data-plane [data-reading="5"]').focus();
  for (const key of ["Shift+ArrowUp", "Shift+ArrowUp", "Shift+ArrowRight", "Shift+PageDown"]) {
    await page.keyboard.press(key);
    await settled(page);
    assert.match(await status.textContent(), /^Reading 5 was moved to /);
    assert.equal(await page.evaluate(() => document.activeElement.dataset.reading), "5", "the focus stays");
  }
  await assertAsTheProgram(page);
  const count = await page.locator("#data-plane [data-reading]").count();
  await page.keyboard.press("Delete");
  await settled(page);
  assert.equal(await page.locator("#data-plane [data-reading]").count(), count - 1);
  for (let k = 0; k < 5; k += 1) {
    await page.keyboard.press("Control+z");
    await settled(page);
  }
  assert.deepEqual(await cells(page), before);
  await page.keyboard.press("Control+y");
  await settled(page);
  assert.notDeepEqual(await cells(page), before);
  await page.keyboard.press("Control+Shift+z");
  await settled(page);
  await page.locator('[data-edit="add"]').focus();
  await page.keyboard.press("Enter");
  await settled(page);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.reading), `${count + 1}`, "what was added can be moved at once");
  assert.deepEqual(complaints, []);
  await close();
});

test("a double click adds a reading where it is", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  const count = await page.locator("#data-plane [data-reading]").count();
  await page.locator("#data-plane").scrollIntoViewIfNeeded();
  const box = await page.locator("#data-plane").boundingBox();
  await page.mouse.dblclick(box.x + box.width * 0.4, box.y + box.height * 0.2);
  await settled(page);
  assert.equal(await page.locator("#data-plane [data-reading]").count(), count + 1);
  await assertAsTheProgram(page);
  assert.deepEqual(complaints, []);
  await close();
});

test("arrow keys and Enter walk through the cells", async () => {
  const { page, close } = await opened(LINE);
  await cell(page, 0, 1).focus();
  await page.keyboard.press("ArrowDown");
  assert.equal(await page.evaluate(() => document.activeElement.dataset.cell), "1 1");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.dataset.cell), "1 1");
  await close();
});

test("two regressors, bounds of each reading, intervals: all are cells, and moving keeps the bounds about y", async () => {
  const interval = ["fixtures/reduction/intervals.csv", "--x", "t", "--lower", "earliest", "--upper", "latest"];
  for (const options of [DATA.twoRegressors, DATA.steamGenerator, interval]) {
    const { page, complaints, close } = await opened(options);
    await assertAsTheProgram(page);
    const before = await cells(page);
    await page.locator('#data-plane [data-reading="2"]').focus();
    await page.keyboard.press("Shift+ArrowUp");
    await assertAsTheProgram(page);
    assert.notDeepEqual(await cells(page), before);
    assert.deepEqual(complaints, [], options.join(" "));
    await close();
  }
});

test("bounds of one kind become bounds of another kind", async () => {
  const { page, complaints, close } = await opened(DATA.transducer);
  const before = await vertices(page);
  for (const kind of ["column", "interval"]) {
    await page.locator("#bounds-kind").selectOption(kind);
    await assertAsTheProgram(page);
    assert.deepEqual(await vertices(page), before, kind);
  }
  await page.locator("#bounds-kind").selectOption("eps");
  await assertAsTheProgram(page);
  assert.deepEqual(complaints, []);
  await close();
});

test("what is done can be taken back to the class's data", async () => {
  const { page, complaints, close } = await opened(DATA.transducer);
  const before = [await cells(page), await vertices(page)];
  assert.ok(!(await page.locator("#edit-back").isVisible()));
  await typed(page, 20, 1, "0.02");
  await page.locator("#eps").fill("1e-3");
  await page.locator("#eps").press("Enter");
  await settled(page);
  assert.ok(await page.locator("#edit-changed").isVisible());
  await page.locator("#edit-back").click();
  await settled(page);
  assert.deepEqual([await cells(page), await vertices(page)], before);
  assert.ok(!(await page.locator("#edit-back").isVisible()));
  assert.deepEqual(complaints, []);
  await close();
});

test("a link restores readings and question exactly; a damaged one says so", async () => {
  const { page, complaints, close } = await opened(DATA.transducer);
  await typed(page, 20, 1, "0.0201");
  await page.locator("#eps").fill("1/1500");
  await page.locator("#eps").press("Enter");
  await page.locator("#where").fill("theta1 >= 0");
  await page.locator("#where").press("Enter");
  await settled(page);
  await page.locator("#layer-pui-box").check();
  await page.locator("#tab-clip").click();
  await page.locator("#clip-order").selectOption({ index: 1 });
  await page.locator("#step-slider").fill("4");
  // The address waits until the page is still.
  await page.waitForTimeout(1000);
  assert.match(page.url(), /#ask=fit&x=Vz&y=z&eps=1\/1500&where=\[%22theta1\+%3E%3D\+0%22\]&.*&table=[\w-]+&page\.file=transducer\.csv&page\.tab=clip&page\.order=1&page\.step=4&page\.layers=pui-box$/);
  await page.waitForFunction(() => document.querySelector("#link").value === location.href);
  const [address, shown, state] = [page.url(), await vertices(page), await cells(page)];
  const other = await page.context().newPage();
  await other.goto(address);
  await settled(other);
  await other.waitForFunction(() => document.querySelector("#edit-changed") && !document.querySelector("#edit-changed").hidden);
  await settled(other);
  await other.locator("#edit-toggle").click();
  assert.deepEqual([await vertices(other), await cells(other)], [shown, state]);
  assert.equal(await other.locator("#eps").inputValue(), "1/1500");
  assert.equal(await other.locator("#where").inputValue(), "theta1 >= 0");
  assert.equal(await other.locator("body").getAttribute("data-mode"), "clip");
  assert.deepEqual([await other.locator("#clip-order").inputValue(), await other.locator("#step-slider").inputValue()], ["1", "4"]);
  assert.ok(await other.locator("#layer-pui-box").isChecked());
  await other.evaluate(() => {
    location.hash = "#ask=fit&table=AAAA";
  });
  await other.locator("#edit-notice:not([hidden])").waitFor();
  assert.match(await other.locator("#edit-notice").textContent(), /cannot be read/);
  await other.evaluate(() => {
    location.hash = "#readings-1.AAAA";
  });
  await other.waitForFunction(() => /older version/.test(document.querySelector("#edit-notice").textContent));
  assert.deepEqual(await vertices(other), shown);
  assert.deepEqual(complaints, []);
  await close();
});

test("a link says what is looked at, and what has no meaning here is passed over", async () => {
  const { page, complaints, close } = await opened(DATA.transducer);
  await page.locator("#tab-epsilon").click();
  await page.locator("#epsilon-next").click();
  const stop = await page.locator("#epsilon-slider").inputValue();
  await page.waitForFunction(() => location.hash.startsWith("#page.tab=epsilon&page.stop="));
  await page.locator("#tab-explore").click();
  await page.waitForFunction(() => location.hash === "");
  const follow = (hash) => page.evaluate((own) => { location.hash = own; }, hash);
  const shown = () => page.evaluate(() => document.body.dataset.mode);
  await follow(`#page.tab=epsilon&page.stop=${stop}`);
  await page.waitForFunction(() => document.body.dataset.mode === "epsilon");
  assert.equal(await page.locator("#epsilon-slider").inputValue(), stop);
  await follow("#page.tab=leave-one-out&page.without=20 99999 21 x");
  await page.waitForFunction(() => document.body.dataset.mode === "leave-one-out");
  assert.equal(await page.locator("#readings input:not(:checked)").count(), 2);
  await follow("#page.tab=nowhere&page.order=9&page.step=1e9&page.stop=-1&page.layers=<b>&page.residual=maybe");
  await page.waitForFunction(() => document.body.dataset.mode === "explore");
  assert.equal(await shown(), "explore");
  assert.deepEqual(complaints, []);
  await close();
});

test("cells of a spreadsheet are pasted into the cells, a whole table into the box", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  const paste = (target, text) =>
    target.evaluate((input, pasted) => {
      const data = new DataTransfer();
      data.setData("text/plain", pasted);
      input.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
    }, text);
  const rows = await page.locator("[data-sheet-row]").count();
  await paste(cell(page, rows - 1, 0), "1,5\t2,5\r\n3,5\t4,5\r\n");
  await assertAsTheProgram(page);
  assert.equal(await page.locator("[data-sheet-row]").count(), rows + 1);
  assert.deepEqual((await cells(page)).slice(-4), ["1,5", "2,5", "3,5", "4,5"]);
  await page.locator("#paste summary").click();
  await page.locator("#paste-text").fill("U;I\n0,5;1,1\n1,5;2,3\n2,5;2,9\n");
  await page.locator("#paste-use").click();
  await page.waitForFunction(() => document.querySelector("#data-plane").textContent.includes("U"));
  await assertAsTheProgram(page);
  assert.equal(await page.locator("#data-plane [data-reading]").count(), 3);
  assert.deepEqual(complaints, []);
  await close();
});

test("blanks between groups of digits are shown as they are, and the form says how to read them", async () => {
  const { page, complaints, close } = await opened(LINE);
  await page.locator("#paste summary").click();
  await page.locator("#paste-text").fill("x\ty\n1\u{a0}000\t2\n2\u{a0}000\t4\n3\u{a0}000\t5\n");
  await page.locator("#paste-use").click();
  await page.locator("#import-problem").waitFor();
  const problem = await page.locator("#import-problem").textContent();
  assert.match(problem, /“1\u{a0}000”.*Choose “blank \(1 000\)” for “digits grouped by”, above\.$/u);
  await page.locator("#import-thousands").selectOption(" ");
  await page.locator("#import-apply").click();
  await page.locator("#import").waitFor({ state: "detached" });
  assert.deepEqual(complaints, []);
  await close();
});

test("a file is opened or dropped; where the header does not say it, the reader chooses the columns", async () => {
  const { page, complaints, close } = await opened(LINE);
  const file = join(tmpdir(), `boundfit-open-${process.pid}.csv`);
  writeFileSync(file, "U;T;I;note\n1,0;20;2,1;3\n2,0;21;3,9;\n3,0;22;6,2;1\n");
  await page.locator("#paste summary").click();
  await page.locator("#open-file").setInputFiles(file);
  await page.locator("#import").waitFor();
  assert.deepEqual(await page.locator("#import-x option").allTextContents(), ["1: U", "2: T", "3: I", "4: note"]);
  await page.locator("#import-y").selectOption({ label: "4: note" });
  await page.locator("#import-apply").click();
  await page.locator("#import-problem").waitFor();
  assert.match(await page.locator("#import-problem").textContent(), /^Line 3, column note: /);
  await page.locator("#import-y").selectOption({ label: "3: I" });
  await page.locator("#import-apply").click();
  await page.locator("#import").waitFor({ state: "detached" });
  await assertAsTheProgram(page);
  assert.deepEqual((await cells(page)).slice(0, 4), ["1,0", "2,1", "2,0", "3,9"]);
  await page.evaluate((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "dropped.csv"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, readFileSync(new URL("../../fixtures/norris/norris.csv", import.meta.url), "utf8"));
  await page.waitForFunction(() => document.querySelectorAll("#data-plane [data-reading]").length === 36);
  await assertAsTheProgram(page);
  assert.deepEqual(complaints, []);
  await close();
});

test("a file that is dropped on the half-planes does not take the place of the page", async () => {
  const { page, complaints, close } = await opened(DATA.transducer);
  await page.locator('[data-view-choice="half-planes"]').click();
  const csv = () => page.evaluate(() => boundfit.editor.csv());
  const before = await csv();
  const prevented = await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File(["x,y\n1,2\n2,3\n"], "dropped.csv"));
    return ["dragover", "drop"].map((kind) => {
      const event = new DragEvent(kind, { dataTransfer, bubbles: true, cancelable: true });
      document.body.dispatchEvent(event);
      return event.defaultPrevented;
    });
  });
  assert.deepEqual(prevented, [true, true]);
  await page.evaluate(() => boundfit.editor.settled());
  assert.equal(await csv(), before);
  assert.deepEqual(complaints, []);
  await close();
});

test("what is dropped and is no table is refused, with its name", async () => {
  const { page, close } = await opened(LINE);
  const before = await vertices(page);
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File([new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a])], "picture.png"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  });
  await page.locator("#edit-notice:not([hidden])").waitFor();
  assert.match(await page.locator("#edit-notice").textContent(), /picture\.png/);
  assert.deepEqual(await vertices(page), before);
  await close();
});

test("readings, reports and pictures can be taken away", async () => {
  const { page, complaints, close } = await opened(DATA.transducer);
  await typed(page, 20, 1, "0.0201");
  await page.locator("#export summary").click();
  const taken = async (kind) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`[data-export="${kind}"]`).click()]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  };
  const csv = await taken("csv");
  assert.equal(csv.name, "readings.csv");
  assert.equal(csv.bytes.toString(), await page.evaluate(() => boundfit.editor.csv()));
  const file = join(mkdtempSync(join(tmpdir(), "boundfit-taken-")), "readings.csv");
  writeFileSync(file, csv.bytes);
  const words = (await page.locator("#command").textContent()).split(" ").slice(3);
  // The path of the file, and what doubles make of least squares, differ.
  const withoutDoubles = (report) => report.replace(/\n {2}data [^]*?(?=\n {2}\S)/, "").replace(/\nin doubles[^]*?(?=\n\S|\n*$)/, "");
  assert.equal(withoutDoubles((await taken("text")).bytes.toString()), withoutDoubles(boundfit("fit", file, ...words, "--no-lp")));
  const json = JSON.parse((await taken("json")).bytes.toString());
  assert.deepEqual(json.fps, fitReport([file, ...words]).fps);
  const latex = await taken("latex");
  assert.equal(latex.name, "report.tex");
  assert.match(latex.bytes.toString(), /\\begin\{tab/);
  for (const plane of ["data", "parameter"]) {
    await checkPicture(page, `#${plane}-plane`, async (type) => (await taken(`${plane}-${type}`)).bytes);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test("readings that are too many for an address: the page says so", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  await page.evaluate(async () => {
    const sheet = structuredClone(boundfit.editor.sheet());
    let seed = 1;
    const next = () => (seed = (seed * 48271) % 2147483647);
    sheet.rows = Array.from({ length: 290 }, () => ({ cells: [0, 0].map(() => Array.from({ length: 6 }, next).join("").replace(".", "")), isFitted: true }));
    sheet.request.eps = "1e60";
    boundfit.editor.edit(sheet);
    await boundfit.editor.settled();
  });
  await page.waitForTimeout(1500);
  await page.locator("#export summary").click();
  assert.match(await page.locator("#link-note").textContent(), /too many readings for a link/);
  assert.ok(!page.url().includes("#"));
  assert.deepEqual(complaints, []);
  await close();
});

test("no accessibility rule is broken with the cells open, in light and in dark", async () => {
  const rules = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  for (const colorScheme of ["light", "dark"]) {
    const { page, close } = await opened(DATA.transducer, { colorScheme, bypassCSP: true });
    await typed(page, 20, 1, "wrong");
    await page.locator("#paste summary").click();
    await page.locator("#export summary").click();
    await page.evaluate(rules);
    const { violations } = await page.evaluate(() => window.axe.run());
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target).join("; ")}`), [], colorScheme);
    await close();
  }
});

test("the cells fit onto a phone, and do not push the pictures down", async () => {
  const { page, complaints, close } = await opened(DATA.transducer, { width: 390, height: 844 });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
  const tops = await page.evaluate(() => ["data-plane", "editor"].map((id) => document.getElementById(id).getBoundingClientRect().top));
  assert.ok(tops[0] < tops[1]);
  assert.deepEqual(complaints, []);
  await close();
});

test("a page without readings: those that are typed make the set, and all can be taken back", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  await page.locator("#start").waitFor();
  assert.ok(await cell(page, 0, 0).isVisible(), "the cells are there at once");
  await cell(page, 0, 0).focus();
  for (const [k, [x, y]] of [["1", "2,1"], ["2", "3,9"], ["3", "6,2"]].entries()) {
    await page.keyboard.type(x);
    await page.keyboard.press("Tab");
    await page.keyboard.type(y);
    await page.keyboard.press("Tab");
    await assertAsTheProgram(page);
    assert.equal(await page.locator("#data-plane [data-reading]").count(), k + 1);
    await cell(page, k + 1, 0).focus();
  }
  await page.locator("#eps").fill("0.3");
  await page.locator("#eps").press("Enter");
  await assertAsTheProgram(page);
  assert.equal(await page.locator("#kind").getAttribute("data-kind"), "polygon");
  await page.locator("#edit-back").click();
  await settled(page);
  assert.equal(await page.locator("#data-plane [data-reading]").count(), 0);
  assert.equal(await page.locator("#kind").getAttribute("data-kind"), "plane");
  assert.deepEqual(complaints, []);
  await close();
});

test("a page without readings: the example, a pasted table, a link", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  await page.locator("#edit-example").click();
  await assertAsTheProgram(page);
  assert.equal(await page.locator("#kind").getAttribute("data-kind"), "polygon");
  await page.locator("#edit-back").click();
  await settled(page);
  await page.locator("#paste-text").fill("t [s]\tU [V]\n0,1\t1,02\n0,2\t2,11\n0,3\t2,95\n");
  await page.locator("#paste-use").click();
  await page.locator('#data-plane [data-reading="3"]').waitFor();
  await assertAsTheProgram(page);
  assert.match(await page.locator("#data-plane").textContent(), /t/);
  const shown = await vertices(page);
  await page.waitForTimeout(1000);
  const other = await page.context().newPage();
  await other.goto(page.url());
  await other.locator('#data-plane [data-reading="3"]').waitFor();
  await settled(other);
  assert.deepEqual(await vertices(other), shown);
  assert.deepEqual(complaints, []);
  await close();
});

test("the cells come first for the eye and for the Tab key where there are no readings, and keep the focus when there are some", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  const order = () => page.evaluate(() => {
    const parts = ["#start", "#introduction", "#planes", ".tables"].map((own) => document.querySelector(own)).filter((own) => own.checkVisibility());
    const names = (all) => all.map((own) => own.id || own.className);
    const inText = [...parts].sort((p, q) => (p.compareDocumentPosition(q) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1));
    const seen = [...parts].sort((p, q) => p.getBoundingClientRect().top - q.getBoundingClientRect().top);
    return [names(inText), names(seen)];
  });
  const empty = ["start", "tables", "introduction", "planes"];
  assert.deepEqual(await order(), [empty, empty]);
  await typed(page, 0, 0, "1");
  await cell(page, 0, 1).focus();
  await page.keyboard.type("2");
  await page.keyboard.press("Tab");
  await settled(page);
  const full = ["introduction", "planes", "tables"];
  assert.deepEqual(await order(), [full, full]);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.fitted), "0", "the focus stays");
  // Undo stands among the pictures, which move.
  await page.locator("#undo").focus();
  await page.keyboard.press("Enter");
  await settled(page);
  assert.deepEqual(await order(), [empty, empty]);
  assert.equal(await page.evaluate(() => document.activeElement.id), "undo");
  assert.deepEqual(complaints, []);
  await close();
});

test("in every language the editor has its own words", async () => {
  const { page, complaints, close } = await opened(DATA.transducer);
  for (const [language, words] of [["de", "Messungen bearbeiten"], ["it", "Modifica le letture"], ["en", "Edit readings"]]) {
    await page.locator("#language").selectOption(language);
    assert.equal(await page.locator("#edit-toggle").textContent(), words);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test("the focus stays near a reading that was deleted", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  const count = await page.locator("[data-sheet-row]").count();
  await page.locator(`#data-plane [data-reading="${count}"]`).focus();
  await page.keyboard.press("Delete");
  await settled(page);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.reading), `${count - 1}`);
  await page.locator(`[data-delete="${count - 2}"]`).focus();
  await page.keyboard.press("Enter");
  await settled(page);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.delete), `${count - 3}`);
  assert.deepEqual(complaints, []);
  await close();
});

test("undo shows the kind of bounds that there was, whatever was chosen by hand", async () => {
  const { page, complaints, close } = await opened(LINE);
  const chosen = () => page.locator("#bounds-kind").inputValue();
  for (const kind of ["column", "eps", "column"]) {
    await page.locator("#bounds-kind").selectOption(kind);
    await settled(page);
  }
  await page.locator("#undo").click();
  await settled(page);
  assert.equal(await chosen(), "eps");
  await page.locator("#redo").click();
  await settled(page);
  assert.equal(await chosen(), "column");
  assert.deepEqual(complaints, []);
  await close();
});

test("half-planes and readings each have the address while they are shown", async () => {
  const { page, complaints, close } = await opened(LINE);
  await typed(page, 0, 1, "4.01");
  await page.waitForURL(/#ask=fit&/);
  const address = page.url();
  assert.match(address, /&table=x,y%0A2,4\.01%0A[\d.,%A]+&page\.file=/, "a short table is readable");
  await page.locator('[data-view-choice="half-planes"]').click();
  await page.waitForURL(/#view=half-planes/);
  await page.evaluate(() => {
    const sheet = boundfit.editor.sheet();
    boundfit.editor.edit({ ...sheet, request: { ...sheet.request, eps: "1/4" } });
  });
  await page.waitForFunction((before) => document.querySelector("#link").value !== before, address);
  assert.match(page.url(), /#view=half-planes/);
  await page.locator('[data-view-choice="readings"]').click();
  await page.waitForURL(/#ask=fit&/);
  assert.equal(await page.locator("#link").inputValue(), page.url());
  await page.locator('[data-view-choice="half-planes"]').click();
  await page.waitForURL(/#view=half-planes/);
  // Whoever follows a link to readings sees them.
  await page.evaluate((hash) => {
    location.hash = hash;
  }, new URL(address).hash);
  await page.locator("#data-plane").waitFor();
  await settled(page);
  assert.equal(await page.locator("#eps").inputValue(), "1/5");
  assert.deepEqual(complaints, []);
  await close();
});

test("an address that anyone has written stops nothing", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  const table = "x,y\n1,2\n";
  const packed = deflateRawSync(table.repeat(1e6)).toString("base64url");
  for (const [own, words] of [
    ["eps=1&where=theta1", /where: .*expected/],
    ['eps=["1"]', /eps: .*number as text/],
    ['eps={"a":1}', /eps: .*number as text/],
    ["eps=1&where=[[]]", /where: .*number as text/],
    ["eps=1&eps=2", /cut or changed/],
    [`eps=1&table=${packed}`, /cut or changed/],
    ["eps=1&__proto__=2", /__proto__: there is no such key/],
    ["eps=1&page.file=%00", null],
  ]) {
    const text = own.includes("table=") ? "" : `&table=${encodeURIComponent(table)}`;
    await page.evaluate((hash) => {
      location.hash = hash;
    }, `#ask=fit&x=x&y=y&${own}${text}`);
    await settled(page);
    assert.match(await page.locator("#edit-notice").textContent(), words ?? /^$/, own);
  }
  await page.locator("#edit-back").click();
  await settled(page);
  await page.locator("#edit-example").click();
  await assertAsTheProgram(page);
  assert.deepEqual(complaints, []);
  await close();
});

test("a table with a column of bounds is taken with it, and the origin of x stays", async () => {
  const { page, complaints, close } = await openLesson(browser, PLAYGROUND);
  await page.locator("#paste-text").fill("x,y,eps\n1,1,0.1\n2,2.1,0.2\n3,2.9,0.1\n");
  await page.locator("#paste-use").click();
  await page.locator('#data-plane [data-reading="3"]').waitFor();
  assert.equal(await page.locator("#bounds-kind").inputValue(), "column");
  await assertAsTheProgram(page);
  await page.locator("#paste-text").fill("x,y,note,error\n1,1,7,0.1\n2,2.1,8,0.2\n3,2.9,9,0.1\n");
  await page.locator("#edit-back").click();
  await settled(page);
  await page.locator("#paste-use").click();
  await page.locator("#import-eps_column").waitFor();
  assert.deepEqual(await page.locator("#import [data-purpose]").evaluateAll((lists) => lists.map(({ value }) => value)), ["1", "", "2", "4", "", ""]);
  await close();
  const years = await opened([...LINE, "--x-origin", "2"]);
  await years.page.evaluate(() => document.querySelector("#paste").toggleAttribute("open", true));
  await years.page.locator("#paste-text").fill("x,y\n2,4\n3,5\n4,7\n");
  await years.page.locator("#paste-use").click();
  await years.page.waitForFunction(() => boundfit.editor.sheet().rows[1].cells[0] === "3");
  await assertAsTheProgram(years.page);
  assert.match(await years.page.evaluate(() => boundfit.editor.command()), /--x-origin=2/);
  assert.deepEqual([...complaints, ...years.complaints], []);
  await years.close();
});

test("a column is the one that was chosen, also where another one has its number for a name", async () => {
  const { page, complaints, close } = await opened(LINE);
  await page.evaluate(() => document.querySelector("#paste").toggleAttribute("open", true));
  await page.locator("#paste-text").fill("time,1,2\n0,5,1\n1,6,2\n2,7,3.1\n");
  await page.locator("#paste-use").click();
  await page.locator("#import-y").selectOption("3");
  await page.locator("#import-apply").click();
  await page.waitForFunction(() => boundfit.editor.sheet().columns[1] === "2");
  await settled(page);
  assert.deepEqual(await cells(page), ["0", "1", "1", "2", "2", "3.1"]);
  await assertAsTheProgram(page);
  assert.deepEqual(complaints, []);
  await close();
});

test("columns with names of any kind: the command asks the program for the same", async () => {
  const { page, complaints, close } = await opened(SPECIAL.tooTight);
  for (const names of [["a,b", "-y"], ["2", "1"], ["#x", "y;z"], ["<b>x</b>", "\\frac"]]) {
    await page.evaluate(([x, y]) => {
      const asked = (name) => (/^\d+$/.test(name) ? `"${name}"` : name);
      const request = { ask: "fit", x: asked(x), y: asked(y), eps: "0.7" };
      boundfit.editor.edit({ ...boundfit.editor.sheet(), columns: [x, y], request });
    }, names);
    await assertAsTheProgram(page);
    assert.deepEqual(await page.evaluate(() => boundfit.editor.problem()), null);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test("a folder that is dropped cannot be read, and the page says so", async () => {
  const { page, complaints, close } = await opened(LINE);
  await page.evaluate(() => {
    const folder = new File([], "folder");
    folder.arrayBuffer = () => Promise.reject(new DOMException("no file", "NotFoundError"));
    const event = new Event("drop", { bubbles: true, cancelable: true });
    Object.defineProperty(event, "dataTransfer", { value: { files: [folder], types: ["Files"], getData: () => "" } });
    document.body.dispatchEvent(event);
  });
  await page.waitForFunction(() => /folder cannot be read/.test(document.querySelector("#edit-notice").textContent));
  assert.deepEqual(complaints, []);
  await close();
});

test("numbers that are said aloud have the decimal mark of the language", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  await page.locator("#language").selectOption("de");
  await page.locator('#data-plane [data-reading="3"]').focus();
  await page.keyboard.press("Shift+ArrowUp");
  await settled(page);
  const words = await page.locator("#status").textContent();
  assert.match(words, /Messung 3 wurde nach [\d,]+; [\d,]+ verschoben/);
  assert.deepEqual(complaints, []);
  await close();
});

test("a bound on one side has no width", async () => {
  const file = join(tmpdir(), `boundfit-one-sided-${process.pid}.csv`);
  writeFileSync(file, "x,y,low,high\n1,1,0.8,1.3\n2,2,1.9,\n3,3,2.7,3.1\n");
  const { page, complaints, close } = await opened([file, "--x", "x", "--y", "y", "--lower", "low", "--upper", "high"]);
  await page.locator("#bounds-kind").selectOption("column");
  await assertAsTheProgram(page);
  assert.equal(await cell(page, 1, 2).inputValue(), "", "not 0, which would be no error at all");
  assert.deepEqual(complaints, []);
  await close();
});

test("Enter in the last row makes one to type into, before the engine has answered", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  const count = await page.locator("[data-sheet-row]").count();
  await cell(page, count - 1, 1).focus();
  await page.keyboard.type("12.5");
  // Both in one turn of the page: the engine is still at the first.
  const focused = await page.evaluate(() => {
    document.activeElement.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true, cancelable: true }));
    return document.activeElement.dataset.cell;
  });
  assert.equal(focused, `${count} 0`);
  // Nothing was switched on or off, and nothing is said of it.
  await settled(page);
  assert.doesNotMatch(await page.locator("#status").textContent(), /All readings/);
  await assertAsTheProgram(page);
  assert.deepEqual(complaints, []);
  await close();
});

test("what is typed and taken back leaves nothing behind", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  const before = await cells(page);
  await typed(page, 0, 1, "3");
  await cell(page, 1, 1).focus();
  await page.keyboard.press("End");
  await page.keyboard.type("1");
  await page.keyboard.press("Backspace");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Control+z");
  await settled(page);
  assert.deepEqual(await cells(page), before, "undo works again");
  assert.deepEqual(complaints, []);
  await close();
});

test("while the cells have a mistake, what is moved and deleted in the picture is what is shown there", async () => {
  const { page, complaints, close } = await opened(DATA.norris);
  await typed(page, 1, 1, "");
  await typed(page, 1, 1, "abc");
  assert.equal(await page.locator("#sheet-problem").count(), 1);
  const before = await cells(page);
  // The second reading of the picture is in the third row: the second row had no number when the picture was drawn.
  await page.locator('#data-plane [data-reading="2"]').focus();
  await page.keyboard.press("Shift+ArrowUp");
  await settled(page);
  const moved = await cells(page);
  assert.deepEqual([moved[3], moved[4]], ["abc", before[4]]);
  assert.notEqual(moved[5], before[5]);
  await page.locator('#data-plane [data-reading="2"]').focus();
  await page.keyboard.press("Delete");
  await settled(page);
  assert.deepEqual((await cells(page)).slice(0, 6), [...before.slice(0, 4), ...before.slice(6, 8)]);
  assert.deepEqual(complaints, []);
  await close();
});
