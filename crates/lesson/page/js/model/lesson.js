// @ts-check
// The engine's document, made convenient: exact numbers parsed, and every region in one form whichever part of the
// document it comes from.

import { numberText, said, t } from "../texts.js";
import { intersection } from "./intersection.js";
import { ONE, Rational, ZERO, dot, evaluate, extremes } from "./rational.js";

/** @param {Exact | NumberData} number */
const exactOf = (number) => Rational.parse(typeof number === "string" ? number : number.exact);
/** @param {(Exact | NumberData)[]} pair */
const pairOf = (pair) => pair.map(exactOf);

/**
 * Reads the document.
 * @param {LessonData} data
 */
export function readLesson(data) {
  const readings = data.readings.map((reading, index) => ({
    index,
    row: reading.row,
    phi: pairOf(reading.phi),
    y: exactOf(reading.y),
    middle: exactOf(reading.middle ?? reading.y),
    // Bounds that do not grow with the others are what they are at every factor.
    epsilon: reading.epsilon ? exactOf(reading.epsilon) : ZERO,
    fixed: reading.epsilon
      ? null
      : { upper: reading.upper ? exactOf(reading.upper) : null, lower: reading.lower ? exactOf(reading.lower) : null },
    /** @type {{ upper: number | null, lower: number | null }} */
    halfPlanes: { upper: null, lower: null },
  }));
  const lesson = /** @type {Lesson} */ ({
    data,
    readings,
    others: data.others.map((other) => ({ row: other.row, phi: pairOf(other.phi), y: exactOf(other.y) })),
    isLine: data.model.kind === "line",
    halfPlanes: data.half_planes.map((halfPlane, index) => ({
      index,
      name: halfPlane.name,
      irredundant: halfPlane.irredundant,
      a: pairOf(halfPlane.a),
      b: exactOf(halfPlane.b),
      reading: /** @type {Reading | null} */ (null),
    })),
    points: data.points.map(pairOf),
    rowIndex: new Map(readings.map((reading) => [reading.row, reading.index])),
    widths: { phi: [0, 1].map((k) => columnWidth(readings.map(({ phi }) => phi[k]))), y: columnWidth(readings.map(({ y }) => y)) },
  });
  for (const halfPlane of lesson.halfPlanes) {
    const { row, bound } = halfPlane.name;
    if (row === null) continue;
    halfPlane.reading = readingOfRow(lesson, row);
    halfPlane.reading.halfPlanes[bound === "upper" ? "upper" : "lower"] = halfPlane.index;
  }
  lesson.fps = regionOf(lesson, data.fit.fps);
  lesson.matters = new Map(data.leave_one_out.map((entry) => [entry.row, entry.matters]));
  lesson.leastSquares = data.fit.least_squares === null ? null : pairOf(data.fit.least_squares.theta);
  lesson.reference = referenceLine(lesson);
  // The one error bound of all readings, as a coordinate; null when each has its own, or when there is no error at all.
  const { uniform } = data.epsilon;
  lesson.epsilon = uniform === null || uniform.exact === "0" ? null : exactOf(uniform);
  return lesson;
}

/**
 * How far values lie apart; 0 for none.
 * @param {Rational[]} values
 */
function columnWidth(values) {
  if (values.length === 0) return ZERO;
  const [least, most] = extremes(values);
  return most.minus(least);
}

/**
 * The reading of a row that is fitted.
 * @param {Lesson} lesson
 * @param {number} row
 */
export function readingOfRow(lesson, row) {
  return lesson.readings[/** @type {number} */ (lesson.rowIndex.get(row))];
}

/**
 * Index of the half-plane with a name.
 * @param {Lesson} lesson
 * @param {BoundName} name
 */
export function halfPlaneIndex(lesson, name) {
  if (name.row === null)
    return lesson.data.half_planes.findIndex((own) => own.name.row === null && own.name.bound === name.bound);
  return readingOfRow(lesson, name.row).halfPlanes[name.bound === "upper" ? "upper" : "lower"] ?? -1;
}

/**
 * The bound of a reading on one side when every error bound is multiplied by s; null where there is none.
 * @param {Reading} reading
 * @param {"upper" | "lower"} bound
 * @param {Rational} s
 */
export function boundAt(reading, bound, s) {
  if (reading.fixed !== null) return reading.fixed[bound];
  const half = reading.epsilon.times(s);
  return bound === "upper" ? reading.middle.plus(half) : reading.middle.minus(half);
}

/**
 * Heights are drawn relative to this line when error bars are too short to see.
 * @param {Lesson} lesson
 */
function referenceLine(lesson) {
  const { central, minimax } = lesson.data.fit;
  if (lesson.leastSquares !== null) return { theta: lesson.leastSquares, name: "least-squares" };
  if (central !== null) return { theta: pairOf(central.theta), name: "central" };
  if (minimax !== null) return { theta: pairOf(minimax.theta), name: "minimax" };
  return null;
}

/**
 * @param {Lesson} lesson
 * @param {RegionSource} source
 * @param {{ s?: Rational, without?: number[], among?: number[] | null }} [options]
 * @returns {Region}
 */
function regionOf(lesson, source, { s = ONE, without = [], among = null } = {}) {
  const vertices = source.vertices.map((vertex) => {
    if (typeof vertex === "number") return { theta: lesson.points[vertex], active: null };
    return { theta: vertex.theta.map(exactOf), active: vertex.active };
  });
  // A side of a region without vertices comes as an index or with the names active along it.
  /** @param {number | { active: BoundName[] }} boundary */
  const side = (boundary) =>
    typeof boundary === "number" ? boundary : halfPlaneIndex(lesson, boundary.active[0]);
  return {
    kind: source.kind,
    vertices,
    rays: source.rays.map(pairOf),
    lines: source.lines.map(pairOf),
    s,
    boundaries: source.boundaries.map(side),
    without,
    among,
  };
}

/**
 * The right-hand side of a half-plane when every error bound is multiplied by s.
 * @param {HalfPlane} halfPlane
 * @param {Rational} s
 */
export function rightHandSide(halfPlane, s) {
  if (halfPlane.reading === null || s.equals(ONE)) return halfPlane.b;
  // The engine may have scaled the half-plane: compare it with the reading it comes from.
  const { phi, epsilon } = halfPlane.reading;
  const axis = phi[0].isZero() ? 1 : 0;
  if (phi[axis].isZero()) return halfPlane.b;
  const scale = halfPlane.a[axis].over(phi[axis]).absolute();
  return halfPlane.b.plus(scale.times(epsilon).times(s.minus(ONE)));
}

/**
 * The half-planes that shape a region: all of them, without those of a row switched off or not yet added.
 * @param {Lesson} lesson
 * @param {Region} region
 */
export function halfPlanesOf(lesson, region) {
  const all =
    region.among === null ? lesson.halfPlanes : region.among.map((index) => lesson.halfPlanes[index]);
  return all.filter((halfPlane) => halfPlane.name.row === null || !region.without.includes(halfPlane.name.row));
}

/**
 * The region after `count` steps of clipping in an order of the engine; the whole plane after none.
 * @param {Lesson} lesson
 * @param {OrderData} order
 * @param {number} count
 */
export function steppedRegion(lesson, order, count) {
  const among = order.steps.slice(0, count).map((step) => step.half_plane);
  if (count > 0) return regionOf(lesson, order.steps[count - 1], { among });
  const axes = [
    ["1", "0"],
    ["0", "1"],
  ];
  return regionOf(lesson, { kind: "plane", vertices: [], rays: [], lines: axes, boundaries: [] }, { among });
}

/**
 * The sweep of a lesson that has stops.
 * @param {Lesson} lesson
 */
export function sweepOf(lesson) {
  return /** @type {SweepData} */ (lesson.data.sweep);
}

/**
 * The part of the sweep that a stop belongs to: a breakpoint, or the piece that holds it.
 * @param {Lesson} lesson
 * @param {Stop} stop
 */
export function partOf(lesson, stop) {
  const { breakpoints, pieces } = sweepOf(lesson);
  return stop.breakpoint === null ? pieces[/** @type {number} */ (stop.piece)] : breakpoints[stop.breakpoint];
}

/**
 * The vertices of a part of the sweep at a factor.
 * @param {Lesson} lesson
 * @param {{ vertices: number[] }} part
 * @param {Rational} s
 * @returns {Pair[]}
 */
export function verticesAt(lesson, part, s) {
  const paths = sweepOf(lesson).vertices;
  return part.vertices.map((index) => paths[index].map((path) => evaluate(path, s)));
}

/**
 * The region with every error bound multiplied by the s of a stop.
 * @param {Lesson} lesson
 * @param {Stop} stop
 */
export function sweptRegion(lesson, stop) {
  const { s } = stop;
  const part = partOf(lesson, stop);
  const vertices = verticesAt(lesson, part, s).map((theta) => ({ theta, active: null }));
  return { ...regionOf(lesson, { ...part, vertices: [] }, { s }), vertices };
}

/**
 * The region when some rows are switched off: of one row as the engine has it, of several computed here.
 * @param {Lesson} lesson
 * @param {number[]} rows
 * @returns {Region}
 */
export function regionWithout(lesson, rows) {
  const entry = rows.length === 1 ? lesson.data.leave_one_out.find(({ row }) => row === rows[0]) : undefined;
  if (entry !== undefined) return regionOf(lesson, entry, { without: rows });
  const left = lesson.halfPlanes.filter(({ name }) => name.row === null || !rows.includes(name.row));
  const found = intersection(left);
  const vertices = found.vertices.map((theta) => ({ theta, active: null }));
  return { ...found, vertices, s: ONE, without: rows, among: null };
}

/**
 * Names of the half-planes active at vertex `index`: exactly those with equality there.
 * @param {Lesson} lesson
 * @param {Region} region
 * @param {number} index
 */
export function activeAt(lesson, region, index) {
  const vertex = region.vertices[index];
  vertex.active ??= halfPlanesOf(lesson, region)
    .filter((h) => !h.a.every((a) => a.isZero()))
    .filter((h) => dot(h.a, vertex.theta).equals(rightHandSide(h, region.s)))
    .map((h) => h.name);
  return vertex.active;
}

/**
 * @param {HalfPlane} one
 * @param {HalfPlane} other
 */
function isParallel(one, other) {
  return one.a[0].times(other.a[1]).equals(one.a[1].times(other.a[0]));
}

/**
 * Names of the half-planes whose boundary is the whole line that bounds a region without vertices.
 * @param {Lesson} lesson
 * @param {Region} region
 * @param {number} index one of these half-planes
 */
export function activeAlong(lesson, region, index) {
  const side = lesson.halfPlanes[index];
  const point = pointOnBoundary(side, region.s);
  return halfPlanesOf(lesson, region)
    .filter((h) => !h.a.every((a) => a.isZero()) && isParallel(h, side))
    .filter((h) => dot(h.a, point).equals(rightHandSide(h, region.s)))
    .map((h) => h.name);
}

/**
 * The half-planes that cannot hold together, with the multipliers that prove it; [] when the FPS is not empty.
 * @param {Lesson} lesson
 */
export function conflict(lesson) {
  const terms = lesson.data.fit.fps.certificate?.farkas ?? [];
  return terms.map((term) => ({ index: halfPlaneIndex(lesson, term), multiplier: term.multiplier }));
}

/**
 * What contradicts itself does so with smaller error bounds, too, and conditions do with any.
 * @param {Lesson} lesson
 * @param {Region} region
 */
function isStillInConflict(lesson, { among, without, s }) {
  if (among !== null || without.length > 0) return false;
  return s.compare(ONE) <= 0 || conflict(lesson).every(({ index }) => lesson.halfPlanes[index].reading === null);
}

/**
 * Why no factor on the error bounds leaves a feasible parameter, as a sentence; null where one does.
 * @param {Lesson} lesson
 */
export function hopeless(lesson) {
  const { conditions, fit, sweep } = lesson.data;
  if (sweep?.least) return null;
  if (fit.minimax !== null)
    return t("hopeless.zero", { least: numberText(fit.minimax.epsilon?.decimal ?? t("hopeless.greater")) });
  const fixed = lesson.readings.some((reading) => reading.epsilon.isZero());
  if (fixed) return t("hopeless.fixed");
  return t("hopeless.conditions", { conditions: conditions.length });
}

/**
 * What every parameter has to agree with, in words.
 * @param {Lesson} lesson
 */
export function demands(lesson) {
  const { conditions } = lesson.data;
  const words = [];
  if (lesson.readings.length > 0) words.push(t("demand.readings"));
  if (conditions.length > 0) words.push(t("demand.conditions", { count: conditions.length }));
  return said({ list: words });
}

/**
 * Indices of the half-planes without which the region would be another one, or, where many meet in a point, those.
 * @param {Lesson} lesson
 * @param {Region} region
 */
export function shapingHalfPlanes(lesson, region) {
  if (region.kind === "empty" && isStillInConflict(lesson, region))
    return new Set(conflict(lesson).map(({ index }) => index));
  if (region === lesson.fps)
    return new Set(lesson.halfPlanes.filter((h) => h.irredundant).map((h) => h.index));
  const met = new Map();
  region.vertices.forEach((_, index) => {
    for (const name of activeAt(lesson, region, index)) {
      const found = halfPlaneIndex(lesson, name);
      met.set(found, (met.get(found) ?? 0) + 1);
    }
  });
  // An edge of a polygon has two vertices; what meets only one of them merely touches.
  const least = region.kind === "polygon" ? 2 : 1;
  return new Set([
    ...region.boundaries,
    ...[...met].filter(([, count]) => count >= least).map(([index]) => index),
  ]);
}

/**
 * The readings that a parameter point violates by their half-planes in a region, with its error bounds, and by how much.
 * @param {Lesson} lesson
 * @param {Pair} theta
 * @param {Region} region
 */
export function violations(lesson, theta, region) {
  const { s, without } = region;
  const among = region.among === null ? null : new Set(region.among);
  return lesson.readings.flatMap((reading) => {
    if (without.includes(reading.row)) return [];
    /** @param {"upper" | "lower"} bound */
    const end = (bound) => (among !== null && !among.has(reading.halfPlanes[bound] ?? -1) ? null : boundAt(reading, bound, s));
    const value = dot(reading.phi, theta);
    const [upper, lower] = [end("upper"), end("lower")];
    const over = upper === null ? ZERO : value.minus(upper);
    const under = lower === null ? ZERO : lower.minus(value);
    const above = under.compare(over) > 0;
    const excess = above ? under : over;
    return excess.sign() > 0 ? [{ reading, excess, above }] : [];
  });
}

/**
 * An exact point on the boundary of a half-plane, for regions that have no vertices to start from.
 * @param {HalfPlane} halfPlane
 * @param {Rational} s
 */
export function pointOnBoundary(halfPlane, s) {
  const { a } = halfPlane;
  const axis = a[1].isZero() ? 0 : 1;
  const value = rightHandSide(halfPlane, s).over(a[axis]);
  return axis === 0 ? [value, ZERO] : [ZERO, value];
}

/**
 * Exact ends of a region along each parameter: [{lower, upper}, {…}] with null for infinite; null when empty.
 * @param {Region} region
 */
export function boundsOf(region) {
  if (region.kind === "empty") return null;
  return [0, 1].map((axis) => {
    /** @param {number} sign */
    const goes = (sign) =>
      region.rays.some((ray) => ray[axis].sign() === sign) ||
      region.lines.some((line) => !line[axis].isZero());
    const values = region.vertices.map((vertex) => vertex.theta[axis]);
    const [least, greatest] = values.length === 0 ? [null, null] : extremes(values);
    return { lower: goes(-1) ? null : least, upper: goes(1) ? null : greatest };
  });
}
