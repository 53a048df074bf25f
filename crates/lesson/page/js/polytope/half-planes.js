// @ts-check
// Half-planes a·θ ≤ b by hand: corners, directions, supports and proofs, all exact, for what depends on the mouse and for exercises
// with few half-planes. The engine proves; this only has to agree with it.

import { Rational, ZERO, dot } from "../model/rational.js";

/**
 * The determinant of two vectors.
 * @param {Pair} u
 * @param {Pair} v
 */
export function determinant(u, v) {
  return u[0].times(v[1]).minus(u[1].times(v[0]));
}

/**
 * Where the boundaries of two half-planes meet, or null where they are parallel (Cramer's rule).
 * @param {PlainHalfPlane} f
 * @param {PlainHalfPlane} g
 * @returns {Pair | null}
 */
export function meetingPoint(f, g) {
  const weight = determinant(f.a, g.a);
  if (weight.isZero()) return null;
  return [determinant([f.b, f.a[1]], [g.b, g.a[1]]).over(weight), determinant([f.a[0], f.b], [g.a[0], g.b]).over(weight)];
}

/**
 * Multiples of two half-planes that add up to a form, or null where their boundaries are parallel.
 * @param {PlainHalfPlane} f
 * @param {PlainHalfPlane} g
 * @param {Pair} form
 * @returns {Pair | null}
 */
export function multiplesFor(f, g, form) {
  const weight = determinant(f.a, g.a);
  if (weight.isZero()) return null;
  return [determinant(form, g.a).over(weight), determinant(f.a, form).over(weight)];
}

/**
 * @param {PlainHalfPlane} halfPlane
 * @param {Pair} theta
 */
export function slackAt({ a, b }, theta) {
  return b.minus(dot(a, theta));
}

/**
 * @param {Pair} p
 * @param {Pair} q
 */
export function isSamePair(p, q) {
  return p[0].equals(q[0]) && p[1].equals(q[1]);
}

/**
 * The corners of the intersection, each once, with the half-planes active there.
 * @param {PlainHalfPlane[]} halfPlanes
 */
export function cornersOfAll(halfPlanes) {
  /** @type {{ theta: Pair, active: number[] }[]} */
  const corners = [];
  halfPlanes.forEach((f, i) => {
    for (const g of halfPlanes.slice(i + 1)) {
      const theta = meetingPoint(f, g);
      if (theta === null || corners.some((corner) => isSamePair(corner.theta, theta))) continue;
      const slacks = halfPlanes.map((halfPlane) => slackAt(halfPlane, theta).sign());
      if (slacks.some((sign) => sign < 0)) continue;
      corners.push({ theta, active: slacks.flatMap((sign, index) => (sign === 0 ? [index] : [])) });
    }
  });
  return corners;
}

/**
 * The pivot of the simplex method by Bland's rule from a basis of two half-planes: which leaves, which enters and how much the objective
 * grows; null at the optimum. Without `entering` nothing stops the way.
 * @param {PlainHalfPlane[]} halfPlanes
 * @param {number[]} basis
 * @param {Pair} form
 */
export function blandPivot(halfPlanes, basis, form) {
  const [f, g] = basis.map((index) => halfPlanes[index]);
  const theta = meetingPoint(f, g);
  const multiples = multiplesFor(f, g, form);
  if (theta === null || multiples === null) return null;
  const leaving = Math.min(...basis.filter((_, k) => multiples[k].sign() < 0));
  if (leaving === Infinity) return null;
  const [gone, kept] = [halfPlanes[leaving], halfPlanes[basis[0] === leaving ? basis[1] : basis[0]]];
  const along = [kept.a[1].negated(), kept.a[0]];
  const speed = dot(gone.a, along).negated();
  const direction = along.map((value) => value.over(speed));
  /** @type {{ entering: number | null, length: Rational }} */
  let stop = { entering: null, length: ZERO };
  halfPlanes.forEach((halfPlane, index) => {
    const approach = dot(halfPlane.a, direction);
    if (approach.sign() <= 0) return;
    const length = slackAt(halfPlane, theta).over(approach);
    if (stop.entering === null || length.compare(stop.length) < 0) stop = { entering: index, length };
  });
  return { leaving, entering: stop.entering, growth: dot(form, direction).times(stop.length), theta };
}

/**
 * How far a set with these corners, rays and lines reaches in the direction of a form: the value with the corners where it is
 * attained, or a ray along which the form grows for ever; null where neither corners nor rays say it.
 * @param {Pair[]} corners
 * @param {Pair[]} rays
 * @param {Pair[]} lines
 * @param {Pair} form
 * @returns {Reach}
 */
export function reachOf(corners, rays, lines, form) {
  const both = lines.flatMap((line) => [line, line.map((value) => value.negated())]);
  const ray = [...rays, ...both].find((way) => dot(form, way).sign() > 0);
  if (ray !== undefined) return { ray };
  if (corners.length === 0) return null;
  const values = corners.map((corner) => dot(form, corner));
  const value = values.reduce((best, own) => (own.compare(best) > 0 ? own : best));
  const face = corners.filter((_, k) => values[k].equals(value));
  const direction = rays.find((way) => dot(form, way).isZero()) ?? null;
  return { value, face, direction: face.length === 1 ? direction : null };
}

/**
 * "2x − 3y", with the given signs; "0" for nothing.
 * @param {Pair} form
 * @param {boolean} [typed] with the characters of a keyboard
 */
export function formText(form, typed = false) {
  const minus = typed ? "-" : "\u2212";
  const parts = form.flatMap((coefficient, k) => {
    if (coefficient.isZero()) return [];
    const size = coefficient.absolute();
    const factor = size.numerator === size.denominator ? "" : size.denominator === 1n ? `${size}` : `${size} `;
    return [{ sign: coefficient.sign(), text: `${factor}${"xy"[k]}` }];
  });
  if (parts.length === 0) return "0";
  return parts
    .map(({ sign, text }, k) => (k === 0 ? (sign < 0 ? `${minus}${text}` : text) : `${sign < 0 ? minus : "+"} ${text}`))
    .join(" ");
}

/**
 * "2x − 3y ≤ 6"; where no coefficient is positive "x ≥ 1" rather than "−x ≤ −1".
 * @param {PlainHalfPlane} halfPlane
 * @param {boolean} [typed] with the characters of a keyboard, as the editor reads it
 * @param {boolean} [atMost] always with ≤
 */
export function halfPlaneText({ a, b }, typed = false, atMost = false) {
  const turned = !atMost && a.every((value) => value.sign() <= 0) && a.some((value) => value.sign() < 0);
  const form = turned ? a.map((value) => value.negated()) : a;
  const right = `${turned ? b.negated() : b}`;
  const relation = typed ? (turned ? ">=" : "<=") : turned ? "≥" : "≤";
  return `${formText(form, typed)} ${relation} ${typed ? right : right.replace("-", "\u2212")}`;
}

/**
 * A fraction with a typographic minus.
 * @param {Rational} value
 */
export function fractionText(value) {
  return `${value}`.replace("-", "\u2212");
}

/**
 * A point or vector as text.
 * @param {Pair} pair
 */
export function pairText(pair) {
  return `(${pair.map(fractionText).join(", ")})`;
}

/**
 * What half-plane 0, 1, … is called.
 * @param {number} index
 */
export function nameByIndex(index) {
  return `(${index + 1})`;
}
