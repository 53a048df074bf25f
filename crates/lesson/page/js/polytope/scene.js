// @ts-check
// What of the engine's answer a state shows.

import { ONE, Rational, ZERO, coordinate } from "../model/rational.js";
import { ParameterFrame, boundingView, scaledView } from "../planes/view.js";
import { currentExercises } from "./store.js";
import { exactPair, plainOf } from "./document.js";
import { meetingPoint, reachOf } from "./half-planes.js";

/** One unit on both axes: an angle is what it looks like. */
export const PLANE_FRAME = new ParameterFrame([ZERO, ZERO], [ONE, ONE], ZERO);

const ROOM_AROUND = 0.35;
// Farther away than this many sizes of the set nothing is worth being shown.
const FAR_AWAY = 3;
// A view narrower than this share of its distance from 0 has pixels that are one number.
const CLOSEST = 1e-10;

/** The set before anything has cut it. @type {PolytopeSetData} */
const WHOLE_PLANE = { kind: "plane", vertices: [], rays: [], lines: [["1", "0"], ["0", "1"]], boundaries: [], contradiction: null, area: null };

/**
 * The exercise that is shown, or null.
 * @param {PolytopeState} state
 */
export function shownExercise(state) {
  return state.tab === "exercises" ? currentExercises(state)[state.exercise] : null;
}

/**
 * Whether the exercise may be seen with its set: it is answered, or was explained.
 * @param {PolytopeState} state
 */
export function isSolved(state) {
  const work = state.work[state.exercise];
  return work.explained || (work.verdicts?.every((verdict) => verdict === true) ?? false);
}

/**
 * The set that is shown, the one before the step, and the step.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 */
export function shownSet(state, answer) {
  const whole = answer.set ?? WHOLE_PLANE;
  if (state.tab === "exercises" && !isSolved(state)) return { set: null, before: null, step: null };
  if (state.tab !== "clip") return { set: whole, before: null, step: null };
  const step = state.step === 0 ? null : answer.steps[state.step - 1];
  const before = state.step < 2 ? WHOLE_PLANE : answer.steps[state.step - 2].set;
  return { set: step?.set ?? WHOLE_PLANE, before: step === null ? null : before, step };
}

/**
 * How far the set reaches in the direction of the objective, as the page finds it while the engine is asked.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 * @returns {Reach}
 */
export function reachShown(state, answer) {
  const { set } = answer;
  if (set === null || set.kind === "empty") return null;
  const found = reachOf(set.vertices.map(({ theta }) => exactPair(theta)), set.rays.map(exactPair), set.lines.map(exactPair), state.objective);
  if (found !== null) return found;
  // Without a corner: the line at the end of the way, as the engine has it.
  const { objective } = answer;
  if (objective === null || objective.outcome !== "bounded") return null;
  const { face, value } = objective;
  return { value: Rational.parse(value), face: face.points.map(exactPair), direction: face.direction === null ? null : exactPair(face.direction) };
}

/**
 * The basis of the simplex method that is shown, with the one before.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 */
export function shownBases({ tab, pivot }, answer) {
  if (tab !== "simplex" || answer.simplex === null) return [];
  return answer.simplex.bases.slice(0, pivot + 1);
}

/** @param {Pair} theta */
const placeOfTheta = (theta) => theta.map(coordinate);

/**
 * The view that is shown when the reader has not chosen one: the corners of the set, or what there is instead, with room around.
 * @param {PolytopeData} answer
 * @param {boolean} isClipped whether the sets on the way to it are shown, too
 */
function fittingView(answer, isClipped) {
  const own = (answer.set?.vertices ?? []).map(({ theta }) => placeOfTheta(exactPair(theta)));
  const halfPlanes = answer.half_planes.map(plainOf).filter(({ a }) => a.some((value) => !value.isZero()));
  const corners = answer.steps.flatMap(({ set }) => set.vertices.map(({ theta }) => placeOfTheta(exactPair(theta))));
  const meets = own.length > 0 ? corners : halfPlanes.flatMap((f, i) => halfPlanes.slice(i + 1).map((g) => meetingPoint(f, g))).flatMap((at) => (at === null ? [] : [placeOfTheta(at)]));
  const feet = halfPlanes.map(({ a, b }) => {
    const [x, y] = a.map(coordinate);
    const times = coordinate(b) / (x * x + y * y);
    return [x * times, y * times];
  });
  const base = own.length > 1 ? own : [...own, ...(meets.length > 0 ? meets : [[0, 0], ...feet])];
  const near = boundingView(base.length > 0 ? base : [[0, 0]], 0);
  const size = Math.max(near.x[1] - near.x[0], near.y[1] - near.y[0]);
  const reach = (size || 1) * FAR_AWAY;
  const seen = meets.filter(([x, y]) => Math.abs(x - near.x[0]) < reach && Math.abs(y - near.y[0]) < reach && (isClipped || own.length < 2));
  const view = boundingView([...base, ...seen], 0);
  const wide = Math.max(view.x[1] - view.x[0], view.y[1] - view.y[0]) || 4;
  return widened(view, wide);
}

/**
 * At least a quarter as high as wide, and the other way round, with room.
 * @param {View} view
 * @param {number} wide
 * @returns {View}
 */
function widened({ x, y }, wide) {
  /** @param {number[]} range */
  const range = ([low, high]) => {
    const room = Math.max(0, wide / 4 - (high - low)) / 2 + wide * ROOM_AROUND;
    return [low - room, high + room];
  };
  return { x: range(x), y: range(y) };
}

/**
 * A view in which both axes have one unit, in a drawing area.
 * @param {View} view
 * @param {Area} area
 * @returns {View}
 */
function squared(view, { width, height }) {
  const [wide, high] = [view.x[1] - view.x[0], view.y[1] - view.y[0]];
  const far = Math.max(...[...view.x, ...view.y].map(Math.abs));
  const unit = Math.max(wide / width, high / height, (far * CLOSEST) / width);
  const [cx, cy] = [(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2];
  return { x: [cx - (unit * width) / 2, cx + (unit * width) / 2], y: [cy - (unit * height) / 2, cy + (unit * height) / 2] };
}

/**
 * The part of the plane that is shown.
 * @param {PolytopeState} state
 * @param {Area} area
 */
export function planeView(state, area) {
  const view = state.view ?? (state.answer === null ? { x: [-5, 5], y: [-5, 5] } : fittingView(state.answer, state.tab === "clip"));
  return squared(state.tab === "clip" && state.view === null && state.step === 0 ? scaledView(view, 1.4) : view, area);
}

/**
 * The grid that the pointer snaps to: 1, 2 or 5 times a power of ten, about a fortieth of the view.
 * @param {View} view
 */
export function snapUnit(view) {
  const rough = (view.x[1] - view.x[0]) / 40;
  const exponent = Math.floor(Math.log10(rough));
  const factor = [1, 2, 5, 10].find((own) => rough <= own * 10 ** exponent) ?? 10;
  const power = 10n ** BigInt(Math.abs(exponent));
  return exponent < 0 ? new Rational(BigInt(factor), power) : new Rational(BigInt(factor) * power);
}

/**
 * The nearest point of the grid.
 * @param {Place} place
 * @param {Rational} unit
 * @returns {Pair}
 */
export function snapped(place, unit) {
  return place.map((number) => Rational.fromNumber(number).roundedTo(unit));
}
