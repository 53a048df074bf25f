// Asks the module and the program the same, in Node without packages: `node wasm/test.mjs`. BOUNDFIT_PROGRAM names the program,
// otherwise it is that of `cargo build --release`; BOUNDFIT_ENGINE the folder of the module and its JavaScript, otherwise it is that
// of the lesson.
//
// All must be equal byte for byte, but for what is said of least squares in doubles: that is the rounded answer of a library, whose
// last digit is the platform's (it differs in one fit in eight).

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

import { tableOf } from "../crates/lesson/page/js/model/table.js";

const root = fileURLToPath(new URL("..", import.meta.url));
const fixtures = join(root, "fixtures");
const program = process.env.BOUNDFIT_PROGRAM ?? join(root, "target/release/boundfit");
const engine = resolve(process.env.BOUNDFIT_ENGINE ?? join(root, "crates/lesson/engine"));
const { columns, lesson, polytope, run, start } = await import(pathToFileURL(join(engine, "boundfit.mjs")).href);
const exports = await start(readFileSync(join(engine, "boundfit_wasm.wasm.gz")));

const flags = ["through-origin", "no-eui", "exact", "units-row"];
const repeated = ["where", "where-row"];

/** The rows `1..22,24` of the program. */
const rowsOf = (text) =>
  text.split(",").map((part) => {
    if (!part.includes("..")) return Number(part);
    const [first, last] = part.split("..");
    return [Number(first || 1), last === "" ? null : Number(last)];
  });

/** The arguments of the program as options. */
const optionsOf = ([file, ...asked]) => {
  const options = file === "-" ? {} : { file };
  for (let at = 0; at < asked.length; at += 1) {
    const name = asked[at].replace("--", "");
    const key = name.replaceAll("-", "_");
    if (flags.includes(name)) {
      options[key] = true;
      continue;
    }
    at += 1;
    const value = asked[at];
    if (repeated.includes(name)) options[key] = [...(options[key] ?? []), value];
    else if (name === "rows" || name === "without") options[key] = rowsOf(value);
    else if (name === "digits" || name === "skip-lines") options[key] = Number(value);
    else if (name === "x" && value.includes(",")) options[key] = value.split(",");
    else options[key] = value;
  }
  return options;
};

const ask = (args, input) => spawnSync(program, ["fit", ...args], { cwd: fixtures, encoding: "utf8", input });

/** JSON without the doubles, which are there where least squares are. */
const withoutDoubles = (json) => {
  const part = /\n {4}"binary64": (\{\}|\{\n[^]*?\n {4}\})/;
  assert.equal(part.test(json), !json.includes('\n  "least_squares": null'));
  return json.replace(part, "");
};

/** Text without the lines about doubles, and without the commands of the program that an empty set names. */
const withoutDoubleLines = (text) =>
  text.replace(/\nin doubles[^]*?(?=\n\S|\n*$)/, "").replace(/\nNext steps, with the same data\n(?: {2}.*\n)+/, "");

/** The ways out that the program names, in its options and in keys. */
const keysOf = (ways) =>
  ways
    .replace(/--limit ([a-z]+)=N/g, (_, name) => (name === "readings" ? "max_readings: N" : `limits: {"${name}": N}`))
    .replace(/--([a-z-]+)(?: ('[^']*'|[^ ]+))?(?= (?:chooses|leaves|passes|reads|says|takes)\b)/g, (_, option, value) => {
      const text = value === undefined ? "true" : option === "skip-lines" ? value : JSON.stringify(value.replaceAll("'", ""));
      return `${option.replaceAll("-", "_")}: ${text}`;
    });

/** Whether an error says what the program does, each with its own way out. */
const saysAs = (stderr) => {
  // A page has a button for what a lesson's limit leaves to the program's options.
  const [, sentence, ways = ""] = stderr.replace(/; choose some with --rows [^;\n]*/, "").match(/^error: ([^]*?)(; --[a-z][^)]*)?\n$/);
  return ({ message }) => {
    assert.equal(message, sentence + keysOf(ways));
    assert.doesNotMatch(message, /--/);
    return true;
  };
};

/** Compares what module and program say of a table, in all three formats. */
const compare = (statuses, args, table, input) => {
  const options = optionsOf(args);
  const json = ask([...args, "--format", "json"], input);
  assert.ok(statuses.includes(json.status), `${args}: ${json.stderr}`);
  if (json.status === 1) {
    assert.throws(() => run(table, options), saysAs(json.stderr), json.stderr);
    return;
  }
  assert.equal(withoutDoubles(run(table, options)), withoutDoubles(json.stdout));
  const folder = mkdtempSync(join(tmpdir(), "boundfit-"));
  try {
    const proof = join(folder, "proof.json");
    const text = ask([...args, "--no-lp", "--proof", proof], input);
    if (text.status === json.status) {
      assert.equal(run(table, { ...options, format: "proof" }), readFileSync(proof, "utf8"));
    } else {
      assert.throws(() => run(table, { ...options, format: "proof" }), /a proof is about the rows of plain delimited text/);
    }
    const alone = ask([...args, "--no-lp"], input).stdout;
    assert.equal(withoutDoubleLines(run(table, { ...options, format: "text" })), withoutDoubleLines(alone));
  } finally {
    rmSync(folder, { recursive: true });
  }
};

const linesOf = (path) => readFileSync(path, "utf8").split("\n").filter((line) => line !== "" && !line.startsWith("#"));

/** A lesson without what is rounded, what float LP solvers answer, and the question about them. */
const withoutRounded = (document) => {
  const { binary64, ...leastSquares } = document.fit.least_squares ?? { binary64: {} };
  assert.equal(typeof binary64, "object");
  return {
    ...document,
    fit: { ...document.fit, least_squares: document.fit.least_squares && leastSquares },
    layers: { ...document.layers, lp: document.layers.lp.filter(({ source }) => source.startsWith("exact-simplex")) },
    questions: document.questions.filter(({ id }) => id !== "solvers-right"),
  };
};

/** The lesson without what tells the table from the one that the page writes. */
const withoutFile = (document) => {
  const { sha256, rows_total, selection, rows_missing, table, fractions, ...input } = document.fit.input;
  // Files of MATLAB have no cells, the page's table has.
  const readings = (own) => own.map(({ cells, ...reading }) => reading);
  return { ...document, readings: readings(document.readings), others: readings(document.others), fit: { ...document.fit, input } };
};

const ofReport = ["no-eui", "exact", "digits", "rounding"];

/** The arguments without those of a report. */
const ofReadings = (args) =>
  args.filter((arg, at) => !ofReport.some((name) => arg === `--${name}` || (args[at - 1] === `--${name}` && !flags.includes(name))));

/** Compares what module and program show of readings in a lesson, and what the module shows of the page's own table. */
const compareLessons = (args, table, input) => {
  const own = ofReadings(args);
  const options = optionsOf(own);
  const page = spawnSync(program, ["lesson", ...own], { cwd: fixtures, encoding: "utf8", input, maxBuffer: 1 << 28 });
  if (args[0] === "bad-input/header-only.csv") {
    // A page may have no readings yet, a file that is fitted has some.
    assert.equal(page.status, 1);
    assert.deepEqual(JSON.parse(lesson(table, options)).readings, []);
    return;
  }
  if (page.status === 1) {
    assert.throws(() => lesson(table, options), saysAs(page.stderr), page.stderr);
    return;
  }
  const expected = JSON.parse(page.stdout.match(/id="lesson-data">([^\n]*)<\/script>/)[1]);
  const found = JSON.parse(lesson(table, options));
  assert.equal(JSON.stringify(withoutRounded(found)), JSON.stringify(withoutRounded(expected)));
  const again = JSON.parse(lesson(tableOf(expected), expected.asked));
  assert.equal(JSON.stringify(withoutFile(withoutRounded(again))), JSON.stringify(withoutFile(withoutRounded(expected))));
  expected.readings.forEach(({ cells }, at) => assert.deepEqual(cells ?? again.readings[at].cells, again.readings[at].cells));
};

const fits = [...linesOf(join(fixtures, "tables/fits.txt")), ...linesOf(new URL("fits.txt", import.meta.url))].map((line) =>
  line.replace(/ --[xy]-unit \S+/g, ""),
);

/** An answer, or why there is none. */
const said = (answer) => {
  try {
    return answer();
  } catch (error) {
    assert.ok(error.refusal, `${error}`);
    return error.message;
  }
};

/** Files whose readers the module leaves out. */
const isLeftOut = (file) => file.endsWith(".mat");

for (const line of fits) {
  const [status, ...args] = line.split(" ");
  if (isLeftOut(args[0])) {
    test(line, () => {
      const table = readFileSync(join(fixtures, args[0]));
      for (const answer of [run, lesson]) {
        assert.throws(() => answer(table, optionsOf(args)), /: this is a MATLAB file; this build has no reader of it /);
      }
    });
    continue;
  }
  test(line, () => compare([Number(status)], args, readFileSync(join(fixtures, args[0]))));
  test(`lesson: ${line}`, () => compareLessons(args, readFileSync(join(fixtures, args[0]))));
}

test("what is packed, or Octave's, is refused by its name", () => {
  const asked = { x: "x", y: "y", eps: "1", file: "data" };
  const refused = (table, words) => assert.throws(() => run(table, asked), { message: `data: this is ${words}` });
  refused(gzipSync("x,y\n1,2\n"), "a gzip file; this build unpacks nothing (feature packed); unpack it first");
  const octave = readFileSync(join(fixtures, "foreign/octave/vectors.txt"));
  refused(octave, "what Octave's save -text writes; this build has no reader of it (feature matlab); save a matrix of it as CSV");
});

test("a hundred tables made at random", () => {
  // mulberry32: the same tables in every run.
  let state = 20261122;
  const random = (below) => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) % below;
  };
  const number = () => `${random(2) === 0 ? "-" : ""}${random(20)}${random(3) === 0 ? "" : `.${random(1000)}`}`;
  const bounds = ["1/3", "0.25", "0", "2*min", "5%*|y| + 0.1", "written"];
  const conditions = ["theta1 >= 0", "2*theta1 - theta2 <= 1/3", "theta2 = 1"];
  for (let round = 0; round < 100; round += 1) {
    const rows = Array.from({ length: 1 + random(30) }, () => [number(), number(), number()].join(";"));
    const table = `x;u;y\n${rows.join("\n")}\n`;
    const args = ["-", "--x", random(3) === 0 ? "x,u" : "x", "--y", "y", "--eps", bounds[random(bounds.length)]];
    if (random(3) === 0) args.push("--where", conditions[random(conditions.length)]);
    compare([0, 3], args, table, table);
    if (round % 5 === 0) compareLessons(args, table, table);
  }
});

test("rows keep the numbers that they are given", () => {
  const table = "x,y\n1,1\n2,3\n3,2\n4,4\n";
  const asked = { x: "x", y: "y", eps: "1", row_numbers: [3, [7, 8], 20] };
  assert.deepEqual(JSON.parse(lesson(table, asked)).readings.map(({ row }) => row), [3, 7, 8, 20]);
  const some = JSON.parse(lesson(table, { ...asked, rows: [[4, 8]] }));
  assert.deepEqual(some.readings.map(({ row }) => row), [7, 8]);
  assert.deepEqual(some.others.map(({ row }) => row), [3, 20]);
  assert.deepEqual(some.asked.rows, [[7, 8]]);
  assert.deepEqual(some.asked.row_numbers, [[3, 3], [7, 8], [20, 20]]);
  const report = JSON.parse(run(table, { ...asked, without: [3, [20, null]] }));
  assert.equal(report.input.selection.without, "3,20..");
  assert.ok(report.fps.vertices.every(({ active }) => active.every(({ row }) => [7, 8].includes(row))));
  const refused = (more, expected) => assert.throws(() => lesson(table, { ...asked, ...more }), { message: expected });
  refused({ row_numbers: [[1, 3]] }, "row_numbers: 3 numbers for a table of 4 rows");
  refused({ row_numbers: [4, 3, 5, 6] }, /^row_numbers: expected rows from 1, ascending, such as 5 and \[14, 36\]/);
  refused({ row_numbers: [[1, null]] }, /^row_numbers: expected rows from 1, ascending/);
  refused({ rows: [[4, 6]] }, "rows: none of them is left");
  assert.throws(() => run(table, { ...asked, format: "proof" }), /^Error: row_numbers: a proof is about the rows of a table as they stand/);
});

test("a lesson about no readings yet", () => {
  const asked = [
    { x: "x", y: "y", eps: "2*min" },
    { x: "x", y: "y", eps: "1%*|y|" },
    { x: ["x", "u"], y: "y", eps_column: "e" },
    { x: "x", lower: "low", upper: "high", where: ["theta1 >= 0"] },
  ];
  for (const options of asked) {
    const found = JSON.parse(lesson("x,u,y,e,low,high\n", options));
    assert.deepEqual(found.readings, []);
    assert.equal(found.fit.fps.kind, options.where ? "half-plane" : "plane");
    assert.deepEqual(JSON.parse(lesson(tableOf(found), found.asked)).asked, found.asked);
  }
  assert.throws(() => run("x,y\n", asked[0]), { message: /^standard input: / });
});

test("columns of tables in any form", () => {
  const found = (table, options = {}) => {
    const { columns: names, header } = JSON.parse(columns(table, options));
    return { columns: names, header };
  };
  assert.deepEqual(found("V;z\n1,5;2\n"), { columns: ["V", "z"], header: true });
  assert.deepEqual(found("1 2\n3 4\n"), { columns: ["col1", "col2"], header: false });
  assert.deepEqual(found("# made by hand\nV [mV],I\n1,2\n"), { columns: ["V [mV]", "I"], header: true });
  assert.deepEqual(found("a,,b\n1,2,3\n"), { columns: ["a", "col2", "b"], header: true });
  assert.deepEqual(found("a|b\n1|2\n", { delimiter: "comma" }).columns.length, 1);
  assert.deepEqual(found("1,2\n3,4\n", { header: "yes" }), { columns: ["1", "2"], header: true });
  const told = JSON.parse(columns("name;U;I\na;1;2,50\nb;x;\n", {}));
  assert.deepEqual(told.numeric, [false, true, true], "a column with a wrong cell has numbers too");
  assert.deepEqual([told.table.decimal, told.table.delimiter, told.table.header.line], ["comma", "semicolon", 1]);
  const records = '{"x":0,"y":0.1},{"x":1,"y":1}';
  for (const table of [`[${records}]`, records.replace("},", "}\n")]) {
    const found = JSON.parse(columns(table, {}));
    assert.deepEqual([found.columns, found.header, found.numeric], [["x", "y"], true, [true, true]]);
  }
  const arrays = JSON.parse(columns("[[0,0.1],[1,1]]", {}));
  assert.deepEqual([arrays.columns, arrays.header], [["col1", "col2"], false]);
  assert.throws(() => columns("", {}), /^Error: standard input: /);
  assert.throws(() => columns("a,b\n", { x: "a" }), /^Error: x: there is no such key \(expected one of file, reading, header, /);
});

test("a report in LaTeX", () => {
  const asked = ["--x", "x", "--y", "y", "--eps", "1/3"];
  const report = ask(["-", ...asked, "--no-lp", "--format", "latex"], "x,y\n1,2\n2,3\n").stdout;
  assert.match(report, /tabular/);
  const withoutDoubles = (text) => text.replace(/^.*in doubles[^]*?\n\n/m, "");
  assert.equal(withoutDoubles(run("x,y\n1,2\n2,3\n", { x: "x", y: "y", eps: "1/3", format: "latex" })), withoutDoubles(report));
});

test("whatever is asked of a lesson, it is answered or refused", () => {
  let state = 7;
  const random = (below) => {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    return (state >>> 8) % below;
  };
  const seeds = ["x,y\n1,2\n2,3\n3,5\n", "x;u;y\n1,5;2;1e400\n-3;4;0,1\n", "x y eps\n1 1 1\n2 2 1/3\n"];
  const pieces = ["1e9999", "-", "/0", "\n", ";", ",", "nan", '"', "\u0000", "9".repeat(9000), "1/3", "\ufeff", " ", "#"];
  const asked = [
    { x: "x", y: "y", eps: "1" },
    { x: ["x", "u"], y: "y", eps: "2*min" },
    { x: "1", y: "2", eps_column: "3" },
    { x: "1", lower: "2", where: ["theta1 >= 0"] },
    { x: "1", y: "2", eps: `1e-${"9".repeat(4)}`, reading: "binary64" },
    { x: "1", y: "2", eps: "written", rows: [[2, 9999999]], max_readings: 2000 },
    { x: "1", y: "2", eps: "1", row_numbers: [[1, 4294967295]] },
    { x: "1", y: "2", eps: "1", row_numbers: [[5, 4294967294]], rows: [[1, null]] },
  ];
  let answered = 0;
  for (let round = 0; round < 600; round += 1) {
    let table = seeds[random(seeds.length)];
    for (let change = random(4); change > 0; change -= 1) {
      const at = random(table.length + 1);
      table = table.slice(0, at) + pieces[random(pieces.length)] + table.slice(at + random(3));
    }
    try {
      JSON.parse(lesson(table, asked[random(asked.length)]));
      answered += 1;
    } catch (error) {
      assert.ok(error instanceof Error && !(error instanceof WebAssembly.RuntimeError || error instanceof RangeError), `${JSON.stringify(table.slice(0, 200))}: ${error}`);
    }
  }
  assert.ok(answered > 50, `${answered} answers`);
});

test("a lesson has the limits of the program", () => {
  const long = Array.from({ length: 30 }, (_, row) => `${row},${"7".repeat(6000)}${row}`).join("\n");
  const asked = { x: "x", y: "y", eps: "1" };
  const table = `x,y\n${long}\n`;
  const { stderr } = spawnSync(program, ["lesson", "-", "--x", "x", "--y", "y", "--eps", "1"], { encoding: "utf8", input: table });
  assert.match(stderr, /^error: standard input: .*products of machine words/);
  assert.throws(() => lesson(table, asked), saysAs(stderr));
  const rows = `x,y\n${"1,2\n".repeat(301)}`;
  assert.throws(() => lesson(rows, asked), { message: "standard input: more than 300 readings are too many for a lesson" });
  assert.equal(JSON.parse(lesson(rows, { ...asked, max_readings: 301 })).asked.max_readings, 301);
  assert.throws(() => lesson(rows, { ...asked, max_readings: 2001 }), { message: "max_readings: expected a number from 1 to 2000" });
  assert.throws(() => lesson(rows, { ...asked, digits: 3 }), { message: "digits is about a report, and this is a lesson" });
  assert.throws(() => run(rows, { ...asked, title: "t" }), { message: "title is about a lesson, and this is a report" });
});

test("options that are wrong are refused by name", () => {
  const refused = (options, expected) => assert.throws(() => run("x,y\n1,2\n", options), { message: expected });
  const whole = { x: "x", y: "y", eps: "1" };
  refused({ ...whole, epsilon: "1" }, /^request: unknown field `epsilon`, expected one of `no_eui`, .*; every question has file, .*, x, y, eps, /);
  assert.throws(() => lesson("x,y\n1,2\n", { ...whole, epsilon: "1" }), /^Error: epsilon: there is no such key \(expected one of file, .*, x, y, eps, /);
  refused({ ...whole, esp: "1" }, /, limits; did you mean eps\?$/);
  refused({ ...whole, no_eiu: true }, /; did you mean no_eui\?$/);
  refused({ ...whole, temperature: "1" }, /, limits$/);
  assert.throws(() => lesson("x,y\n1,2\n", { ...whole, titel: "t" }), /; did you mean title\?$/);
  refused({ y: "y", eps: "1" }, "x is missing: it names the column of x, or those of two regressors");
  refused({ ...whole, eps: 1.5 }, /^eps: (expected )?a number as text, or {"exact": "1\/3"}/);
  refused({ ...whole, x: 1 }, /^x: expected the name or number of a column as text, or an array of two of these/);
  refused({ ...whole, x: " " }, 'x: " ": expected a header name or a column number');
  refused({ x: "x", eps: "1" }, "y is missing: only beside lower or upper it may be left out");
  refused({ x: "x", y: "y" }, "the bound on the errors is missing: eps, eps_column, lower or upper");
  refused({ ...whole, x_eps: "1", x_eps_column: "y" }, "the errors of x have one bound: x_eps or x_eps_column");
  refused({ ...whole, strong: true }, "strong is about errors in x: say how large they may be with x_eps or x_eps_column");
  refused({ ...whole, lower: "y" }, "the errors have one bound: eps, or eps_column, or lower and upper");
  refused({ ...whole, eps: "1,5" }, /^eps: "1,5": /);
  refused({ ...whole, x: ["x", "y"], eps: "1%*|x|" }, /^eps: "1%\*\|x\|": two regressors have no \|x\|/);
  refused({ ...whole, x: ["x", "y"], through_origin: true }, /^through_origin is about a line: with two regressors there is no offset/);
  refused({ ...whole, x_origin: "a" }, /^x_origin: "a": /);
  refused({ ...whole, where: ["theta3 > 0"] }, /^where: "theta3 > 0": /);
  refused({ ...whole, where_row: ["x ~ 0"] }, /^where_row: "x ~ 0": /);
  refused({ ...whole, rows: [0] }, 'rows: "0": rows are counted from 1, and the first comes before the last');
  refused({ ...whole, rows: ["1..2"] }, /^rows: expected rows from 1 such as 5, \[14, 36\]/);
  refused({ ...whole, rows: "2..1" }, /^rows: "2..1": expected rows from 1 such as 14..36/);
  refused({ ...whole, without: [[1, null]] }, 'without: "1..": no row is left');
  refused({ ...whole, missing: "drop" }, 'missing: "drop": expected one of "refuse", "skip"');
  refused({ ...whole, format: "pdf" }, 'format: "pdf": expected one of "text", "latex", "markdown", "json", "csv", "wkt", "vertices", "m", "ine", "ext", "sarif", "junit", "proof"');
  refused({ ...whole, ask: "rnge" }, /^ask: "rnge": expected one of /);
  refused({ ...whole, ask: "range", most: 1 }, /^request: unknown field `most`/);
  refused({ ...whole, ask: "range", by: "y" }, 'by: "y": expected x or row');
  refused({ ...whole, delimiter: ";" }, /^delimiter: ";": expected one of "comma", "semicolon", "tab", "space", "pipe"/);
  refused({ ...whole, decimal: "comma", thousands: "," }, /^thousands and decimal name one mark/);
  refused({ ...whole, comment: "ab" }, /^comment: "ab": expected auto, none or one character/);
  refused({ ...whole, limits: { digit: 1 } }, /^limits: "digit": expected one of "digits", "exponent", /);
  refused({ ...whole, limits: { digits: 0 } }, 'limits: "0": no value of the limit digits (expected an integer from 1 to 1000000)');
  for (const digits of [0, 1001, 70000, 3.5, -1, "3"]) {
    refused({ ...whole, digits }, `digits: ${JSON.stringify(digits)}: expected an integer from 1 to 1000`);
  }
  refused({ ...whole, eps: `1e${"9".repeat(9)}` }, /^eps: "1e9+": refused: .*; limits: {"exponent": N} raises it$/);
});

test("options that a format has no place for are refused as by the program", () => {
  const table = "x,y\n0,0\n1,1.5\n2,2\n";
  const asked = { x: "x", y: "y", eps: "1/2" };
  for (const [command, args, options] of [
    ["fit", ["--format", "csv", "--digits", "3"], { format: "csv", digits: 3 }],
    ["fit", ["--format", "csv", "--exact"], { format: "csv", exact: true }],
    ["fit", ["--format", "csv", "--sweep", "1..2"], { format: "csv", sweep: "1..2" }],
    ["fit", ["--format", "wkt", "--confidence", "0.9"], { format: "wkt", confidence: "0.9" }],
    ["fit", ["--format", "json", "--brief"], { brief: true }],
    ["status", ["--format", "csv", "--repair"], { ask: "status", format: "csv", repair: true }],
    ["status", ["--format", "json", "--all"], { ask: "status", all: true }],
    ["predict", ["--at", "1", "--format", "json", "--proofs"], { ask: "predict", at: ["1"], proofs: true }],
    ["outliers", ["--format", "csv", "--most", "1"], { ask: "outliers", format: "csv", most: 1 }],
  ]) {
    const own = ["-", "--x", "x", "--y", "y", "--eps", "1/2", ...args];
    const { status, stderr } = spawnSync(program, [command, ...own], { encoding: "utf8", input: table });
    assert.equal(status, 2, `${command} ${args}`);
    const [, words] = stderr.match(/^error: ([^\n]*)\n/);
    assert.throws(() => run(table, { ...asked, ...options }), { message: words.replace(/'--([a-z-]+)'/g, "$1") });
  }
  const brief = { ...asked, format: "text", brief: true };
  assert.throws(() => run(table, { ...brief, full: true }), { message: /^brief reports ten lines: it goes with none of full, sweep, / });
  // Lines of many sets are decimals in every format, and a proof stands beside a report.
  assert.equal(typeof run(table, { ...asked, ask: "window", window: 2, format: "csv", digits: 3 }), "string");
  assert.equal(typeof run(table, { ...asked, format: "proof", exact: true }), "string");
});

test("options about half-planes are refused by name", () => {
  for (const [options, message] of [
    [{ objective: ["1", 2] }, "objective: 2: expected a text"],
    [{ objective: "x" }, 'objective: "x": expected an array of two'],
    [{ start: -1 }, "start: -1: expected an integer that is at least 0"],
    [{ begin: 1 }, "begin: there is no such key (expected one of objective, start)"],
  ]) {
    assert.throws(() => polytope("x <= 1", options), { message });
  }
});

test("options that JSON has no word for are refused by name", () => {
  const whole = { x: "x", y: "y", eps: "1" };
  const refused = (options, message) => {
    for (const answer of [run, lesson]) assert.throws(() => answer("x,y\n1,2\n", options), { name: "TypeError", message });
  };
  refused({ ...whole, eps: 5n }, 'eps: 5 is of type bigint, which JSON does not have (expected text, such as "5", or a number)');
  refused({ ...whole, digits: Number.NaN }, /^digits: NaN is of type number, which JSON does not have/);
  refused({ ...whole, limits: { rows: Infinity } }, /^rows: Infinity is of type number/);
  refused({ ...whole, where: [Symbol("s")] }, /^0: Symbol\(s\) is of type symbol/);
  refused({ ...whole, title: () => "t" }, /^title: .* is of type function/);
  assert.throws(() => run("x,y\n1,2\n", { ...whole, rows: [] }), { name: "TypeError", message: /^rows: none is chosen/ });
  for (const none of [null, [], "x", 5]) refused(none, /^the options are no object/);
  assert.equal(JSON.parse(run("x,y\n1,2\n", { ...whole, title: undefined })).input.rows, 1);
});

test("a limit is raised by its name, in a report and in a lesson", () => {
  const digits = "7".repeat(12_000);
  const table = `x,y\n1,1\n2,${digits}\n`;
  const asked = { x: "x", y: "y", eps: "1" };
  for (const answer of [run, lesson]) {
    assert.throws(() => answer(table, asked), { message: /; limits: {"digits": N} raises it$/ });
    assert.equal(typeof JSON.parse(answer(table, { ...asked, limits: { digits: 12_000 } })), "object");
  }
  const scattered = "x,y\n1,1\n2,2\n3,1\n4,5\n5,0\n6,9\n7,2\n";
  const outliers = { ...asked, ask: "outliers", eps: "0.1", max_steps: 1 };
  assert.throws(() => run(scattered, outliers), { message: /, more than 1; max_steps: N raises it$/ });
  assert.throws(() => run("x,y\n1;5,1\n", { ...asked, delimiter: "comma" }), ({ message }) => !message.includes("--"));
});

test("a number is what it says where it is said to be exact", () => {
  const table = "x,y\n0,0\n1,1\n2,2.5\n";
  const asked = { x: "x", y: "y", reading: "binary64" };
  const eps = (own) => JSON.parse(run(table, { ...asked, eps: own })).input.epsilon;
  assert.notDeepEqual(eps("0.1"), eps({ exact: "0.1" }));
  assert.deepEqual(eps({ exact: "1" }), eps(1));
});

test("a refusal is there as data, in words without the program's options", () => {
  const refusal = (ask) => {
    try {
      ask();
    } catch (error) {
      return JSON.parse(error.refusal);
    }
    return assert.fail("nothing is refused");
  };
  const whole = { x: "x", y: "y", eps: "1" };
  assert.deepEqual(refusal(() => lesson("x,y\n1,2\n2,a\n", whole)), {
    kind: "number", words: "not a number: unexpected character 'a' at character 1", line: 3, column: 2, name: "y", text: "a", position: 1,
  });
  const missing = refusal(() => lesson("x,y\n1,2\n2,\n", whole));
  assert.deepEqual([missing.kind, missing.line, missing.values], ["missing", 3, { count: 1 }]);
  assert.doesNotMatch(missing.words, /--/);
  const bound = refusal(() => run("x,y\n1,2\n", { ...whole, eps: "9,5" }));
  assert.deepEqual([bound.kind, bound.key, bound.text], ["number-comma", "eps", "9,5"]);
  const condition = refusal(() => run("x,y\n1,2\n", { ...whole, where: ["theta1 < 1"] }));
  assert.deepEqual([condition.kind, condition.key, condition.position], ["condition-strict", "where", 8]);
  assert.equal(refusal(() => run("x,y\n1,2\n", { ...whole, digits: 0 })).kind, "");
});

test("after a trap the engine is started anew", () => {
  const question = { x: "x", y: "y", eps: "1" };
  const before = run("x,y\n1,2\n2,3\n", question);
  // All memory that there can be is taken: no table finds room.
  const pages = 2 ** 16 - exports.memory.buffer.byteLength / 2 ** 16;
  exports.memory.grow(pages);
  assert.throws(() => run("x,y\n".padEnd(2 ** 24, "1,2\n"), question), (error) => {
    assert.ok(error instanceof WebAssembly.RuntimeError);
    assert.match(error.message, /^the engine stopped, for lack of memory or through a fault of its own, and was started anew: /);
    return true;
  });
  assert.equal(run("x,y\n1,2\n2,3\n", question), before);
});

const list = JSON.parse(readFileSync(join(root, "tests/questions.json"), "utf8"));

/** A report without doubles and the commands of the program. */
const comparable = (form, text) =>
  form === "json" ? text.replace(/\n( *)"binary64": (\{\}|\{\n[^]*?\n\1\})/g, "") : form === "text" ? withoutDoubleLines(text) : text;

/** The arguments that a command of the program takes: linearity knows neither bounds nor conditions. */
const taken = (args, name) => {
  const isTaken = (option) => name !== "linearity" || ["--x", "--y", "--rows", "--without", "--reading"].includes(option);
  return args.filter((word, at) => isTaken(word) || (!word.startsWith("--") && isTaken(args[at - 1])));
};

/** What the program writes of a question in a form, where it writes an answer. */
const written = ([file, ...own], command, form) => {
  const [name, ...more] = command.split(" ");
  const asked = taken(own, name);
  const folder = mkdtempSync(join(tmpdir(), "boundfit-"));
  try {
    const proof = join(folder, "proof.json");
    const format = { vertices: ["--vertices", "--format", "csv"], proof: ["--proof", proof] }[form] ?? ["--format", form];
    const done = spawnSync(program, [name, file, ...asked, ...more, ...format], { cwd: fixtures, encoding: "utf8", maxBuffer: 1 << 28 });
    if (![0, 3, 4].includes(done.status)) return null;
    return form === "proof" ? readFileSync(proof, "utf8") : done.stdout;
  } finally {
    rmSync(folder, { recursive: true });
  }
};

// A question that the module does not know is refused, and that is no answer.
for (const [question, { about = "about", forms, command, request }] of Object.entries(list.questions)) {
  test(`${question} in every form`, () => {
    let answers = 0;
    const others = fits.filter((line) => !line.startsWith("1 ")).map((line) => ofReadings(line.split(" ").slice(1)).join(" "));
    for (const line of new Set([...list[about], ...(about === "about" ? others : [])])) {
      const all = line.split(" ");
      const words = list[about].includes(line) ? all : [all[0], ...taken(all.slice(1), question)];
      if (isLeftOut(words[0])) continue;
      const table = readFileSync(join(fixtures, words[0]));
      const options = { ...optionsOf(words), ...(question === "fit-x-errors" ? { x_eps: "1/10" } : {}), ask: question, ...request };
      // About the tables of all fits the JSON is compared, from whose answer every other form is written.
      for (const format of list[about].includes(line) ? forms : ["json"]) {
        const expected = written(words, command, format);
        if (expected === null) {
          assert.throws(() => run(table, { ...options, format }), Error, `${format} of ${line}`);
          continue;
        }
        assert.equal(comparable(format, run(table, { ...options, format })), comparable(format, expected), `${format} of ${line}`);
        answers += 1;
      }
    }
    assert.ok(answers > forms.length, `${answers} answers`);
  });
}

test("the module knows no other question than the list", () => {
  const named = (message) => [...message.matchAll(/"([a-z-]+)"/g)].map(([, name]) => name).slice(1);
  assert.throws(() => run("x,y\n1,2\n", { ask: "none", x: "x", y: "y", eps: "1" }), ({ message }) => {
    assert.deepEqual(named(message), Object.keys(list.questions));
    return true;
  });
});

test("without a name the question is a fit, with errors of x or without", () => {
  const table = "x,y\n0,0\n1,1\n2,2.5\n";
  const asked = { x: "x", y: "y", eps: "1" };
  assert.equal(run(table, asked), run(table, { ...asked, ask: "fit" }));
  assert.equal(run(table, { ...asked, x_eps: "1/10" }), run(table, { ...asked, x_eps: "1/10", ask: "fit-x-errors" }));
  assert.equal(JSON.parse(run(table, { x: "x", y: "y", ask: "linearity" })).schema, "boundfit/linearity/1");
  assert.throws(() => run(table, { ...asked, ask: "status", new: "more.csv" }), /^Error: no other table is at hand here/);
  assert.throws(() => run(table, { ...asked, ask: "range", row_numbers: [[5, 7]] }), /^Error: row_numbers: range is about the rows of a table/);
  assert.throws(() => run(table, { ...asked, sweep: "1..2", row_numbers: [[5, 7]] }), /^Error: row_numbers: sweep is about the rows of a table/);
});

test("the module of a page has every lesson, and answers fit alone", async () => {
  const folder = mkdtempSync(join(tmpdir(), "boundfit-"));
  try {
    // Scripts in another folder start a module of their own.
    for (const script of ["boundfit.mjs", "boundfit_wasm.mjs"]) copyFileSync(join(engine, script), join(folder, script));
    const page = await import(pathToFileURL(join(folder, "boundfit.mjs")).href);
    await page.start(readFileSync(join(engine, "page.wasm.gz")));
    for (const line of fits) {
      const args = line.split(" ").slice(1);
      if (isLeftOut(args[0])) continue;
      const [table, options] = [readFileSync(join(fixtures, args[0])), optionsOf(ofReadings(args))];
      assert.deepEqual(said(() => page.lesson(table, options)), said(() => lesson(table, options)), line);
      if (!("x_eps" in options)) assert.deepEqual(said(() => page.run(table, options)), said(() => run(table, options)), line);
    }
    const question = { ask: "range", x: "x", y: "y", eps: "1" };
    assert.throws(() => page.run("x,y\n1,2\n", question), { message: "range: the module of a page answers fit alone" });
  } finally {
    rmSync(folder, { recursive: true });
  }
});
