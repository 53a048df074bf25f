// The exercises on half-planes: for a thousand seeds each has one right answer, which an oracle finds by trying everything, and
// the checker takes it and nothing else. No browser is needed; the oracle shares no arithmetic with the page.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { polytope, start } from "../../crates/lesson/engine/boundfit.mjs";
import { exercisesOf, judged, rightAnswer, typedNumber } from "../../crates/lesson/page/js/polytope/exercises.js";
import { halfPlaneText } from "../../crates/lesson/page/js/polytope/half-planes.js";

const SEEDS = 1000;

/** Fractions as [numerator, denominator > 0], not reduced. */
const frac = (text) => {
  const [n, d = "1"] = `${text}`.split("/");
  return [BigInt(n), BigInt(d)];
};
const add = ([a, b], [c, d]) => [a * d + c * b, b * d];
const sub = (p, [c, d]) => add(p, [-c, d]);
const mul = ([a, b], [c, d]) => [a * c, b * d];
const div = ([a, b], [c, d]) => (c < 0n ? [-a * d, b * -c] : [a * d, b * c]);
const sign = ([a]) => (a < 0n ? -1 : a > 0n ? 1 : 0);
const same = (p, q) => sign(sub(p, q)) === 0;
const less = (p, q) => sign(sub(p, q)) < 0;

const rowsOf = (exercise) => exercise.halfPlanes.map(({ a, b }) => [frac(a[0]), frac(a[1]), frac(b)]);
const slack = ([a, b, c], [x, y]) => sub(c, add(mul(a, x), mul(b, y)));
const cross = ([a, b], [c, d]) => sub(mul(a, d), mul(b, c));
const value = ([p, q], [x, y]) => add(mul(p, x), mul(q, y));
const meet = (f, g) => {
  const w = cross(f, g);
  if (sign(w) === 0) return null;
  return [div(sub(mul(f[2], g[1]), mul(g[2], f[1])), w), div(sub(mul(f[0], g[2]), mul(g[0], f[2])), w)];
};
const equalPoints = (p, q) => same(p[0], q[0]) && same(p[1], q[1]);

const vertices = (rows) => {
  const found = [];
  for (const [i, f] of rows.entries()) {
    for (const g of rows.slice(i + 1)) {
      const point = meet(f, g);
      if (point && rows.every((row) => sign(slack(row, point)) >= 0) && !found.some((own) => equalPoints(own, point))) found.push(point);
    }
  }
  return found;
};
const directions = (rows) =>
  rows.flatMap(([a, b]) => [[b, mul(a, [-1n, 1n])], [mul(b, [-1n, 1n]), a], [mul(a, [-1n, 1n]), mul(b, [-1n, 1n])]])
    .filter((d) => rows.every((row) => sign(value(row, d)) <= 0));
const samePoints = (some, others) => some.length === others.length && some.every((p) => others.some((q) => equalPoints(p, q)));

/** The kind by definitions: points, directions, and whether an inner point is left. */
const kindOf = (rows) => {
  const corners = vertices(rows);
  const ways = directions(rows);
  const feet = rows.map(([a, b, c]) => [div(mul(a, c), value([a, b], [a, b])), div(mul(b, c), value([a, b], [a, b]))]);
  const points = [...corners, ...feet].filter((point) => rows.every((row) => sign(slack(row, point)) >= 0));
  if (points.length === 0) return "empty";
  const goesBack = ways.some((d) => ways.some((e) => sign(cross(d, e)) === 0 && sign(value(d, e)) < 0));
  // Flat: a row that holds with = everywhere in the set.
  const isFlat = rows.some((row) => points.every((p) => sign(slack(row, p)) === 0) && ways.every((d) => sign(value(row, d)) === 0));
  if (corners.length === 0) {
    if (isFlat) return "line";
    return ways.every((d) => ways.every((e) => sign(cross(d, e)) === 0)) && goesBack ? "strip" : "half-plane";
  }
  if (ways.length > 0) return isFlat ? "ray" : "unbounded-polygon";
  return corners.length === 1 ? "point" : corners.length === 2 ? "segment" : "polygon";
};

/** Bland's pivot by definitions. */
const pivot = (rows, basis, form) => {
  const [f, g] = basis.map((index) => rows[index]);
  const w = cross(f, g);
  const times = [div(cross(form, g), w), div(cross(f, form), w)];
  const at = meet(f, g);
  const leaving = Math.min(...basis.filter((_, k) => sign(times[k]) < 0));
  const stays = rows[basis.find((index) => index !== leaving)];
  let way = [stays[1], mul(stays[0], [-1n, 1n])];
  if (sign(value(rows[leaving], way)) > 0) way = way.map((part) => mul(part, [-1n, 1n]));
  let best = null;
  rows.forEach((row, index) => {
    const speed = value(row, way);
    if (sign(speed) <= 0) return;
    const length = div(slack(row, at), speed);
    if (best === null || less(length, best.length)) best = { index, length };
  });
  return { leaving, entering: best.index, growth: mul(value(form, way), best.length), at };
};

/** A point such as "(−1/2, 3)" of a text. */
const pointOf = (text) => text.replace(/−/g, "-").replace(/[()]/g, "").split(", ").map(frac);
const indexOf = (name) => Number(name.replace(/[()]/g, "")) - 1;
const answers = (exercise) => rightAnswer(exercise).map(frac);

/** What each exercise asks, found out anew. */
const ORACLE = {
  redundant(exercise, rows) {
    const all = vertices(rows);
    const idle = rows.flatMap((_, k) => (samePoints(vertices(rows.filter((__, j) => j !== k)), all) && directions(rows.filter((__, j) => j !== k)).length === 0 ? [k] : []));
    assert.deepEqual(idle.map((k) => `${k + 1}`), rightAnswer(exercise));
  },
  corner(exercise, rows) {
    const [f, g] = ["one", "other"].map((key) => rows[indexOf(exercise.values[key])]);
    const point = meet(f, g);
    assert.ok(vertices(rows).some((own) => equalPoints(own, point)));
    assert.ok(equalPoints(point, answers(exercise)));
  },
  kind(exercise, rows) {
    assert.equal(kindOf(rows), exercise.answer.choice);
    assert.equal(vertices(rows).length, exercise.values.corners);
  },
  support(exercise, rows) {
    const form = exercise.objective.map(frac);
    const values = vertices(rows).map((point) => value(form, point));
    const best = values.reduce((one, other) => (less(one, other) ? other : one));
    assert.ok(same(best, answers(exercise)[0]) && values.filter((own) => same(own, best)).length === 1);
    assert.equal(directions(rows).length, 0);
  },
  multipliers(exercise, rows) {
    const form = exercise.objective.map(frac);
    const [f, g] = ["one", "other"].map((key) => rows[indexOf(exercise.values[key])]);
    const [s, t] = answers(exercise);
    assert.ok([0, 1].every((k) => same(add(mul(s, f[k]), mul(t, g[k])), form[k])));
    assert.ok(sign(cross(f, g)) !== 0 && sign(s) > 0 && sign(t) > 0);
    const corner = pointOf(exercise.values.corner);
    assert.ok(vertices(rows).every((point) => !less(value(form, corner), value(form, point))));
    assert.equal(rows.filter((row) => sign(slack(row, corner)) === 0).length, 2);
  },
  cone(exercise, rows) {
    const corner = pointOf(exercise.values.corner);
    const isBest = (t) => vertices(rows).every((point) => !less(value([[1n, 1n], t], corner), value([[1n, 1n], t], point)));
    const [most] = answers(exercise);
    assert.ok(vertices(rows).some((own) => equalPoints(own, corner)) && isBest(most));
    // Convex: what fails a little farther fails for ever.
    for (const more of [[1n, 1000000n], [1n, 1n], [100n, 1n]]) assert.ok(!isBest(add(most, more)));
  },
  contradiction(exercise, rows) {
    const [s, t] = answers(exercise);
    const sum = [0, 1, 2].map((k) => add(add(rows[0][k], mul(s, rows[1][k])), mul(t, rows[2][k])));
    assert.ok(sign(sum[0]) === 0 && sign(sum[1]) === 0 && sign(sum[2]) < 0 && sign(s) > 0 && sign(t) > 0);
    // No others: (2) and (3) are not parallel.
    assert.ok(sign(cross(rows[1], rows[2])) !== 0);
    assert.equal(kindOf(rows), "empty");
  },
  pivot(exercise, rows, degenerate = false) {
    const form = exercise.objective.map(frac);
    const basis = ["one", "other"].map((key) => indexOf(exercise.values[key]));
    const found = pivot(rows, basis, form);
    const [leaving, entering, growth] = answers(exercise);
    assert.deepEqual([leaving[0], entering[0]], [found.leaving + 1, found.entering + 1].map(BigInt));
    assert.ok(same(growth, found.growth) && sign(growth) === (degenerate ? 0 : 1));
    assert.ok(equalPoints(found.at, pointOf(exercise.values.corner)) && vertices(rows).some((own) => equalPoints(own, found.at)));
    assert.equal(rows.filter((row) => sign(slack(row, found.at)) === 0).length, degenerate ? 3 : 2);
  },
  degenerate(exercise, rows) {
    ORACLE.pivot(exercise, rows, true);
  },
  unbounded(exercise, rows) {
    const [most] = answers(exercise);
    const isBounded = (t) => directions(rows).every((d) => sign(value([t, [1n, 1n]], d)) <= 0);
    assert.equal(kindOf(rows), "unbounded-polygon");
    assert.ok(isBounded(most) && isBounded(sub(most, [7n, 1n])) && !isBounded(add(most, [1n, 1000000n])) && !isBounded(add(most, [50n, 1n])));
  },
};

test("a thousand seeds: every exercise has one right answer, which is taken, and others are not", () => {
  const seen = {};
  for (let k = 0; k < SEEDS; k += 1) {
    const exercises = exercisesOf(`seed ${k}`);
    assert.deepEqual(exercises.map(({ id }) => id), Object.keys(ORACLE));
    for (const exercise of exercises) {
      const what = `seed ${k}, ${exercise.id}: ${exercise.halfPlanes.map((own) => halfPlaneText(own)).join("; ")}`;
      try {
        ORACLE[exercise.id](exercise, rowsOf(exercise));
      } catch (error) {
        throw new Error(`${what}: ${error.message}`);
      }
      const right = rightAnswer(exercise);
      assert.ok(judged(exercise, right).every((verdict) => verdict === true), what);
      if ("choice" in exercise.answer) {
        seen[exercise.answer.choice] = (seen[exercise.answer.choice] ?? 0) + 1;
        for (const kind of exercise.answer.choices) assert.equal(judged(exercise, [kind])[0], kind === right[0], what);
        continue;
      }
      right.forEach((text, field) => {
        const [n, d = "1"] = text.split("/");
        const others = [`${BigInt(n) + 1n}/${d}`, `${BigInt(n) * 2n + 1n}/${BigInt(d) * 2n}`, `${BigInt(n) - BigInt(d)}/${d}`];
        for (const other of others) assert.equal(judged(exercise, right.map((own, j) => (j === field ? other : own)))[field], false, what);
        assert.equal(judged(exercise, right.map((own, j) => (j === field ? `${BigInt(n) * 3n}/${BigInt(d) * 3n}` : own)))[field], true, what);
        for (const none of ["", "x", "1/0", "1..2", "--1", "9".repeat(50)]) assert.equal(judged(exercise, right.map((own, j) => (j === field ? none : own)))[field], null, what);
      });
    }
  }
  assert.ok(Object.keys(seen).length === 9 && Object.values(seen).every((count) => count > 60), JSON.stringify(seen));
});

test("a seed gives the same exercises, another one others", () => {
  const text = (seed) => JSON.stringify(exercisesOf(seed).map(({ halfPlanes, values }) => [halfPlanes.map((own) => halfPlaneText(own)), values]));
  assert.equal(text("class 3b"), text("class 3b"));
  const all = new Set(Array.from({ length: 200 }, (_, k) => text(`${k}`)));
  assert.equal(all.size, 200);
});

test("answers are read as people write them", () => {
  for (const [text, expected] of [
    ["3", "3"], [" −1/2 ", "-1/2"], ["0,5", "1/2"], ["0.50", "1/2"], ["-2,25", "-9/4"], [".5", "1/2"], ["6/4", "3/2"], ["(2)", "2"], ["+7", "7"], ["-6 / 4", "-3/2"],
  ]) assert.equal(`${typedNumber(text)}`, expected, text);
  for (const text of ["", "1/", "a", "1,2,3", "1e3", "1/-2", "1 2"]) assert.equal(typedNumber(text), null, text);
});

test("the engine says the same of the sets and objectives of exercises", async () => {
  await start(readFileSync(new URL("../../crates/lesson/engine/boundfit_wasm.wasm.gz", import.meta.url)));
  for (let k = 0; k < 60; k += 1) {
    for (const exercise of exercisesOf(`engine ${k}`)) {
      const words = exercise.halfPlanes.map((own) => halfPlaneText(own, true)).join("\n");
      const options = exercise.objective === null ? {} : { objective: exercise.objective.map(String) };
      const { errors, set, half_planes, objective } = JSON.parse(polytope(words, options));
      const what = `engine ${k}, ${exercise.id}`;
      assert.deepEqual(errors, [], what);
      assert.deepEqual(half_planes.map(({ a, b }) => [...a, b]), exercise.halfPlanes.map(({ a, b }) => [...a, b].map(String)), what);
      const right = rightAnswer(exercise);
      if (exercise.id === "redundant") assert.deepEqual(half_planes.flatMap(({ redundant }, at) => (redundant === null ? [] : [`${at + 1}`])), right, what);
      if (exercise.id === "corner") assert.ok(set.vertices.some(({ theta }) => `${theta}` === `${right}`), what);
      if (exercise.id === "kind") assert.equal(set.kind, right[0], what);
      if (exercise.id === "support") assert.equal(objective.value, right[0], what);
      if (exercise.id === "multipliers") assert.ok(objective.ways.unique && `${objective.proof.map(({ multiplier }) => multiplier)}` === `${right}`, what);
      if (exercise.id === "contradiction") assert.equal(set.kind, "empty", what);
    }
  }
});
