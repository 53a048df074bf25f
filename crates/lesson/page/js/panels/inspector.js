// @ts-check
// What is under the pointer, the focus or the last click, explained.

import { byId, element, patch } from "../dom.js";
import { activeAt, boundAt, conflict, demands, halfPlanesOf, hopeless, readingOfRow, violations } from "../model/lesson.js";
import { boundText, conditionNumber, decimal, digitsFor, enumeration, plain, shortFraction, shortList, theBound, thetaName, vertexName } from "../model/format.js";
import { numberWithFraction } from "./summary.js";
import { ONE, dot } from "../model/rational.js";
import { formulaText, t } from "../texts.js";

const MOST_ROWS = 12;
// A chosen point has a short decimal: it is shown in full.
const ALL_DIGITS = 40;

/**
 * @param {Lesson} lesson
 * @param {Pair} theta
 * @param {(value: Rational, axis: number) => number} digits
 */
function thetaList(lesson, theta, digits) {
  return element(
    "dl",
    { class: "theta" },
    theta.map((value, axis) => [
      element("dt", {}, thetaName(lesson, axis)),
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
  const [first, second] = reading.phi.map((value, k) => plain(value, lesson.widths.phi[k]));
  if (lesson.isLine) return `θ₁·(${first}) + θ₂`;
  return `θ₁·(${first}) + θ₂·(${second})`;
}

/**
 * What tells an end of a reading from others: its bound, which may be much smaller than its y.
 * @param {Lesson} lesson
 * @param {Reading} reading
 */
function endWidth(lesson, reading) {
  return reading.epsilon.isZero() ? lesson.widths.y : reading.epsilon;
}

/**
 * The inequality of a half-plane in the numbers of its reading.
 * @param {Lesson} lesson
 * @param {HalfPlane} halfPlane
 * @param {Rational} s
 */
export function inequality(lesson, halfPlane, s) {
  if (halfPlane.reading === null)
    return formulaText(lesson.data.conditions[conditionNumber(halfPlane.name) - 1].text);
  const { reading } = halfPlane;
  const upper = halfPlane.name.bound === "upper";
  const end = boundAt(reading, upper ? "upper" : "lower", s) ?? halfPlane.b;
  return `${form(lesson, reading)} ${upper ? "≤" : "≥"} ${plain(end, endWidth(lesson, reading))}`;
}

/**
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {number} index
 */
function aboutVertex(lesson, scene, index) {
  const names = activeAt(lesson, scene.region, index);
  const ends = names.map((name) => {
    if (name.row === null) return theBound(name);
    const isUpper = name.bound === "upper";
    const reading = readingOfRow(lesson, name.row);
    const end = plain(boundAt(reading, isUpper ? "upper" : "lower", scene.s) ?? reading.y, endWidth(lesson, reading));
    const isAroundY = reading.fixed === null && reading.middle.equals(reading.y);
    const sum = isAroundY ? `${lesson.data.model.y} ${isUpper ? "+" : "−"} ε = ` : "";
    return t(isUpper ? "vertex.end-upper" : "vertex.end-lower", { row: name.row, sum, end });
  });
  const passes = lesson.isLine ? "vertex.line" : "vertex.prediction";
  return [
    element("h3", {}, t("vertex.title", { vertex: vertexName(index) })),
    thetaList(lesson, scene.region.vertices[index].theta, (value, axis) => digitsFor(value, scene.frame.units[axis])),
    element(
      "p",
      {},
      t(passes, { ends: shortList(ends) }),
      " ",
      names.length === 2 ? t("vertex.two") : t("vertex.many", { count: names.length }),
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
    element("h3", {}, t("reading.title", { row })),
    element("p", {}, t("reading.allows", { bounds: bounds.length })),
    ...bounds.map((index) =>
      element("p", { class: "formula" }, inequality(lesson, lesson.halfPlanes[index], scene.s)),
    ),
    element(
      "p",
      {},
      t(lesson.matters.get(row) ? "reading.matters" : "reading.idle"),
      " ",
      where.length > 0 ? t("reading.active", { vertices: { list: where } }) : t("reading.inactive"),
    ),
  ];
}

/**
 * What a feasible point agrees with: of the half-planes of the lesson those that are in the region.
 * @param {Lesson} lesson
 * @param {Region} region
 */
function feasible(lesson, { without, among, s }) {
  if (among !== null) return t("point.feasible-so-far");
  if (without.length > 0) return t("point.feasible-without", { rows: shortList(without) });
  return t(s.equals(ONE) ? "point.feasible" : "point.feasible-here", { demands: demands(lesson) });
}

/**
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {PointChoice} choice
 */
function aboutPoint(lesson, scene, choice) {
  const { region } = scene;
  const broken = violations(lesson, choice.theta, region);
  const there = halfPlanesOf(lesson, region);
  const conditions = there.filter((h) => h.reading === null && dot(h.a, choice.theta).compare(h.b) > 0);
  const rows = broken
    .slice(0, MOST_ROWS)
    .map(({ reading, above }) => t(above ? "point.above" : "point.below", { row: reading.row }));
  const far = t(lesson.isLine ? "point.far-line" : "point.far-two", {
    count: broken.length,
    all: new Set(there.flatMap((h) => h.reading ?? [])).size,
    rows: { list: rows, more: Math.max(0, broken.length - MOST_ROWS) },
  });
  const breaks = t("point.breaks", { conditions: { list: conditions.map((h) => inequality(lesson, h, scene.s)) } });
  const faults = [broken.length > 0 && far, conditions.length > 0 && breaks].filter(Boolean);
  return [
    element("h3", {}, t(lesson.isLine ? "point.line" : "point.two")),
    thetaList(lesson, choice.theta, () => ALL_DIGITS),
    element(
      "p",
      { id: "violations", "data-count": broken.length },
      faults.length > 0
        ? t("point.infeasible", { faults: faults.join("; ") })
        : feasible(lesson, region),
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
      ? `${text(name)} (${formulaText(conditions[conditionNumber(name) - 1].text)})`
      : text(name);
  };
  const what = enumeration(terms.map((term) => named(term, theBound)));
  const sum = terms
    .map(({ index, multiplier }) => {
      const { name } = lesson.halfPlanes[index];
      return `${shortFraction(multiplier.exact)} × (${boundText(name)})`;
    })
    .join(" + ");
  return [
    element("h3", {}, t("conflict.title")),
    element(
      "p",
      { id: "conflict" },
      t(terms.length === 1 ? "conflict.alone" : "conflict.together", { bounds: what, sum }),
    ),
    element("p", { id: "conflict-cause" }, causeOfConflict(lesson)),
  ];
}

/** @param {Lesson} lesson */
function causeOfConflict(lesson) {
  const without = hopeless(lesson);
  if (without !== null) return without;
  return t("conflict.cause", { conditions: lesson.data.conditions.length });
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
            element("h3", { class: "for-screen" }, t("inspector.title")),
            element(
              "p",
              { class: "for-screen" },
              t("inspector.hint"),
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
