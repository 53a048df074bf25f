// @ts-check
// The worst acceptable lines: the steepest and the shallowest one through all error bars, laid by hand and exact.
// A line by hand is known by its heights at the least and the greatest x of the readings.

import { boundAt, rightHandSide, violations } from "./lesson.js";
import { ONE, ZERO, dot, extremes } from "./rational.js";

/** @type {WorstName[]} */
export const WORST = ["steepest", "shallowest"];

/**
 * The least and the greatest x, where the lines by hand are held; null where no two readings have different ones, and for two
 * regressors.
 * @param {Lesson} lesson
 */
export function gripsOf(lesson) {
  if (!lesson.isLine || lesson.readings.length === 0) return null;
  const [least, greatest] = extremes(lesson.readings.map(({ phi }) => phi[0]));
  return least.equals(greatest) ? null : [least, greatest];
}

/**
 * The lines that school books begin with: from end to end of the first and the last bar.
 * @param {Lesson} lesson
 * @returns {HandLines}
 */
export function cornerToCorner(lesson) {
  const grips = gripsOf(lesson) ?? [];
  const ends = grips.map((x) => {
    const there = lesson.readings.filter(({ phi }) => phi[0].equals(x));
    /** @param {"upper" | "lower"} bound */
    const all = (bound) => extremes(there.map((reading) => boundAt(reading, bound, ONE) ?? reading.y));
    return { upper: all("upper")[0], lower: all("lower")[1] };
  });
  const [first, last] = ends;
  if (first === undefined) return { steepest: [], shallowest: [] };
  const [greatest, least] = [[first.lower, last.upper], [first.upper, last.lower]];
  return isGreatest(lesson, "steepest") ? { steepest: greatest, shallowest: least } : { steepest: least, shallowest: greatest };
}

/**
 * Whether all lines fall: the feasible ones, or from the middle of the first bar to that of the last one where there are none.
 * @param {Lesson} lesson
 */
function fall({ fps, readings }) {
  if (fps.kind === "empty") {
    const [first, ...others] = [...readings].sort((p, q) => p.phi[0].compare(q.phi[0]));
    const last = others.at(-1);
    return last !== undefined && last.middle.compare(first.middle) < 0;
  }
  const slopes = fps.vertices.map(({ theta }) => theta[0]);
  if (slopes.length === 0 || directionsOf(fps).some((direction) => direction[0].sign() > 0)) return false;
  return extremes(slopes)[1].compare(ZERO) <= 0;
}

/** @param {Lesson["fps"]} fps */
const directionsOf = ({ rays, lines }) => [...rays, ...lines, ...lines.map((line) => line.map((part) => part.negated()))];

/**
 * Whether the line has the greatest slope of all, not the least: the steepest one, unless all lines fall.
 * @param {Lesson} lesson
 * @param {WorstName} name
 */
export const isGreatest = (lesson, name) => (name === "steepest") !== fall(lesson);

/**
 * Slope and intercept of a line by hand.
 * @param {Lesson} lesson
 * @param {Rational[]} heights
 * @returns {Pair}
 */
export function lineByHand(lesson, heights) {
  const [left, right] = /** @type {Rational[]} */ (gripsOf(lesson));
  const slope = heights[1].minus(heights[0]).over(right.minus(left));
  return [slope, heights[0].minus(slope.times(left))];
}

/**
 * What keeps a line from being acceptable: the readings whose bars it misses, and the numbers of the conditions that it breaks.
 * @param {Lesson} lesson
 * @param {Pair} theta
 */
export function faultsOf(lesson, theta) {
  const broken = lesson.halfPlanes.filter(
    (halfPlane) => halfPlane.reading === null && dot(halfPlane.a, theta).compare(rightHandSide(halfPlane, ONE)) > 0,
  );
  return { missed: violations(lesson, theta, lesson.fps), broken };
}

/**
 * The vertex of the feasible parameter set with the steepest or the shallowest slope; null where there is none.
 * @param {Lesson} lesson
 * @param {WorstName} name
 */
export function worstVertex(lesson, name) {
  const { fps } = lesson;
  const isUpper = isGreatest(lesson, name);
  const sign = isUpper ? 1 : -1;
  if (fps.vertices.length === 0 || directionsOf(fps).some((direction) => direction[0].sign() === sign)) return null;
  const slopes = fps.vertices.map(({ theta }) => theta[0]);
  const best = extremes(slopes)[isUpper ? 1 : 0];
  return slopes.findIndex((slope) => slope.equals(best));
}
