// @ts-check
// Ten exercises on half-planes, the harder the later, from a seed. What is asked, the hints and the explanation are texts of the
// table: polytope.ask-…, polytope.hint-…, polytope.why-….

import { ONE, Rational, dot } from "../model/rational.js";
import { blandPivot, cornersOfAll, determinant, fractionText, formText, meetingPoint, multiplesFor, nameByIndex, pairText } from "./half-planes.js";
import { randomFrom } from "./random.js";

/** @typedef {ReturnType<typeof randomFrom>} Random */
/** @typedef {Omit<Exercise, "number" | "id">} Draft */

/** Normals by angle, counter-clockwise. */
const NORMALS = [
  [1, 0], [2, 1], [1, 1], [1, 2], [0, 1], [-1, 2], [-1, 1], [-2, 1],
  [-1, 0], [-2, -1], [-1, -1], [-1, -2], [0, -1], [1, -2], [1, -1], [2, -1],
];
const MOST_DRAWS = 2000;

/** @param {number} value */
const wholeNumber = (value) => new Rational(BigInt(value));

/**
 * @param {number[]} numbers
 * @returns {Pair}
 */
const wholePair = (numbers) => numbers.map(wholeNumber);

/**
 * Draws until something fits; that it does within few draws is tested.
 * @template T
 * @param {() => T | null} draw
 * @returns {T}
 */
function firstFitting(draw) {
  for (let k = 0; k < MOST_DRAWS; k += 1) {
    const found = draw();
    if (found !== null) return found;
  }
  throw new RangeError(`${MOST_DRAWS}`);
}

/**
 * A polygon with so many sides and corners with two sides each, its half-planes in any order.
 * @param {Random} random
 * @param {number} sides
 */
function drawnPolygon(random, sides) {
  return firstFitting(() => {
    const normals = random.shuffled(NORMALS).slice(0, sides);
    const centre = wholePair([random.between(-2, 3), random.between(-2, 3)]);
    const halfPlanes = normals.map((normal) => {
      const a = wholePair(normal);
      return { a, b: dot(a, centre).plus(wholeNumber(random.between(2, 7))) };
    });
    const corners = cornersOfAll(halfPlanes);
    const isBounded = normals.every((u) => normals.some((v) => u[0] * v[1] - u[1] * v[0] > 0));
    const isSimple = corners.length === sides && corners.every(({ active }) => active.length === 2);
    const isShort = corners.every(({ theta }) => theta.every((value) => value.denominator <= 6n));
    return isBounded && isSimple && isShort ? { halfPlanes, corners, normals } : null;
  });
}

/**
 * The greatest value of a form over corners.
 * @param {{ theta: Pair }[]} corners
 * @param {Pair} form
 */
function greatestValue(corners, form) {
  return corners.map(({ theta }) => dot(form, theta)).reduce((best, value) => (value.compare(best) > 0 ? value : best));
}

/**
 * A small form that is greatest at one corner only.
 * @param {Random} random
 * @param {{ theta: Pair }[]} corners
 */
function smallForm(random, corners) {
  return firstFitting(() => {
    const form = wholePair([random.between(-3, 3), random.between(-3, 3)]);
    const best = greatestValue(corners, form);
    return corners.filter(({ theta }) => dot(form, theta).equals(best)).length === 1 ? form : null;
  });
}

/** @param {string} text */
const asNumber = (text) => ({ number: text });

/** @param {Rational} value */
const asShown = (value) => asNumber(fractionText(value));

/** @type {(random: Random) => Draft} */
function draftRedundant(random) {
  const { halfPlanes, corners, normals } = drawnPolygon(random, 4);
  const a = wholePair(random.one(NORMALS.filter((normal) => !normals.includes(normal))));
  const reach = greatestValue(corners, a);
  const idle = { a, b: wholeNumber(Number(reach.floor()) + random.between(1, 2)) };
  const all = random.shuffled([...halfPlanes, idle]);
  const at = all.indexOf(idle);
  const best = corners.find(({ theta }) => dot(a, theta).equals(reach));
  return {
    halfPlanes: all,
    objective: null,
    values: { own: nameByIndex(at), form: formText(a), reach: asShown(reach), bound: asShown(idle.b), corner: pairText(best?.theta ?? []) },
    answer: { values: [wholeNumber(at + 1)], fields: [{ text: "polytope.field-half-plane" }] },
  };
}

/** @type {(random: Random) => Draft} */
function draftCorner(random) {
  const { halfPlanes, corners } = drawnPolygon(random, random.between(4, 5));
  const { theta, active } = random.one(corners);
  return {
    halfPlanes,
    objective: null,
    values: { one: nameByIndex(active[0]), other: nameByIndex(active[1]), corner: pairText(theta) },
    answer: { values: theta, fields: ["x", "y"] },
  };
}

const KINDS_ASKED = ["empty", "point", "segment", "ray", "line", "strip", "half-plane", "polygon", "unbounded-polygon"];

/**
 * Half-planes whose set is of a kind.
 * @param {Random} random
 * @param {string} kind
 * @returns {PlainHalfPlane[]}
 */
function ofKind(random, kind) {
  const { halfPlanes, corners, normals } = drawnPolygon(random, 3);
  const [first, second] = halfPlanes;
  /** @param {PlainHalfPlane} halfPlane @param {number} by */
  const across = ({ a, b }, by) => ({ a: a.map((value) => value.negated()), b: wholeNumber(by).minus(b) });
  /** @param {PlainHalfPlane} halfPlane @param {number} by */
  const beside = ({ a, b }, by) => ({ a, b: b.plus(wholeNumber(by)) });
  const by = random.between(1, 4);
  if (kind === "polygon") return random.between(0, 1) === 0 ? halfPlanes : drawnPolygon(random, 4).halfPlanes;
  if (kind === "line") return [first, across(first, 0), beside(first, by)];
  if (kind === "strip") return [first, across(first, by), beside(first, by)];
  if (kind === "half-plane") return [first, beside(first, by), beside(first, by + 2)];
  if (kind === "ray") return [first, across(first, 0), second];
  if (kind === "segment") return [...halfPlanes, across(first, 0)];
  if (kind === "unbounded-polygon") return [first, second, beside({ a: first.a.map((value, k) => value.plus(second.a[k])), b: first.b.plus(second.b) }, -1)];
  const form = firstFitting(() => {
    const a = wholePair(random.one(NORMALS.filter((normal) => !normals.includes(normal))));
    const best = greatestValue(corners, a);
    return corners.filter(({ theta }) => dot(a, theta).equals(best)).length === 1 ? { a, b: best } : null;
  });
  const reach = { a: form.a, b: wholeNumber(Number(form.b.floor()) + by) };
  // A bound that is a whole number where the set is empty; of a point it is what the corner asks for.
  return [...halfPlanes, across(kind === "empty" ? reach : form, 0)];
}

/** @type {(random: Random) => Draft} */
function draftKind(random) {
  const kind = random.one(KINDS_ASKED);
  const halfPlanes = random.shuffled(ofKind(random, kind));
  return {
    halfPlanes,
    objective: null,
    values: { kind: { text: `polytope.name-${kind}` }, corners: cornersOfAll(halfPlanes).length },
    answer: { choice: kind, choices: KINDS_ASKED },
  };
}

/** @type {(random: Random) => Draft} */
function draftSupport(random) {
  const { halfPlanes, corners } = drawnPolygon(random, 5);
  const form = smallForm(random, corners);
  const value = greatestValue(corners, form);
  const best = corners.find(({ theta }) => dot(form, theta).equals(value));
  return {
    halfPlanes,
    objective: form,
    values: { form: formText(form), value: asShown(value), corner: pairText(best?.theta ?? []) },
    answer: { values: [value], fields: [{ text: "polytope.field-value" }] },
  };
}

/** @type {(random: Random) => Draft} */
function draftMultipliers(random) {
  const { halfPlanes, corners } = drawnPolygon(random, random.between(4, 5));
  const { theta, active } = random.one(corners);
  const [f, g] = active.map((index) => halfPlanes[index]);
  const times = [wholeNumber(random.between(1, 3)), new Rational(BigInt(random.between(1, 4)), 2n)];
  const form = [0, 1].map((k) => times[0].times(f.a[k]).plus(times[1].times(g.a[k])));
  const [one, other] = active.map(nameByIndex);
  return {
    halfPlanes,
    objective: form,
    values: {
      form: formText(form), one, other, corner: pairText(theta), s: asShown(times[0]), t: asShown(times[1]),
      value: asShown(dot(form, theta)),
    },
    answer: { values: times, fields: [{ text: "polytope.field-times", values: { name: one } }, { text: "polytope.field-times", values: { name: other } }] },
  };
}

/** @type {(random: Random) => Draft} */
function draftCone(random) {
  const { halfPlanes, corner: found } = firstFitting(() => {
    const { halfPlanes, corners } = drawnPolygon(random, 5);
    const right = corners.filter(({ active }) => active.every((index) => halfPlanes[index].a[0].sign() > 0));
    return right.length === 0 ? null : { halfPlanes, corner: random.one(right) };
  });
  const slopes = found.active.map((index) => halfPlanes[index].a[1].over(halfPlanes[index].a[0]));
  const [least, most] = slopes[0].compare(slopes[1]) < 0 ? slopes : [slopes[1], slopes[0]];
  const [one, other] = found.active.map(nameByIndex);
  return {
    halfPlanes,
    objective: null,
    values: { corner: pairText(found.theta), one, other, least: asShown(least), most: asShown(most) },
    answer: { values: [most], fields: ["t"] },
  };
}

/** @type {(random: Random) => Draft} */
function draftContradiction(random) {
  return firstFitting(() => {
    const [second, third] = random.shuffled(NORMALS).slice(0, 2).map(wholePair);
    const times = [new Rational(BigInt(random.between(1, 4)), 2n), wholeNumber(random.between(1, 3))];
    const first = [0, 1].map((k) => times[0].times(second[k]).plus(times[1].times(third[k])).negated());
    if (determinant(second, third).isZero() || first.some((value) => value.denominator !== 1n)) return null;
    const [b2, b3] = [random.between(-4, 4), random.between(-4, 4)].map(wholeNumber);
    const sum = wholeNumber(-random.between(1, 4));
    const b1 = sum.minus(times[0].times(b2)).minus(times[1].times(b3));
    return {
      halfPlanes: [{ a: first, b: b1 }, { a: second, b: b2 }, { a: third, b: b3 }],
      objective: null,
      values: { s: asShown(times[0]), t: asShown(times[1]), sum: asShown(sum) },
      answer: { values: times, fields: [{ text: "polytope.field-times", values: { name: "(2)" } }, { text: "polytope.field-times", values: { name: "(3)" } }] },
    };
  });
}

/**
 * A pivot as a question.
 * @param {PlainHalfPlane[]} halfPlanes
 * @param {number[]} basis
 * @param {Pair} form
 * @returns {Draft | null}
 */
function pivotDraft(halfPlanes, basis, form) {
  const pivot = blandPivot(halfPlanes, basis, form);
  const times = multiplesFor(halfPlanes[basis[0]], halfPlanes[basis[1]], form);
  if (pivot === null || pivot.entering === null || times === null) return null;
  const { leaving, entering, growth, theta } = pivot;
  return {
    halfPlanes,
    objective: form,
    values: {
      form: formText(form), one: nameByIndex(basis[0]), other: nameByIndex(basis[1]), corner: pairText(theta), s: asShown(times[0]), t: asShown(times[1]),
      leaving: nameByIndex(leaving), entering: nameByIndex(entering), growth: asShown(growth),
    },
    answer: {
      values: [wholeNumber(leaving + 1), wholeNumber(entering + 1), growth],
      fields: [{ text: "polytope.field-leaving" }, { text: "polytope.field-entering" }, { text: "polytope.field-growth" }],
    },
  };
}

/** @type {(random: Random) => Draft} */
function draftPivot(random) {
  return firstFitting(() => {
    const { halfPlanes, corners } = drawnPolygon(random, 5);
    return pivotDraft(halfPlanes, random.one(corners).active, smallForm(random, corners));
  });
}

/** @type {(random: Random) => Draft} */
function draftDegenerate(random) {
  return firstFitting(() => {
    const { halfPlanes, corners } = drawnPolygon(random, 4);
    const { theta, active } = random.one(corners);
    const [f, g] = active.map((index) => halfPlanes[index]);
    const a = [0, 1].map((k) => f.a[k].times(wholeNumber(random.between(1, 2))).plus(g.a[k]));
    const all = random.shuffled([...halfPlanes, { a, b: dot(a, theta) }]);
    const through = all.flatMap((halfPlane, index) => (dot(halfPlane.a, theta).equals(halfPlane.b) ? [index] : []));
    const basis = random.shuffled(through).slice(0, 2).sort((p, q) => p - q);
    if (meetingPoint(all[basis[0]], all[basis[1]]) === null) return null;
    const draft = pivotDraft(all, basis, smallForm(random, corners));
    return draft !== null && "values" in draft.answer && draft.answer.values[2].isZero() ? draft : null;
  });
}

/** @type {(random: Random) => Draft} */
function draftUnbounded(random) {
  return firstFitting(() => {
    const [p, q] = [random.between(1, 3), random.between(-3, 3)];
    if (q === 0 || (p > 1 && q % p === 0)) return null;
    const top = { a: wholePair([-q, p]), b: wholeNumber(random.between(1, 6)) };
    const left = { a: wholePair([-1, 0]), b: wholeNumber(random.between(0, 3)) };
    const a = [0, 1].map((k) => top.a[k].plus(left.a[k]));
    const meet = meetingPoint(top, left);
    if (meet === null) return null;
    // It cuts the corner of the other two off.
    const cut = { a, b: dot(a, meet).minus(ONE) };
    const most = new Rational(BigInt(-q), BigInt(p));
    return {
      halfPlanes: random.shuffled([top, left, cut]),
      objective: null,
      values: { ray: pairText(wholePair([p, q])), p: asShown(wholeNumber(p)), q: asShown(wholeNumber(q)), most: asShown(most) },
      answer: { values: [most], fields: ["t"] },
    };
  });
}

/** @type {[string, (random: Random) => Draft][]} */
const EXERCISES = [
  ["redundant", draftRedundant],
  ["corner", draftCorner],
  ["kind", draftKind],
  ["support", draftSupport],
  ["multipliers", draftMultipliers],
  ["cone", draftCone],
  ["contradiction", draftContradiction],
  ["pivot", draftPivot],
  ["degenerate", draftDegenerate],
  ["unbounded", draftUnbounded],
];

/** How many hints an exercise has. */
export const HINTS = 2;

/**
 * The ten exercises of a seed.
 * @param {string} seed
 * @returns {Exercise[]}
 */
export function exercisesOf(seed) {
  return EXERCISES.map(([id, make], k) => ({ number: k + 1, id, ...make(randomFrom(`${seed}/${id}`)) }));
}

const LONGEST_ANSWER = 40;

/**
 * A number as somebody types it: a whole one, a fraction, or a decimal with a point or a comma; null where it is none.
 * @param {string} text
 */
export function typedNumber(text) {
  const plain = text.trim().replace(/\u2212/g, "-").replace(/^\((.*)\)$/, "$1").replace(/\s*\/\s*/, "/");
  if (plain.length > LONGEST_ANSWER) return null;
  const fraction = plain.match(/^([+-]?\d+)\/(\d+)$/);
  if (fraction !== null) {
    const denominator = BigInt(fraction[2]);
    return denominator === 0n ? null : new Rational(BigInt(fraction[1].replace("+", "")), denominator);
  }
  if (!/^[+-]?(\d+([.,]\d*)?|[.,]\d+)$/.test(plain)) return null;
  const value = Rational.parseDecimal(plain.replace(",", ".").replace(/^[+-]/, ""));
  return plain.startsWith("-") ? value.negated() : value;
}

/**
 * Whether each of the fields has its answer; exact.
 * @param {Exercise} exercise
 * @param {string[]} typed
 * @returns {Verdict[]}
 */
export function judged({ answer }, typed) {
  if ("choice" in answer) return [typed[0] === "" ? null : typed[0] === answer.choice];
  return answer.values.map((value, k) => {
    const given = typedNumber(typed[k] ?? "");
    return given === null ? null : given.equals(value);
  });
}

/**
 * The right answer as somebody would type it.
 * @param {Exercise} exercise
 */
export function rightAnswer({ answer }) {
  return "choice" in answer ? [answer.choice] : answer.values.map((value) => `${value}`);
}

