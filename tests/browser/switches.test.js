// Readings switched off: one as the engine has it, several as the page computes them.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { intersection } from "../../crates/lesson/page/js/model/intersection.js";
import { Rational } from "../../crates/lesson/page/js/model/rational.js";
import { DATA, boundfit, fitReport, launch, openLesson } from "./harness.js";

let browser;

before(async () => {
  browser = await launch();
});
after(() => browser?.close());

const lines = readFileSync(new URL("../../fixtures/tables/fits.txt", import.meta.url), "utf8").trimEnd().split("\n");
const FITS = lines.filter((line) => !line.startsWith("#")).map((line) => line.split(" ").slice(1));

test("sets with each reading off are those of the engine, for every fit", () => {
  const exact = (number) => Rational.parse(typeof number === "string" ? number : number.exact);
  const kinds = new Set();
  let compared = 0;
  for (const [file, ...options] of FITS) {
    const page = boundfit("lesson", `fixtures/${file}`, ...options, "--limit", "readings=400");
    const data = JSON.parse(page.split('id="lesson-data">')[1].split("</script>")[0]);
    const sides = data.half_planes.map(({ a, b, name }, index) => ({ index, a: a.map(exact), b: exact(b), row: name.row }));
    const entries = data.leave_one_out.length > 40 ? data.leave_one_out.filter((_, k) => k % 9 === 0) : data.leave_one_out;
    for (const entry of entries) {
      const found = intersection(sides.filter(({ row }) => row === null || row !== entry.row));
      const where = `${file} ${options.join(" ")} without ${entry.row}`;
      assert.equal(found.kind, entry.kind, where);
      const vertices = entry.vertices.map((vertex) =>
        (typeof vertex === "number" ? data.points[vertex] : vertex.theta).map((value) => exact(value).toString()).join());
      assert.deepEqual(found.vertices.map((theta) => theta.join()), vertices, where);
      assert.equal(found.rays.length, entry.rays.length, where);
      assert.equal(found.lines.length, entry.lines.length, where);
      assert.equal(found.boundaries.length, entry.boundaries.length, where);
      kinds.add(found.kind);
      compared += 1;
    }
  }
  assert.ok(compared > 700 && kinds.size >= 8, `${compared} sets of ${[...kinds]}`);
});

test("any number of readings can be switched off, and each on again", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  const [header, ...rows] = readFileSync(new URL(`../../${DATA.transducer[0]}`, import.meta.url), "utf8").trimEnd().split("\n");
  const file = join(tmpdir(), `boundfit-switches-${process.pid}.csv`);
  const off = [];
  for (const row of [34, 14, 27, 24]) {
    await page.locator(`#leave-out-${row}`).uncheck();
    off.push(row);
    const left = rows.filter((_, k) => k >= 13 && k < 36 && !off.includes(k + 1));
    writeFileSync(file, [header, ...left].join("\n"));
    const { fps } = fitReport([file, "--x", "Vz", "--y", "z", "--eps", "0.5e-3"]);
    const shown = await page.locator("#parameter-plane [data-vertex]").evaluateAll((marks) =>
      marks.map(({ dataset }) => [dataset.theta1, dataset.theta2].join()));
    assert.deepEqual(shown, fps.vertices.map(({ theta }) => theta.map(({ exact }) => exact).join()), `${off}`);
    assert.equal(await page.locator("#readings input:not(:checked)").count(), off.length);
  }
  assert.match(await page.locator("#shown").textContent(), /Readings 14, 24, 27 and 34 are switched off\./);
  for (const row of off) await page.locator(`#leave-out-${row}`).check();
  assert.equal(await page.locator("body").getAttribute("data-mode"), "explore");
  assert.deepEqual(complaints, []);
  await close();
});

test("the fewest readings to leave out are those of the engine, and a button leaves them out", async () => {
  const options = ["fixtures/tables/cars.csv", "--x", "speed", "--y", "dist", "--eps", "20"];
  const { page, complaints, close } = await openLesson(browser, options);
  const told = JSON.parse(boundfit("outliers", ...options, "--format", "json"));
  await page.locator("#tab-leave-one-out").click();
  assert.match(await page.locator("#outliers").textContent(), /At least 6 readings have to be left out/);
  assert.equal(await page.locator("#outliers button").count(), told.sets.length);
  await page.locator("#outliers button").first().click();
  const off = await page.locator("#readings input:not(:checked)").evaluateAll((inputs) => inputs.map(({ dataset }) => Number(dataset.row)));
  assert.deepEqual(off, told.sets[0]);
  const shown = await page.locator("#parameter-plane [data-vertex]").evaluateAll((marks) =>
    marks.map(({ dataset }) => [dataset.theta1, dataset.theta2].join()));
  assert.deepEqual(shown, told.pieces[0].map(({ theta }) => theta.map(({ exact }) => exact).join()));
  assert.deepEqual(complaints, []);
  await close();
});

test("without a contradiction there is nothing to leave out", async () => {
  const { page, close } = await openLesson(browser, DATA.transducer);
  await page.locator("#tab-leave-one-out").click();
  assert.equal(await page.locator("#outliers").textContent(), "");
  await close();
});

test("how far an end moves is rounded up, whether one reading is off or several", async () => {
  const { page, complaints, close } = await openLesson(browser, DATA.transducer);
  const moves = async (without) => {
    await page.evaluate((rows) => boundfit.store.change({ mode: "leave-one-out", without: rows }), without);
    return page.locator("[data-moved]").evaluateAll((rows) => rows.map((row) => [row.dataset.by, row.lastElementChild.textContent]));
  };
  const { matter, idle } = await page.evaluate(() => {
    const [all, kept] = [[...boundfit.store.lesson().matters], (own) => own.map(([row]) => row)];
    return { matter: kept(all.filter(([, matters]) => matters)), idle: kept(all.filter(([, matters]) => !matters)) };
  });
  let compared = 0;
  for (const row of matter) {
    const alone = await moves([row]);
    for (const [by, text] of alone) {
      if (by === "" || by === "0") continue;
      assert.ok(Rational.parseDecimal(text.replaceAll("\u2212", "-")).compare(Rational.parse(by)) >= 0, `${text} is at least ${by}`);
    }
    for (const other of idle.slice(0, 4)) {
      const both = await moves([row, other].sort((p, q) => p - q));
      if (`${both.map(([by]) => by)}` !== `${alone.map(([by]) => by)}`) continue;
      assert.deepEqual(both, alone, `${row} and ${other}`);
      compared += 1;
    }
  }
  assert.ok(compared >= 4, `${compared}`);
  assert.deepEqual(complaints, []);
  await close();
});

test("a point is judged by the half-planes that are there: without readings switched off, and as far as clipping went", async () => {
  const file = join(tmpdir(), `boundfit-judged-${process.pid}.csv`);
  writeFileSync(file, "x,y\n1,1\n2,2\n3,5\n4,4\n");
  const { page, complaints, close } = await openLesson(browser, [file, "--x", "x", "--y", "y", "--eps", "0.1", "--where", "theta1 <= 1"]);
  /** Chooses a point with small whole numbers as its parameters. */
  const choose = (theta, changes) => page.evaluate(([own, others]) => {
    const one = boundfit.store.lesson().fps.s;
    const times = (count) => Array.from({ length: Math.abs(count) }, () => (count < 0 ? one.negated() : one)).reduce((sum, next) => sum.plus(next), one.minus(one));
    boundfit.store.change({ ...others, selection: { kind: "point", theta: own.map(times) } });
  }, [theta, changes]);
  const told = async () => {
    const place = page.locator("#violations");
    const violated = await page.locator(".reading.violated").evaluateAll((marks) => marks.map(({ dataset }) => dataset.reading).join());
    return [await place.getAttribute("data-count"), await place.textContent(), violated];
  };
  await choose([1, 0], { mode: "explore" });
  assert.deepEqual(await told(), ["1", "Not feasible: 1 of 4 readings lies farther than ε from its line: reading 3 (above).", "3"]);
  await choose([1, 0], { mode: "leave-one-out", without: [3] });
  assert.deepEqual(await told(), ["0", "Feasible without reading 3: it agrees with everything else.", ""]);
  await page.locator("#language").selectOption("de");
  assert.equal((await told())[1], "Zulässig ohne Messung 3: Er passt zu allem anderen.");
  await page.locator("#language").selectOption("it");
  assert.equal((await told())[1], "Ammissibile senza la lettura 3: è compatibile con tutto il resto.");
  await page.locator("#language").selectOption("en");
  await choose([1, 0], { mode: "leave-one-out", without: [2, 3] });
  assert.match((await told())[1], /^Feasible without readings 2 and 3:/);
  await choose([2, 0], { mode: "leave-one-out", without: [2, 3] });
  assert.deepEqual((await told()).slice(0, 2), ["2", "Not feasible: 2 of 2 readings lie farther than ε from its line: readings 1 (below) and 4 (below); it breaks theta1 <= 1."]);
  // What was not added yet cuts nothing off.
  await choose([2, 0], { mode: "clip", without: [], order: 0, step: 0 });
  assert.deepEqual(await told(), ["0", "Feasible so far: it agrees with all half-planes that were added.", ""]);
  const steps = await page.evaluate(() => boundfit.store.lesson().data.orders[0].steps.map(({ half_plane: index }) => boundfit.store.lesson().halfPlanes[index].name));
  const upper = steps.findIndex(({ row, bound }) => row === 1 && bound === "upper");
  await choose([2, 0], { mode: "clip", step: upper });
  assert.equal(steps.slice(0, upper).some(({ row, bound }) => row === 1 && bound === "lower") || (await told())[2].split(",").includes("1"), false);
  await choose([2, 0], { mode: "clip", step: upper + 1 });
  assert.ok((await told())[2].split(",").includes("1"));
  assert.deepEqual(complaints, []);
  await close();
});
