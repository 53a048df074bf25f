// @ts-check
// What is under the pointer, the focus or the last click, explained.

import { byId, element, patch } from "../dom.js";
import { activeAt, boundAt, conflict, demands, hopeless, readingOfRow, violations } from "../model/lesson.js";
import { THETA, boundText, conditionNumber, decimal, digitsFor, enumeration, plain, shortEnumeration, shortFraction, theBound, vertexName } from "../model/format.js";
import { numberWithFraction } from "./summary.js";
import { ONE, dot } from "../model/rational.js";

const MOST_ROWS = 12;
// A chosen point has a short decimal: it is shown in full.
const ALL_DIGITS = 40;

/**
 * @param {Pair} theta
 * @param {(value: Rational, axis: number) => number} digits
 */
function thetaList(theta, digits) {
  return element(
    "dl",
    { class: "theta" },
    theta.map((value, axis) => [
      element("dt", {}, THETA[axis]),
      element("dd", {}, numberWithFraction(value, decimal(value, digits(value, axis)))),
    ]),
  );
}

/**
 * "θ₁·(−6.9) + θ₂" with the numbers of a reading.
 * @param {Lesson} lesson
 * @param {Reading} reading
 */
function form(lesson, reading) {
  const first = plain(reading.phi[0]);
  if (lesson.isLine) return `θ₁·(${first}) + θ₂`;
  return `θ₁·(${first}) + θ₂·(${plain(reading.phi[1])})`;
}

/**
 * The inequality of a half-plane in the numbers of its reading.
 * @param {Lesson} lesson
 * @param {HalfPlane} halfPlane
 * @param {Rational} s
 */
export function inequality(lesson, halfPlane, s) {
  if (halfPlane.reading === null)
    return lesson.data.conditions[conditionNumber(halfPlane.name) - 1].text;
  const { reading } = halfPlane;
  const upper = halfPlane.name.bound === "upper";
  const end = boundAt(reading, upper ? "upper" : "lower", s) ?? halfPlane.b;
  return `${form(lesson, reading)} ${upper ? "≤" : "≥"} ${plain(end)}`;
}

/**
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {number} index
 */
function aboutVertex(lesson, scene, index) {
  const names = activeAt(lesson, scene.region, index);
  const ends = names.map((name) => {
    if (name.row === null) return boundText(name);
    const reading = readingOfRow(lesson, name.row);
    const end = plain(boundAt(reading, name.bound === "upper" ? "upper" : "lower", scene.s) ?? reading.y);
    const isAroundY = reading.fixed === null && reading.middle.equals(reading.y);
    const sum = isAroundY ? `${lesson.data.model.y} ${name.bound === "upper" ? "+" : "−"} ε = ` : "";
    return `the ${name.bound} end of reading ${name.row} (${sum}${end})`;
  });
  const what = lesson.isLine ? "Its line passes exactly through " : "Its prediction meets exactly ";
  return [
    element("h3", {}, `Vertex ${vertexName(index)}`),
    thetaList(scene.region.vertices[index].theta, (value, axis) => digitsFor(value, scene.frame.units[axis])),
    element(
      "p",
      {},
      what,
      shortEnumeration(ends),
      ". ",
      names.length === 2
        ? "These two half-planes are active here: their boundaries cross in the vertex."
        : `${names.length} half-planes are active here.`,
    ),
  ];
}

/**
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {number} row
 */
function aboutReading(lesson, scene, row) {
  const reading = readingOfRow(lesson, row);
  const bounds = [reading.halfPlanes.upper, reading.halfPlanes.lower].filter((index) => index !== null);
  const where = scene.region.vertices.flatMap((_, index) =>
    activeAt(lesson, scene.region, index).some((name) => name.row === row) ? [vertexName(index)] : [],
  );
  return [
    element("h3", {}, `Reading ${row}`),
    element("p", {}, `The reading allows the ${bounds.length === 2 ? "strip" : "half-plane"} of parameters with`),
    ...bounds.map((index) =>
      element("p", { class: "formula" }, inequality(lesson, lesson.halfPlanes[index], scene.s)),
    ),
    element(
      "p",
      {},
      lesson.matters.get(row)
        ? "It matters: without it the FPS would be larger. "
        : "It does not matter: without it the FPS stays the same. ",
      where.length > 0
        ? `Active at ${where.length === 1 ? "vertex" : "vertices"} ${enumeration(where)}.`
        : "It is active at no vertex shown.",
    ),
  ];
}

/**
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {PointChoice} choice
 */
function aboutPoint(lesson, scene, choice) {
  const broken = violations(lesson, choice.theta, scene.s);
  const conditions = lesson.halfPlanes.filter(
    (h) => h.reading === null && dot(h.a, choice.theta).compare(h.b) > 0,
  );
  const rows = broken
    .slice(0, MOST_ROWS)
    .map(({ reading, above }) => `${reading.row} (${above ? "above" : "below"})`);
  if (broken.length > MOST_ROWS) rows.push(`${broken.length - MOST_ROWS} more`);
  const whose = lesson.isLine ? "its line" : "its predictions";
  const far = `${broken.length} of ${lesson.readings.length} readings ${broken.length === 1 ? "lies" : "lie"} farther than ε from ${whose}: reading ${enumeration(rows)}`;
  const breaks = `it breaks ${enumeration(conditions.map((h) => inequality(lesson, h, scene.s)))}`;
  const faults = [broken.length > 0 && far, conditions.length > 0 && breaks].filter(Boolean);
  return [
    element("h3", {}, lesson.isLine ? "A point and its line" : "A point and its predictions"),
    thetaList(choice.theta, () => ALL_DIGITS),
    element(
      "p",
      { id: "violations", "data-count": broken.length },
      faults.length > 0
        ? `Not feasible: ${faults.join("; ")}.`
        : `Feasible: it agrees with all ${demands(lesson)}${scene.s.equals(ONE) ? "" : ", with these error bounds"}.`,
    ),
  ];
}

/**
 * Positive multiples of the half-planes in conflict add up to 0 ≤ something negative.
 * @param {Lesson} lesson
 */
function aboutConflict(lesson) {
  const terms = conflict(lesson);
  const { conditions } = lesson.data;
  /**
   * @param {{ index: number }} options
   * @param {(name: BoundName) => string} text
   */
  const named = ({ index }, text) => {
    const { name, reading } = lesson.halfPlanes[index];
    return reading === null
      ? `${text(name)} (${conditions[conditionNumber(name) - 1].text})`
      : text(name);
  };
  const what = enumeration(terms.map((term) => named(term, theBound)));
  const sum = terms
    .map(({ index, multiplier }) => {
      const { name } = lesson.halfPlanes[index];
      return `${shortFraction(multiplier.exact)} × (${boundText(name)})`;
    })
    .join(" + ");
  const proof = terms.length === 1 ? "says that 0" : "adds up to 0";
  return [
    element("h3", {}, "Why the set is empty"),
    element(
      "p",
      { id: "conflict" },
      `No θ satisfies ${terms.length === 1 ? "" : "all of these together: "}${what}. The proof: ${sum} ${proof} ≤ a negative number.`,
    ),
    element("p", { id: "conflict-cause" }, causeOfConflict(lesson)),
  ];
}

/** @param {Lesson} lesson */
function causeOfConflict(lesson) {
  const without = hopeless(lesson);
  if (without !== null) return without;
  const faulty = lesson.data.conditions.length > 0 ? "a reading or a condition is" : "a reading is";
  return `So the error bound is too small, the model is wrong, or ${faulty}. Change ε to see where the set is born.`;
}

/**
 * Draws the explanation of the choice, or a hint.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 * @param {Choice | null} choice
 */
export function drawInspector(lesson, state, scene, choice) {
  const none =
    state.mode !== "explore"
      ? []
      : lesson.fps.kind === "empty"
        ? aboutConflict(lesson)
        : [
            element("h3", { class: "for-screen" }, "Look closer"),
            element(
              "p",
              { class: "for-screen" },
              "Point at a vertex, a reading or anywhere in the parameter plane, or reach them with the Tab and arrow keys: what belongs together lights up in both pictures, and is explained here. A click keeps it.",
            ),
          ];
  const gone = choice?.kind === "vertex" && choice.index >= scene.region.vertices.length;
  patch(
    byId("inspector"),
    choice === null || gone
      ? none
      : choice.kind === "vertex"
        ? aboutVertex(lesson, scene, choice.index)
        : choice.kind === "reading"
          ? aboutReading(lesson, scene, choice.row)
          : aboutPoint(lesson, scene, choice),
  );
}
