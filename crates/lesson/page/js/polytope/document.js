// @ts-check
// The engine's document of half-planes, as the page reads it.

import { ONE, Rational } from "../model/rational.js";
import { fractionText, halfPlaneText } from "./half-planes.js";

/**
 * @param {Exact[]} texts
 * @returns {Pair}
 */
export function exactPair(texts) {
  return texts.map((text) => Rational.parse(text));
}

/**
 * A half-plane with exact numbers.
 * @param {PolytopeHalfPlaneData} halfPlane
 * @returns {PlainHalfPlane}
 */
export function plainOf({ a, b }) {
  return { a: exactPair(a), b: Rational.parse(b) };
}

/**
 * "(3)", and of the two half-planes of an equation "(3 ≤)" and "(3 ≥)".
 * @param {PolytopeData} answer
 * @param {number} index
 */
export function planeName(answer, index) {
  const { number, side } = answer.half_planes[index];
  return side === null ? `(${number})` : `(${number}\u00a0${side === "upper" ? "≤" : "≥"})`;
}

/**
 * "−x ≤ 0": the form that multipliers are about.
 * @param {PolytopeHalfPlaneData} halfPlane
 */
export function atMostText(halfPlane) {
  return halfPlaneText(plainOf(halfPlane), false, true);
}

/**
 * "3/5·(1) + 1/5·(4)".
 * @param {PolytopeData} answer
 * @param {PolytopeMultiplierData[]} terms
 */
export function sumText(answer, terms) {
  if (terms.length === 0) return "0";
  return terms.map(({ half_plane, multiplier }) => `${fractionText(Rational.parse(multiplier))}·${planeName(answer, half_plane)}`).join(" + ");
}

/**
 * What the drawing modules need of the half-planes: their exact numbers.
 * @param {PolytopeData} answer
 */
export function drawnHalfPlanes(answer) {
  const halfPlanes = answer.half_planes.map((own) => ({ ...plainOf(own), reading: null }));
  return /** @type {Lesson} */ (/** @type {unknown} */ ({ halfPlanes }));
}

/**
 * A set of the document as a region that can be drawn.
 * @param {PolytopeSetData} set
 * @returns {Region}
 */
export function drawnRegion(set) {
  return {
    kind: set.kind,
    vertices: set.vertices.map(({ theta }) => ({ theta: exactPair(theta), active: null })),
    rays: set.rays.map(exactPair),
    lines: set.lines.map(exactPair),
    s: ONE,
    boundaries: set.boundaries.map(([first]) => first),
    without: [],
    among: null,
  };
}
