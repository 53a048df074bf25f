// @ts-check
// Changes to the half-planes as changes to their text, which is all that is kept of them.

import { Rational, ZERO, coordinate, dot } from "../model/rational.js";
import { plainOf } from "./document.js";
import { formText, halfPlaneText } from "./half-planes.js";

// Whole numbers up to this one have directions near enough to those of all steps.
const TURN_SIZE = 20;
const TURN_STEP = Math.PI / 36;

/** @param {bigint} a @param {bigint} b @returns {bigint} */
function commonDivisor(a, b) {
  return b === 0n ? (a < 0n ? -a : a) : commonDivisor(b, a % b);
}

/**
 * A half-plane with a boundary through a point, its normal made of the smallest whole numbers.
 * @param {Pair} normal
 * @param {Pair} through
 * @returns {PlainHalfPlane}
 */
export function planeThrough(normal, through) {
  const common = normal[0].denominator * normal[1].denominator;
  const [p, q] = normal.map((value) => (value.numerator * common) / value.denominator);
  const divisor = commonDivisor(p, q);
  const a = [new Rational(p / divisor), new Rational(q / divisor)];
  return { a, b: dot(a, through) };
}

/**
 * The half-plane on the left of the way from one point to another; null where they are one.
 * @param {Pair} from
 * @param {Pair} to
 */
export function planeLeftOf(from, to) {
  const [dx, dy] = [0, 1].map((k) => to[k].minus(from[k]));
  return dx.isZero() && dy.isZero() ? null : planeThrough([dy, dx.negated()], from);
}

/**
 * A half-plane of the answer in the line that it has in the text, which may have changed since, and may have lines that cannot be read;
 * null where its line is not there any more.
 * @param {PolytopeState} state
 * @param {number} index
 * @returns {PolytopeHalfPlaneData | null}
 */
export function planeInText({ answer, answered, text }, index) {
  const old = answer?.half_planes[index];
  if (old === undefined || answered === null) return null;
  const own = answered.split("\n")[old.line - 1];
  const lines = text.split("\n");
  const at = lines[old.line - 1] === own ? old.line - 1 : lines.indexOf(own);
  return at < 0 ? null : { ...old, line: at + 1 };
}

/**
 * The text with one half-plane more, as a line at its end.
 * @param {string} text
 * @param {PlainHalfPlane} halfPlane
 */
export function textWith(text, halfPlane) {
  const before = text.replace(/\s+$/, "");
  return `${before}${before === "" ? "" : "\n"}${halfPlaneText(halfPlane, true)}`;
}

/**
 * The text with another half-plane in the line of one; an equation stays one.
 * @param {string} text
 * @param {PolytopeHalfPlaneData} old
 * @param {PlainHalfPlane} halfPlane
 */
export function textWithAnother(text, old, halfPlane) {
  const own = old.side === null ? halfPlaneText(halfPlane, true) : `${formText(halfPlane.a, true)} = ${halfPlane.b}`;
  return text.split("\n").map((line, k) => (k + 1 === old.line ? own : line)).join("\n");
}

/**
 * The text without the line of a half-plane.
 * @param {string} text
 * @param {PolytopeHalfPlaneData} old
 */
export function textWithoutLine(text, old) {
  return text.split("\n").filter((_, k) => k + 1 !== old.line).join("\n");
}

/**
 * A normal turned counter-clockwise by some of the 72 steps of a full turn, as a direction of small whole numbers: repeated turns do
 * not make them longer.
 * @param {Pair} normal
 * @param {number} steps
 * @returns {Pair}
 */
export function turnedNormal(normal, steps) {
  const [x, y] = normal.map(coordinate);
  const angle = (Math.round(Math.atan2(y, x) / TURN_STEP) + steps) * TURN_STEP;
  return [Math.cos(angle), Math.sin(angle)].map((value) => new Rational(BigInt(Math.round(TURN_SIZE * value))));
}

/**
 * The other side of the same line.
 * @param {PolytopeHalfPlaneData} old
 * @returns {PlainHalfPlane}
 */
export function otherSide(old) {
  const { a, b } = plainOf(old);
  return { a: a.map((value) => value.negated()), b: b.negated() };
}

/**
 * The exact point of a boundary that is nearest to a place, as far as the grid says: on a line of the grid.
 * @param {PlainHalfPlane} halfPlane
 * @param {Pair} near
 * @returns {Pair}
 */
export function gridPointOn({ a, b }, near) {
  const steep = a[0].absolute().compare(a[1].absolute()) > 0;
  const [given, found] = steep ? [1, 0] : [0, 1];
  const point = [ZERO, ZERO];
  point[given] = near[given];
  point[found] = b.minus(a[given].times(near[given])).over(a[found]);
  return point;
}
