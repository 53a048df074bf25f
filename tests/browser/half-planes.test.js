// The second view of the page: half-planes without readings, with mouse, touch and keyboard.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, afterEach, before, test } from "node:test";

import { exercisesOf, rightAnswer } from "../../crates/lesson/page/js/polytope/exercises.js";
import { DATA, checkPicture, fraction, launch, openLesson } from "./harness.js";

const SQUARE = "x >= 0\ny >= 0\nx <= 4\ny <= 4";
const TABS = ["set", "clip", "objective", "simplex", "exercises"];

let browser;
let opened;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());
afterEach(async () => {
  assert.deepEqual(opened.complaints, []);
  await opened.close();
});

/** The view of half-planes with a text, as a reader comes to it. */
async function open(text, tab = "set", context = {}) {
  opened = await openLesson(browser, DATA.strip, { width: 1280, height: 800, ...context });
  const { page } = opened;
  await page.locator('[data-view-choice="half-planes"]').click();
  if (text !== null) await type(page, text);
  await page.locator(`#plane-tab-${tab}`).click();
  return page;
}

/** Types half-planes, and waits for what the engine says of them. */
async function type(page, text) {
  await page.locator("#plane-text").fill(text);
  await settled(page);
}

/** Waits until the picture shows what the engine answers about the text. */
async function settled(page) {
  await page.evaluate(() => boundfit.engine.ask("polytope", "", {}));
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

const text = (page) => page.locator("#plane-text").inputValue();
const corners = (page) => page.locator("#half-plane-picture [data-corner]").evaluateAll((marks) => marks.map(({ dataset }) => [dataset.theta1, dataset.theta2]));
const kind = (page) => page.locator("#half-plane-picture").getAttribute("data-kind");
const ask = (page, words, options = {}) => page.evaluate(async ([half, own]) => JSON.parse(await boundfit.engine.ask("polytope", half, own)), [words, options]);
const sentence = (page) => page.locator("#plane-sentence").textContent();

/** The pixel of a point of the plane, from the marks of two corners of SQUARE. */
async function pixel(page, [x, y]) {
  const at = async (theta1, theta2) => {
    const box = await page.locator(`[data-theta1="${theta1}"][data-theta2="${theta2}"] .dot`).boundingBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  const [from, to] = [await at("0", "0"), await at("4", "0")];
  const unit = (to[0] - from[0]) / 4;
  return [from[0] + x * unit, from[1] - y * unit];
}

async function drag(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await page.mouse.move(...to);
  await page.mouse.up();
  await settled(page);
}

test("what is typed is drawn as the engine says, and what cannot be read is named beside its line", async () => {
  const page = await open(SQUARE);
  const { set } = await ask(page, SQUARE);
  assert.deepEqual(await corners(page), set.vertices.map(({ theta }) => theta));
  assert.equal(await kind(page), "polygon");
  await type(page, `${SQUARE}\nx < 3\n\n2x + <= 1`);
  const note = (line) => page.locator(`[data-note-line="${line}"]`).textContent();
  assert.match(await note(5), /≤ or ≥/);
  assert.match(await note(7), /Expected a number.*character 6/);
  assert.match(await page.locator("#plane-status").textContent(), /Line 5.*Line 7/);
  assert.equal(await page.locator("#plane-text").getAttribute("aria-invalid"), "true");
  // The picture keeps what it had.
  assert.deepEqual(await corners(page), set.vertices.map(({ theta }) => theta));
  await type(page, `${SQUARE}\nx + y <= 9,5`);
  assert.equal(await note(5), "redundant");
  await type(page, "x<=1\n".repeat(61));
  assert.match(await page.locator("#plane-refused").textContent(), /61 half-planes are too many/);
  // The refusal says what becomes of the picture, and follows the language.
  const before = await corners(page);
  for (const [language, words] of [
    ["en", "61 half-planes are too many for a picture, which has at most 60; an equation counts twice. The picture keeps the set before."],
    ["de", "61 Halbebenen sind zu viele für ein Bild, das höchstens 60 hat; eine Gleichung zählt doppelt. Das Bild behält die Menge von vorher."],
    ["it", "61 semipiani sono troppi per una figura, che ne ha al massimo 60; un’equazione conta doppio. La figura mantiene l’insieme di prima."],
  ]) {
    await page.locator("#language").selectOption(language);
    assert.equal(await page.locator("#plane-refused").textContent(), words);
  }
  assert.deepEqual(await corners(page), before);
});

test("a narrow screen is as wide as the view, and cells of the simplex table are one line", async () => {
  const page = await open(null, "set", { width: 360, height: 640 });
  for (const language of ["de", "it", "en"]) {
    await page.locator("#language").selectOption(language);
    for (const tab of TABS) {
      await page.locator(`#plane-tab-${tab}`).click();
      await settled(page);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 360, `${language} ${tab}`);
      if (tab !== "simplex") continue;
      await page.locator("#plane-last").click();
      const lines = await page.locator("#simplex-table td").evaluateAll((all) => all.map((cell) => {
        const range = document.createRange();
        range.selectNodeContents(cell);
        return new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size;
      }));
      assert.ok(lines.length > 5 && lines.every((count) => count <= 1), `${language}: ${lines}`);
      await page.locator("#plane-first").click();
    }
  }
});

test("decimals of half-planes have the mark of the language, wherever they are said", async () => {
  const page = await open("0,5x + y <= 2,5\nx >= 0\ny >= 0");
  await page.locator("#language").selectOption("de");
  await page.locator('[data-plane-line="0"]').focus();
  await page.keyboard.press("Enter");
  assert.match(await page.locator("#plane-chosen").textContent(), /0,5x \+ y <= 2,5/);
  assert.match(await page.locator('[data-plane-line="0"]').getAttribute("aria-label"), /0,5x \+ y <= 2,5/);
  await page.locator("#plane-tab-clip").click();
  await page.locator("#plane-forward").click();
  assert.match(await sentence(page), /0,5x \+ y <= 2,5/);
});

test("one of a thing is said as one: a vertex, a ray, a proof", async () => {
  const page = await open("x >= 0\ny >= 0", "clip");
  await page.locator("#plane-last").click();
  assert.match(await sentence(page), /New vertex: \(0; 0\)|New vertex: \(0, 0\)/);
  await type(page, "x >= 0\ny = 0");
  await page.locator("#plane-tab-set").click();
  assert.match(await page.locator("#plane-story").textContent(), /in the direction \(/);
  await page.locator("#language").selectOption("de");
  assert.match(await page.locator("#plane-story").textContent(), /in der Richtung \(/);
  await page.locator("#language").selectOption("en");
  await type(page, "x >= 0\ny >= 0");
  assert.match(await page.locator("#plane-story").textContent(), /in the directions \(.*\) and \(/);
  // One proof, to which 0 <= 0 can be added any number of times.
  await type(page, "x = 1\ny <= 2\ny >= 0");
  await page.locator("#plane-tab-objective").click();
  await page.locator("#objective-1").fill("0");
  await page.locator("#objective-2").fill("1");
  await settled(page);
  const ways = page.locator("#objective-ways");
  assert.deepEqual([await ways.getAttribute("data-count"), await ways.getAttribute("data-unique")], ["1", "false"]);
  assert.equal(await ways.textContent(), "The multipliers are not unique: half-planes that add up to 0 ≤ 0 can be added to them.");
});

test("a line is drawn, moved, turned, flipped and deleted with the mouse", async () => {
  const page = await open(SQUARE);
  await drag(page, await pixel(page, [3, 1.5]), await pixel(page, [1, 3.5]));
  // What lies on the left of the way stays.
  assert.equal(await text(page), `${SQUARE}\nx + y <= 9/2`);
  assert.ok((await corners(page)).some((own) => `${own}` === "4,1/2"));
  await drag(page, await pixel(page, [2.5, 2]), await pixel(page, [2, 1]));
  assert.equal(await text(page), `${SQUARE}\nx + y <= 3`);
  const handle = await page.locator('[data-turn="0"]').boundingBox();
  const before = await text(page);
  await drag(page, [handle.x + 9, handle.y + 9], [handle.x + 60, handle.y + 30]);
  const turned = (await text(page)).split("\n")[4];
  assert.notEqual(turned, before.split("\n")[4]);
  const { half_planes } = await ask(page, turned);
  assert.notDeepEqual(half_planes[0].a, ["1", "1"]);
  await page.locator("#plane-flip").click();
  await settled(page);
  const flipped = (await ask(page, (await text(page)).split("\n")[4])).half_planes[0];
  assert.deepEqual(flipped.a.map((own) => fraction(own).toString()), half_planes[0].a.map((own) => fraction("0").minus(fraction(own)).toString()));
  await page.locator("#plane-delete").click();
  await settled(page);
  assert.equal(await text(page), SQUARE);
  assert.equal(await page.locator("#plane-delete").isDisabled(), true);
});

test("a finger draws a line after the button, and scrolls without it", async () => {
  const page = await open(SQUARE, "set", { hasTouch: true });
  const session = await page.context().newCDPSession(page);
  const swipe = async (from, to) => {
    const touch = (type, point) => session.send("Input.dispatchTouchEvent", { type, touchPoints: point ? [{ x: point[0], y: point[1] }] : [] });
    await touch("touchStart", from);
    await touch("touchMove", [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
    await touch("touchMove", to);
    await touch("touchEnd");
    await settled(page);
  };
  const [from, to] = [await pixel(page, [3, 1.5]), await pixel(page, [1, 3.5])];
  await swipe(from, to);
  assert.equal(await text(page), SQUARE);
  await page.evaluate(() => scrollTo(0, 0));
  await page.locator("#plane-draw").click();
  await swipe(await pixel(page, [3, 1.5]), await pixel(page, [1, 3.5]));
  assert.equal(await text(page), `${SQUARE}\nx + y <= 9/2`);
  assert.equal(await page.locator("#plane-draw").getAttribute("aria-pressed"), "false");
});

test("keys move, turn, flip, choose and delete lines, and add one", async () => {
  const page = await open(SQUARE);
  await page.locator('[data-plane-line="2"]').focus();
  await page.keyboard.press("ArrowRight");
  await settled(page);
  const moved = (await text(page)).split("\n")[2];
  assert.match(moved, /^x <= (4\.|\d+\/\d+|[5-9])/);
  await page.keyboard.press("ArrowLeft");
  await settled(page);
  assert.equal(await text(page), SQUARE);
  await page.keyboard.press("Shift+ArrowUp");
  await settled(page);
  assert.match((await text(page)).split("\n")[2], /y/);
  await page.locator("#plane-text").fill(SQUARE);
  await settled(page);
  await page.locator('[data-plane-line="0"]').focus();
  await page.keyboard.press("PageDown");
  await page.keyboard.press("f");
  await settled(page);
  assert.equal((await text(page)).split("\n")[1], "y <= 0");
  assert.equal(await kind(page), "unbounded-polygon");
  await page.keyboard.press("Delete");
  await settled(page);
  assert.equal(await text(page), "x >= 0\nx <= 4\ny <= 4");
  assert.equal(await kind(page), "unbounded-polygon");
  await page.locator("#plane-add").press("Enter");
  await settled(page);
  assert.equal((await text(page)).split("\n").length, 4);
});

test("every step of clipping is the engine's", async () => {
  const words = "x >= 0\ny >= 0\nx + 2y <= 8\nx + y <= 9\n3x + y <= 9\nx <= -1\nx <= 7";
  const page = await open(words, "clip");
  const { steps } = await ask(page, words);
  assert.equal(await kind(page), "plane");
  for (const step of steps) {
    await page.locator("#plane-forward").click();
    assert.equal(await kind(page), step.set.kind);
    assert.deepEqual(await corners(page), step.set.vertices.map(({ theta }) => theta));
    const said = await sentence(page);
    if (step.redundant?.why === "dominated") assert.match(said, /is redundant/);
    if (step.set.kind === "empty" && step.redundant === null) assert.match(said, /0 ≤ −1, which is false/);
  }
  assert.ok(await page.locator("#plane-forward").isDisabled());
  await page.locator("#plane-first").click();
  assert.equal(await kind(page), "plane");
});

/** The multiples of half-planes that the page shows add up to the objective. */
async function checkProof(page, words, form) {
  const { half_planes, objective } = await ask(page, words, { objective: form });
  const proof = JSON.parse(await page.locator("#objective-proof").getAttribute("data-proof"));
  const total = [0, 1].map((k) => proof.reduce((sum, { half_plane, multiplier }) => sum.plus(fraction(half_planes[half_plane].a[k]).times(fraction(multiplier))), fraction("0")).toString());
  assert.deepEqual(total, form);
  const right = proof.reduce((sum, { half_plane, multiplier }) => sum.plus(fraction(half_planes[half_plane].b).times(fraction(multiplier))), fraction("0"));
  assert.equal(right.toString(), objective.value);
  return objective;
}

test("the objective is typed, dragged and moved by keys, and its multipliers prove it", async () => {
  const words = "x >= 0\ny >= 0\nx + 2y <= 8\n3x + y <= 9";
  const page = await open(words, "objective");
  const objective = () => page.locator("#objective-arrow").evaluate(({ dataset }) => [dataset.c1, dataset.c2]);
  await page.locator("#objective-1").fill("1/2");
  await page.locator("#objective-2").fill("1,5");
  await settled(page);
  assert.deepEqual(await objective(), ["1/2", "3/2"]);
  await checkProof(page, words, ["1/2", "3/2"]);
  await page.locator("#objective-1").fill("?");
  assert.equal(await page.locator("#objective-1").getAttribute("aria-invalid"), "true");
  await page.locator("#objective-1").fill("3");
  await page.locator("#objective-2").fill("1");
  await settled(page);
  assert.match(await sentence(page), /along the edge between/);
  await checkProof(page, words, ["3", "1"]);
  const grip = await page.locator("#objective-arrow .hit").boundingBox();
  const from = [grip.x + grip.width / 2, grip.y + grip.height / 2];
  await drag(page, from, [from[0] - 90, from[1] - 20]);
  const dragged = await objective();
  assert.ok(Number(dragged[0]) < 0 && Number(dragged[1]) > 0, dragged.join());
  const { face } = await checkProof(page, words, dragged);
  assert.match(await sentence(page), new RegExp(`\\(${face.points[0].join(", ").replaceAll("-", "−")}\\)`));
  await page.locator("#objective-arrow").focus();
  await page.keyboard.press("ArrowUp");
  await settled(page);
  assert.deepEqual(await objective(), [dragged[0], `${Number(dragged[1]) + 1}`]);
  await page.locator("#objective-turn").click();
  await settled(page);
  await checkProof(page, words, await objective());
  // Normal cones: one for each vertex, and the arrow in that of the best one.
  assert.equal(await page.locator("#normal-cones path").count(), 4);
  assert.ok((await page.locator("#normal-cones .best").count()) >= 1);
});

test("degenerate, unbounded, empty and flat sets are said in words", async () => {
  const page = await open("x >= 0\ny >= 0\nx + y <= 4\nx <= 4\nx - y <= 4", "objective");
  assert.match(await page.locator("#objective-ways").textContent(), /not unique/);
  await page.locator("#plane-tab-set").click();
  assert.match(await sentence(page), /One vertex is degenerate/);
  const kinds = { degenerate: "polygon", unbounded: "unbounded-polygon", empty: "empty", point: "point", segment: "segment", strip: "strip" };
  for (const [example, expected] of Object.entries(kinds)) {
    await page.locator("#plane-example").selectOption(example);
    await settled(page);
    assert.equal(await kind(page), expected);
  }
  await page.locator("#plane-example").selectOption("empty");
  await settled(page);
  assert.match(await sentence(page), /The set is empty: .*·\(\d\).* says 0 ≤ −\d/);
  await page.locator("#plane-tab-simplex").click();
  assert.match(await sentence(page), /no vertex to start from/);
  await page.locator("#plane-tab-set").click();
  await page.locator("#plane-example").selectOption("unbounded");
  await settled(page);
  await page.locator("#plane-tab-objective").click();
  await page.locator("#objective-1").fill("1");
  await page.locator("#objective-2").fill("0");
  await settled(page);
  assert.match(await sentence(page), /has no maximum.*for ever in the direction/);
  await page.locator("#plane-tab-simplex").click();
  await page.locator("#plane-last").click().catch(() => undefined);
  assert.match(await sentence(page), /no half-plane bounds the direction/);
});

test("the simplex path is walked basis by basis, from the vertex that is clicked", async () => {
  const words = "x >= 0\ny >= 0\nx - y <= 0\nx <= 4\ny <= 6";
  const page = await open(words, "simplex");
  await page.locator("#objective-1").fill("1");
  await page.locator("#objective-2").fill("0");
  await settled(page);
  const { simplex } = await ask(page, words, { objective: ["1", "0"] });
  assert.ok(simplex.bases.some(({ pivot }) => pivot?.degenerate));
  const rows = () => page.locator("#simplex-table [data-basis]").evaluateAll((list) => list.map(({ dataset }) => [dataset.basis, dataset.degenerate]));
  for (let k = 0; k < simplex.bases.length; k += 1) {
    assert.deepEqual(await rows(), simplex.bases.slice(0, k + 1).map(({ half_planes, pivot }) => [half_planes.join(" "), `${pivot?.degenerate ?? false}`]));
    if (k + 1 < simplex.bases.length) await page.locator("#plane-forward").click();
  }
  assert.match(await sentence(page), /this is the maximum/);
  await page.locator('[data-theta1="0"][data-theta2="6"] .hit').click();
  await settled(page);
  assert.match(await sentence(page), /^At \(0, 6\)/);
  await page.locator('[data-theta1="0"][data-theta2="0"]').focus();
  await page.keyboard.press("Enter");
  await settled(page);
  assert.match(await sentence(page), /^At \(0, 0\)/);
});

test("all ten exercises take the right answer only, with hints and an explanation", async () => {
  const page = await open(null, "exercises");
  await page.locator("#exercise-seed").fill("class 3b");
  await page.locator("#exercise-seed").press("Enter");
  for (const exercise of exercisesOf("class 3b")) {
    await page.locator(`[data-exercise="${exercise.number - 1}"]`).click();
    assert.equal(await page.locator("#exercise-title").getAttribute("data-exercise-id"), exercise.id);
    const verdict = () => page.locator("#exercise-verdict").getAttribute("data-right");
    const fill = async (answers) => {
      for (const [k, answer] of answers.entries()) {
        const field = page.locator(`#answer-${exercise.number}-${k}`);
        if ("choice" in exercise.answer) await field.selectOption(answer);
        else await field.fill(answer);
      }
      await page.locator("#exercise-check").click();
    };
    const right = rightAnswer(exercise);
    await fill("choice" in exercise.answer ? [exercise.answer.choices.find((own) => own !== right[0])] : right.map((own) => fraction(own).plus(fraction("1/7")).toString()));
    assert.equal(await verdict(), "false", exercise.id);
    assert.equal(await page.locator("#half-plane-picture").getAttribute("data-kind"), "");
    for (const number of [1, 2]) {
      await page.locator("#exercise-hint").click();
      assert.equal(await page.locator("#exercise-hints li").count(), number);
    }
    assert.ok(await page.locator("#exercise-hint").isDisabled());
    await fill(right);
    assert.equal(await verdict(), "true", exercise.id);
    assert.match(await page.locator("#plane-status").textContent(), /Right/);
    await page.locator("#exercise-explain").click();
    assert.ok(((await page.locator("#exercise-why").textContent()) ?? "").length > 40);
  }
  assert.equal(await page.locator("#exercise-list .right").count(), 10);
  await page.waitForURL(/seed=class\+3b/);
});

test("the sheet for the class has no answers, and that for the teacher has all", async () => {
  const page = await open(null, "exercises");
  await page.evaluate(() => {
    window.print = () => undefined;
  });
  await page.locator("#exercise-seed").fill("7");
  await page.locator("#exercise-seed").press("Enter");
  await page.emulateMedia({ media: "print" });
  const visible = () => page.locator("#exercise-sheet").evaluate((sheet) => sheet.innerText);
  await page.evaluate(() => document.getElementById("print-questions").click());
  const questions = await visible();
  assert.equal(await page.locator("[data-sheet-exercise]").count(), 10);
  assert.equal(await page.locator("[data-answer]").count(), 0);
  assert.match(questions, /Seed: 7\./);
  assert.ok(await page.locator("#half-plane-picture").isHidden());
  await page.evaluate(() => document.getElementById("print-answers").click());
  const given = await page.locator("[data-answer]").evaluateAll((list) => list.map(({ dataset }) => dataset.answer));
  assert.deepEqual(given, exercisesOf("7").map((exercise) => rightAnswer(exercise).join("; ")));
});

test("the address of the page brings everything back", async () => {
  const page = await open("x + y <= 3\nx >= 0\ny >= 0", "objective");
  await page.locator("#objective-1").fill("5");
  await settled(page);
  await page.waitForURL(/c=5/);
  const address = page.url();
  await page.goto("about:blank");
  await page.goto(address);
  await settled(page);
  assert.equal(await page.locator("body").getAttribute("data-view"), "half-planes");
  assert.equal(await text(page), "x + y <= 3\nx >= 0\ny >= 0");
  assert.match(await sentence(page), /The maximum of 5x \+ y is 15/);
  await page.locator('[data-view-choice="readings"]').click();
  assert.ok(await page.locator("#data-plane").isVisible());
  assert.ok(await page.locator("#half-plane-picture").isHidden());
});

test("no rule of accessibility is broken in any tab, theme and language, and no key is shown for a text", async () => {
  const rules = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  const page = await open(null, "set");
  await page.evaluate(rules);
  for (const language of ["en", "it", "de"]) {
    await page.locator("#language").selectOption(language);
    if (language !== "en") await page.locator("#theme-toggle").click();
    for (const tab of TABS) {
      await page.locator(`#plane-tab-${tab}`).click();
      await settled(page);
      if (tab === "exercises" && language !== "de") await page.locator("#exercise-hint").click();
      const { violations } = await page.evaluate(() => window.axe.run());
      assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), [], `${language} ${tab}`);
      assert.doesNotMatch(await page.locator("#half-planes").evaluate((view) => view.innerText), /polytope\./);
    }
  }
});

test("nothing sticks out on a phone", async () => {
  const page = await open(null, "set", { width: 390, height: 844 });
  for (const tab of TABS) {
    await page.locator(`#plane-tab-${tab}`).click();
    await settled(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), tab);
  }
});

test("a line is moved where it stands in the text, whatever else cannot be read", async () => {
  const page = await open(SQUARE);
  await type(page, `what is this\n${SQUARE}`);
  await page.locator('[data-plane-line="0"]').focus();
  await page.keyboard.press("ArrowLeft");
  await settled(page);
  const lines = (await text(page)).split("\n");
  assert.equal(lines[0], "what is this");
  assert.match(lines[1], /^x >= -/);
  assert.deepEqual(lines.slice(2), SQUARE.split("\n").slice(1));
  await type(page, `what is this\n${SQUARE}`);
  await page.locator('[data-plane-line="3"]').focus();
  await page.keyboard.press("Delete");
  await settled(page);
  assert.equal(await text(page), `what is this\n${SQUARE.split("\n").slice(0, 3).join("\n")}`);
});

test("a line that is turned by keys turns by a few degrees, and its numbers stay short", async () => {
  const page = await open(SQUARE);
  await page.locator('[data-plane-line="2"]').focus();
  let before = [1, 0];
  for (let turn = 1; turn <= 18; turn += 1) {
    await page.keyboard.press("Shift+ArrowUp");
    await settled(page);
    const { half_planes } = await ask(page, (await text(page)).split("\n")[2]);
    const [x, y] = half_planes[0].a.map(Number);
    const degrees = (Math.atan2(before[0] * y - before[1] * x, before[0] * x + before[1] * y) * 180) / Math.PI;
    assert.ok(degrees > 0 && degrees < 10, `turn ${turn}: ${degrees}`);
    assert.ok(Math.max(Math.abs(x), Math.abs(y)) <= 20);
    before = [x, y];
  }
  assert.deepEqual(before, [0, 1]);
});

test("what is cancelled draws nothing, and a line that is deleted leaves the focus with another one", async () => {
  const page = await open(SQUARE);
  const [from, to] = [await pixel(page, [1, 1]), await pixel(page, [3, 2])];
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to);
  await page.locator("#half-plane-picture").dispatchEvent("pointercancel");
  await page.mouse.up();
  await settled(page);
  assert.equal(await text(page), SQUARE);
  assert.equal(await page.locator("#line-being-drawn").getAttribute("d"), "");
  await page.locator('[data-plane-line="3"]').focus();
  await page.keyboard.press("Delete");
  await settled(page);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.planeLine), "2");
});

test("an exercise tells its answer to nobody before it is solved", async () => {
  const page = await open(null, "exercises");
  await page.locator("#exercise-seed").fill("class 3b");
  await page.locator("#exercise-seed").press("Enter");
  await page.locator('[data-exercise="0"]').click();
  await settled(page);
  const spoken = () => page.locator("#half-plane-picture [data-plane-line]").evaluateAll((lines) => lines.map((line) => line.ariaLabel).join());
  assert.doesNotMatch(await spoken(), /redundant/);
  await page.locator("#exercise-explain").click();
  assert.match(await spoken(), /redundant/);
});

test("a rounded decimal is said to be one", async () => {
  const page = await open("3x <= 1\nx >= 0\ny >= 0\ny <= 1", "objective");
  await page.locator("#objective-1").fill("1");
  await page.locator("#objective-2").fill("0");
  await settled(page);
  assert.match(await sentence(page), /1\/3 ≈ 0\.33333/);
  await page.locator("#objective-2").fill("1/2");
  await settled(page);
  assert.match(await sentence(page), /5\/6 ≈ 0\.83333/);
  await page.locator("#plane-text").fill("4x <= 1\nx >= 0\ny >= 0\ny <= 1");
  await settled(page);
  assert.match(await sentence(page), /3\/4 = 0\.75/);
});

test("sets far from 0 are drawn, and can be drawn into", async () => {
  const far = "100000000000000000000";
  const page = await open(`x >= ${far}\nx <= ${far.slice(0, -1)}1\ny >= 0\ny <= 1`);
  assert.equal(await page.locator("[data-corner]").count(), 4);
  assert.doesNotMatch(await page.locator("#half-plane-picture").innerHTML(), /NaN|Infinity/);
  const box = await page.locator("#half-plane-picture").boundingBox();
  await drag(page, [box.x + 200, box.y + 100], [box.x + 260, box.y + 160]);
  assert.equal((await text(page)).split("\n").length, 5);
});

test("the picture can be taken away from every tab, as a file that needs nothing of the page", async () => {
  const page = await open("x >= 0\ny >= 0\nx + 2y <= 8\n3x + y <= 9\nx + y <= 7");
  const taken = async (type) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`[data-plane-picture="${type}"]`).click()]);
    assert.equal(download.suggestedFilename(), `half-planes.${type}`);
    return readFileSync(await download.path());
  };
  for (const tab of TABS) {
    await page.locator(`#plane-tab-${tab}`).click();
    if (["clip", "simplex"].includes(tab)) await page.locator("#plane-last").click();
    await settled(page);
    const svg = await checkPicture(page, "#half-plane-picture", taken);
    assert.ok(!/transparent|rgba\(0, 0, 0, 0\)/.test(svg), `${tab}: what hands take hold of is left out`);
    assert.ok(tab !== "objective" || svg.includes("marker-end"), "the objective is an arrow");
  }
});
