// The worst acceptable lines: laid by hand with mouse, finger and keys, and judged against the readings themselves.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { Rational, decimalPower } from "../../crates/lesson/page/js/model/rational.js";
import { DATA, fitReport, launch, openLesson } from "./harness.js";

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

const CURRENT = ["fixtures/worst-line/current.csv", "--x", "U", "--y", "I"];

/** The readings of a file as fractions; the columns are those of the options of `boundfit`. */
function readingsOf([file, , x, , y], from = 1, to = Infinity) {
  const lines = readFileSync(new URL(`../../${file}`, import.meta.url), "utf8").trimEnd().split("\n").map((line) => line.split(","));
  const columns = [x, y].map((name) => lines[0].indexOf(name));
  return lines.slice(1).map((cells, k) => ({ row: k + 1, place: columns.map((column) => Rational.parseDecimal(cells[column])) }))
    .filter(({ row }) => row >= from && row <= to);
}

/** The lines by hand as the table has them. */
function byHand(page) {
  return page.locator("[data-by-hand]").evaluateAll((rows) =>
    rows.map(({ dataset, textContent }) => ({ ...dataset, words: textContent })));
}

/** The rows that a line misses, from the readings alone. */
function missed(readings, { theta1, theta2 }, epsilon) {
  const [slope, start] = [theta1, theta2].map((text) => Rational.parse(text));
  return readings.filter(({ place: [x, y] }) => slope.times(x).plus(start).minus(y).absolute().compare(epsilon) > 0).map(({ row }) => row);
}

function agreesWithReadings(lines, readings, epsilon) {
  for (const line of lines) {
    const rows = missed(readings, line, epsilon);
    assert.equal(line.passes, `${rows.length === 0}`, line.words);
    if (rows.length === 0) continue;
    const told = line.words.match(/misses readings? (.+?),? by/)[1].match(/\d+/g).map(Number);
    // Of many the first twelve are named, and the others counted.
    const expected = rows.length > 12 ? [...rows.slice(0, 12), rows.length - 12] : rows;
    assert.deepEqual(told, expected, line.words);
  }
}

test("lines by hand begin corner to corner and follow the mouse", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  const readings = readingsOf(DATA.transducer, 14, 36);
  const epsilon = Rational.parseDecimal("0.5e-3");
  await page.locator("#tab-worst-line").click();
  const [steepest, shallowest] = await byHand(page);
  const at = (k, up) => readings.at(k).place[1].plus(up ? epsilon : epsilon.negated());
  const run = readings.at(-1).place[0].minus(readings[0].place[0]);
  assert.equal(steepest.theta1, at(-1, true).minus(at(0, false)).over(run).toString());
  assert.equal(shallowest.theta1, at(-1, false).minus(at(0, true)).over(run).toString());
  agreesWithReadings([steepest, shallowest], readings, epsilon);
  for (const [name, side, dy] of [["steepest", 0, 40], ["steepest", 1, -60], ["shallowest", 1, 25], ["shallowest", 0, -10], ["steepest", 1, 400]]) {
    const handle = page.locator(`[data-handle="${name}"][data-side="${side}"]`);
    await handle.scrollIntoViewIfNeeded();
    const box = await handle.locator(".hit").boundingBox();
    const before = await handle.getAttribute("data-height");
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 + dy, { steps: 3 });
    await page.mouse.up();
    const after = Rational.parse(await handle.getAttribute("data-height"));
    assert.equal(after.compare(Rational.parse(before)) < 0, dy > 0, "down is less");
    // Few decimals, whatever the pixel.
    assert.ok(after.times(decimalPower(8)).denominator === 1n, after.toString());
    agreesWithReadings(await byHand(page), readings, epsilon);
  }
  await page.locator("#worst-reset").click();
  assert.equal((await byHand(page))[0].theta1, steepest.theta1);
  assert.deepEqual(complaints, []);
  await close();
});

test("the exact lines are withheld until asked for, and are those of the program", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  await page.locator("#tab-worst-line").click();
  for (const answer of [".corridor", "#shown-section", ".region.fill"]) assert.equal(await page.locator(answer).first().isVisible(), false, answer);
  assert.equal(await page.locator("[data-exact-line]").count(), 0);
  // Bars that shape the set would say where the lines must touch.
  const looks = () => page.locator(".reading .bar").evaluateAll((bars) => new Set(bars.map((bar) => getComputedStyle(bar).stroke + getComputedStyle(bar).strokeWidth)).size);
  assert.equal(await page.locator(".reading .end").first().isVisible(), false);
  assert.equal(await looks(), 1);
  await page.locator("#worst-exact").click();
  assert.equal(await page.locator(".corridor").isVisible(), true);
  assert.equal(await looks(), 2);
  const { pui, fps } = fitReport(DATA.transducer);
  const exact = await page.locator("#worst-lines-table [data-exact]").evaluateAll((rows) =>
    rows.map((row) => [...row.querySelectorAll("td.number")].map((cell) => cell.title)));
  assert.deepEqual(exact.map(([slope]) => slope), [pui[0].upper.exact, pui[0].lower.exact]);
  const vertices = fps.vertices.map(({ theta }) => theta.map(({ exact: value }) => value).join());
  for (const line of exact) assert.ok(vertices.includes(line.join()), `${line}`);
  assert.equal(await page.locator("[data-exact-line]").count(), 2);
  assert.match(await page.locator("#worst-result").textContent(), /Exactly, the slope is between 0\.00179\d* and 0\.00184\d*/);
  assert.deepEqual(complaints, []);
  await close();
});

test("is there any line? not for the course's current before 263/80 mA", async () => {
  const { page, complaints, close } = await openLesson(browser, [...CURRENT, "--eps", "1.5"]);
  await page.locator("#tab-worst-line").click();
  assert.doesNotMatch(await page.locator("#worst-sentence").textContent(), /No line/);
  agreesWithReadings(await byHand(page), readingsOf(CURRENT), Rational.parseDecimal("1.5"));
  await page.locator("#worst-exact").click();
  assert.match(await page.locator("#worst-sentence").textContent(), /No line passes through all error bars.* ε is 3\.2875 \(exactly 263\/80\)/);
  assert.deepEqual(complaints, []);
  await close();
});

/** Three readings on the line y = x, corner to corner from slope 9/10 to 11/10, with conditions. */
function straight(...conditions) {
  const file = join(tmpdir(), `boundfit-worst-${process.pid}.csv`);
  writeFileSync(file, "x,y\n1,1\n2,2\n3,3\n");
  return [file, "--x", "x", "--y", "y", "--eps", "0.1", ...conditions.flatMap((condition) => ["--where", condition])];
}

/** What the tab says in three languages once the exact lines are shown: the sentence, and all below. */
async function told(page) {
  await page.locator("#tab-worst-line").click();
  await page.locator("#worst-exact").click();
  const words = {};
  for (const language of ["en", "de", "it"]) {
    await page.locator("#language").selectOption(language);
    words[language] = [await page.locator("#worst-sentence").textContent(), await page.locator("#worst-line-story").textContent()];
  }
  await page.locator("#language").selectOption("en");
  return words;
}

test("a line through all bars that breaks a condition is told so, in every language", async () => {
  const { page, complaints, close } = await openLesson(browser, straight("theta1 <= 1"));
  const { en, de, it } = await told(page);
  assert.match((await byHand(page))[0].words, /breaks condition 1/);
  assert.match(en[0], /until both pass through all error bars and keep condition 1,/);
  assert.match(en[1], /too steep by 0\.1: no line through all bars that keeps condition 1 is like that/);
  assert.match(en[1], /not a result yet: a line breaks condition 1\./);
  assert.doesNotMatch(en[1], /contradicts a reading/);
  assert.match(en[1], /No line through all bars that keeps condition 1 is shallower/);
  assert.match(de[1], /So steil ist keine Gerade durch alle Balken, die Bedingung 1 erfüllt/);
  assert.match(it[1], /nessuna retta per tutte le barre che soddisfa la condizione 1 è così ripida/);
  assert.deepEqual(complaints, []);
  await close();
});

test("an empty set is laid to the bars only where they contradict each other", async () => {
  const cases = [
    [straight("theta1 >= 2"), /^No line that keeps condition 1 passes through all error bars: any line that is drawn misses one or breaks a condition\./],
    [straight("theta1 >= 1", "theta1 <= 0"), /^No line keeps conditions 1 and 2 together/],
    [[...CURRENT, "--eps", "1.5", "--where", "theta1 >= 0"], /^No line passes through all error bars: .* The first one that keeps condition 1 appears when ε is/],
  ];
  for (const [options, sentence] of cases) {
    const { page, complaints, close } = await openLesson(browser, options);
    const { en, de, it } = await told(page);
    assert.match(en[0], sentence);
    assert.ok(sentence.source.includes("through all error bars: .*") || /Bedingung/.test(de[0]) && /condizion/.test(it[0]));
    assert.deepEqual(complaints, []);
    await close();
  }
});

test("a line as steep as the steepest that misses a bar is not called less steep by 0", async () => {
  const { page, complaints, close } = await openLesson(browser, straight());
  await page.locator("#tab-worst-line").click();
  for (const side of [0, 1]) {
    await page.locator(`[data-handle="steepest"][data-side="${side}"]`).focus();
    await page.keyboard.press("PageUp");
  }
  const { en, de, it } = await told(page);
  assert.match(en[1], /as steep as the steepest one, but it misses readings 2 and 3/);
  assert.match(de[1], /so steil wie die steilste, aber sie verfehlt die Messungen 2 und 3/);
  assert.match(it[1], /ha la pendenza della più ripida, ma manca le letture 2 e 3/);
  for (const [, story] of [en, de, it]) assert.doesNotMatch(story, /by 0\.(?!\d)|um 0 |di 0 /);
  assert.deepEqual(complaints, []);
  await close();
});

test("one line through all bars is the steepest and the shallowest one", async () => {
  const { page, complaints, close } = await openLesson(browser, [...CURRENT, "--eps", "263/80"]);
  await page.locator("#tab-worst-line").click();
  await page.locator("#worst-exact").click();
  const slopes = await page.locator("#worst-lines-table [data-exact] td.number").evaluateAll((cells) => cells.map(({ title }) => title));
  assert.equal(slopes[0], slopes[2]);
  assert.equal(slopes[0], fitReport([...CURRENT, "--eps", "263/80"]).pui[0].lower.exact);
  assert.deepEqual(complaints, []);
  await close();
});

test("arrow keys move a handle, and the live region says what it misses", async () => {
  const { page, complaints, close } = await openLesson(browser, [...CURRENT, "--eps", "4"]);
  await page.locator("#tab-worst-line").click();
  const handle = page.locator('[data-handle="shallowest"][data-side="1"]');
  await handle.focus();
  const heights = [await handle.getAttribute("data-height")];
  for (const key of ["ArrowUp", "PageUp", "Shift+ArrowUp", "ArrowDown"]) {
    await page.keyboard.press(key);
    heights.push(await handle.getAttribute("data-height"));
    agreesWithReadings(await byHand(page), readingsOf(CURRENT), Rational.parseDecimal("4"));
  }
  const moved = heights.slice(1).map((height, k) => Rational.parse(height).compare(Rational.parse(heights[k])));
  assert.deepEqual(moved.map(Math.sign), [1, 1, 1, -1]);
  assert.match(await page.locator("#status").textContent(), /shallow, by hand: (passes|misses)/);
  assert.ok(await handle.evaluate((item) => item === document.activeElement), "the focus stays");
  assert.deepEqual(complaints, []);
  await close();
});

test("a finger drags a handle without moving the page", async () => {
  const { page, complaints, close } = await openLesson(browser, [...CURRENT, "--eps", "4"], { width: 390, height: 844, hasTouch: true });
  await page.locator("#tab-worst-line").tap();
  const handle = page.locator('[data-handle="steepest"][data-side="1"]');
  await handle.scrollIntoViewIfNeeded();
  const box = await handle.locator(".hit").boundingBox();
  assert.ok(box.width >= 24 && box.height >= 24, "large enough for a finger");
  const before = await handle.getAttribute("data-height");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const session = await page.context().newCDPSession(page);
  const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  const scrolled = await page.evaluate(() => scrollY);
  await touch("touchStart", [{ x, y }]);
  for (const dy of [10, 25, 40]) await touch("touchMove", [{ x, y: y + dy }]);
  await touch("touchEnd", []);
  assert.notEqual(await handle.getAttribute("data-height"), before);
  assert.equal(await page.evaluate(() => scrollY), scrolled);
  assert.deepEqual(complaints, []);
  await close();
});

test("two regressors and readings at one place have no such lines, and say so", async () => {
  for (const options of [DATA.twoRegressors, DATA.strip]) {
    const { page, complaints, close } = await openLesson(browser, options);
    await page.locator("#tab-worst-line").click();
    assert.match(await page.locator("#worst-sentence").textContent(), /at two different places at least/);
    assert.equal(await page.locator("[data-handle]").count(), 0);
    assert.equal(await page.locator("#worst-exact").isDisabled(), true);
    assert.deepEqual(complaints, []);
    await close();
  }
});

test("what worst lines withhold in the pictures of the readings is there among the half-planes, and withheld still afterwards", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  await page.locator("#tab-worst-line").click();
  const shown = (selector) => page.locator(selector).first().evaluate((part) => getComputedStyle(part).display !== "none");
  assert.equal(await shown("#parameter-plane .region"), false);
  await page.locator('[data-view-choice="half-planes"]').click();
  await page.locator("#half-plane-picture .region").first().waitFor({ state: "attached" });
  assert.equal(await shown("#half-plane-picture .region"), true);
  await page.locator('[data-view-choice="readings"]').click();
  assert.equal(await shown("#parameter-plane .region"), false);
  await page.locator("#tab-explore").click();
  assert.equal(await shown("#parameter-plane .region"), true);
  assert.deepEqual(complaints, []);
  await close();
});

test("where all lines fall, the steepest one has the least slope", async () => {
  const file = join(tmpdir(), `boundfit-falling-${process.pid}.csv`);
  writeFileSync(file, "x,y\n-3,5\n-2,3.1\n-1,0.9\n0,-1.2\n");
  const options = [file, "--x", "x", "--y", "y", "--eps", "0.3"];
  const { page, complaints, close } = await openLesson(browser, options);
  const { en } = await told(page);
  const { pui } = fitReport(options);
  const slopes = await page.locator("#worst-lines-table [data-exact]").evaluateAll((rows) =>
    rows.map((row) => [row.dataset.exact, row.querySelector("td.number").title]));
  assert.deepEqual(slopes, [["steepest", pui[0].lower.exact], ["shallowest", pui[0].upper.exact]]);
  const [steep, shallow] = (await byHand(page)).map(({ theta1 }) => Rational.parse(theta1));
  assert.ok(steep.compare(shallow) < 0);
  assert.doesNotMatch(en[1], /The steep line is the shallower one|± [-−]/);
  assert.deepEqual(complaints, []);
  await close();
});
