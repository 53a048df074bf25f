// Random edits: after each one the engine in the page says what the program says of the readings that the page exports, byte for byte but
// for what doubles make of them, and the page shows just that set.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { DATA, boundfit, launch, openLesson } from "./harness.js";

let browser;
const folder = mkdtempSync(join(tmpdir(), "boundfit-edits-"));

before(async () => {
  browser = await launch();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** The same numbers in every run (mulberry32). */
function chance(seed) {
  let state = seed;
  const next = () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), 1 | state);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  };
  const whole = (below) => Math.floor(next() * below);
  return { whole, one: (list) => list[whole(list.length)], number: () => NUMBERS[whole(NUMBERS.length)](next, whole) };
}

const NUMBERS = [
  (next) => (next() * 20 - 10).toFixed(2),
  (next) => (next() * 20 - 10).toFixed(1).replace(".", ","),
  (next, whole) => `${whole(9) - 4}`,
  (next, whole) => `${whole(19) - 9}/${1 + whole(9)}`,
  (next, whole) => `${whole(90) + 10}e${whole(13) - 6}`,
  () => "0",
  () => "1e40",
  () => "-3e-40",
];
const BOUNDS = ["0.5", "2", "1/3", "0", "2*min", "min", "10%*|y|+0.5", "+1/-0.25", "1e50", "5"];
const CONDITIONS = [undefined, undefined, ["theta1 >= 0"], ["theta1 <= 1", "theta2 >= -2"], ["theta1 >= 1", "theta1 <= 0"], ["theta1 + theta2 = 1"]];

const START = {
  transducer: DATA.transducer,
  regressors: DATA.twoRegressors,
  bounds: DATA.steamGenerator,
  intervals: ["fixtures/reduction/intervals.csv", "--x", "t", "--lower", "earliest", "--upper", "latest"],
  strip: ["fixtures/claims/strip.csv", "--x", "x", "--y", "y", "--eps", "0.2"],
};

/** Another sheet: one edit as a reader makes it. */
function edited(sheet, { whole, one, number }) {
  const next = structuredClone(sheet);
  const { rows, columns, request } = next;
  const at = whole(rows.length);
  const keys = ["x", "y", "eps_column", "lower", "upper"];
  const roles = columns.map((name) => keys.find((key) => [request[key]].flat().includes(name)));
  const column = (role) => roles.indexOf(role);
  const cellFor = (role) => (role === "eps_column" ? one(["0.5", "0", "1/4", "3"]) : number());
  const edits = [
    () => { const k = whole(columns.length); rows[at].cells[k] = cellFor(roles[k]); },
    () => { const k = whole(columns.length); rows[at].cells[k] = cellFor(roles[k]); },
    () => rows.push({ cells: roles.map(cellFor), isFitted: true }),
    () => rows.push(structuredClone(rows[at])),
    () => { if (rows.length > 1) rows.splice(at, 1); },
    () => { rows[at].isFitted = !rows[at].isFitted || rows.filter((row) => row.isFitted).length === 1; },
    () => { if (request.eps !== undefined) request.eps = one(BOUNDS); },
    () => { const where = one(CONDITIONS); if (where) request.where = where; else delete request.where; },
    () => { if (column("x") === 0 && roles[1] !== "x") { if (request.through_origin) delete request.through_origin; else request.through_origin = true; } },
    // All at one place: vertical strips.
    () => { if (whole(3) === 0) rows.forEach((row) => { row.cells[0] = rows[at].cells[0]; }); },
    // One reading alone.
    () => { if (whole(4) === 0) rows.splice(0, rows.length, rows[at]); },
    () => {
      if (column("lower") < 0 || column("upper") < 0) return;
      const [low, high] = [whole(9), whole(9)].sort((p, q) => p - q);
      const open = whole(3);
      rows[at].cells[column("lower")] = open === 1 ? "" : `${low}`;
      rows[at].cells[column("upper")] = open === 2 ? "" : `${high}`;
    },
  ];
  one(edits)();
  return next;
}

/** The bytes of a report without what doubles make of least squares, which is the platform's. */
const withoutDoubles = (report) => {
  const part = /\n {4}"binary64": (\{\}|\{\n[^]*?\n {4}\})/;
  assert.equal(part.test(report), !report.includes('\n  "least_squares": null'));
  return report.replace(part, "");
};

for (const [name, options] of Object.entries(START)) {
  test(`${name}: 50 random edits, each as the program has it`, async () => {
    const random = chance(name.length * 7919 + 18);
    const { page, complaints, close } = await openLesson(browser, options);
    const file = join(folder, "readings.csv");
    const kinds = new Set();
    let refused = 0;
    let sheet = await page.evaluate(() => boundfit.editor.sheet());
    for (let made = 0; made < 50; made += 1) {
      const next = edited(sheet, random);
      const answer = await page.evaluate(async ([own, file]) => {
        boundfit.editor.edit(own);
        await boundfit.editor.settled();
        const problem = boundfit.editor.problem();
        if (problem !== null) {
          boundfit.editor.undo();
          await boundfit.editor.settled();
          return { problem, csv: boundfit.editor.csvOf(own) };
        }
        const [csv, asked] = [boundfit.editor.csv(), boundfit.editor.request()];
        const report = await boundfit.engine.ask("run", csv, { ...asked, file });
        const vertices = [...document.querySelectorAll("#parameter-plane [data-vertex]")].map(({ dataset }) => [dataset.theta1, dataset.theta2].join());
        return { problem, csv, command: boundfit.editor.command(), report, vertices, kind: document.querySelector("#parameter-plane").dataset.kind };
      }, [next, file]);
      if (answer.problem !== null) {
        refused += 1;
        continue;
      }
      sheet = next;
      writeFileSync(file, answer.csv);
      const words = [...answer.command.matchAll(/'([^']*)'|(\S+)/g)].map(([, quoted, plain]) => quoted ?? plain).slice(3);
      const told = boundfit("fit", file, ...words, "--format", "json");
      const where = `${name}, edit ${made + 1}: ${answer.command}\n${answer.csv}`;
      assert.equal(withoutDoubles(answer.report), withoutDoubles(told), where);
      const { fps } = JSON.parse(told);
      assert.equal(answer.kind, fps.kind, where);
      assert.deepEqual(answer.vertices.sort(), fps.vertices.map(({ theta }) => theta.map(({ exact }) => exact).join()).sort(), where);
      kinds.add(fps.kind);
    }
    assert.ok(refused <= 10, `${refused} refused`);
    assert.ok(kinds.size >= 2, `${[...kinds]}`);
    assert.deepEqual(complaints, []);
    await close();
  });
}
