// @ts-check
// Which part of the parameter plane is shown when the reader has not chosen one.

import { lineInView } from "./region.js";
import { worstPlaces } from "./worst-lines.js";
import { boundingView, leapingView, scaledView } from "./view.js";
import { conflict } from "../model/lesson.js";
import { decimalPower } from "../model/rational.js";

const MOST_LEAPS = 9;
const ROOM = 0.45;
// In a view that holds something so far away, nothing else could be told apart.
const OUT_OF_REACH = 1e12;

/**
 * The view that is shown when the reader has not chosen one.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 * @param {Layer[]} layers
 */
export function automaticView(lesson, state, scene, layers) {
  const base = scaledView(
    boundingView(
      lesson.fps.vertices.map((v) => scene.frame.place(v.theta)).concat(middle(lesson, scene.frame)),
      0,
    ),
    1 + 2 * ROOM,
  );
  const sized = ensureSize(base);
  if (state.mode === "explore") {
    const shown = layers.filter((layer) => state.layers.has(layer.id));
    const points = shown
      .flatMap((layer) => [...(layer.polygon ?? []), ...layer.points])
      .map((p) => scene.frame.place(p))
      .filter((place) => Math.hypot(...place) < OUT_OF_REACH);
    if (!holds(sized, points))
      return boundingView([...points, ...cornersOfView(scaledView(sized, 0.7))], 0.12);
    // A chosen reading is worth nothing without the sides of its strip.
    const sides = scene.lines.filter(
      ({ halfPlane }) => state.selection?.kind === "reading" && halfPlane.name.row === state.selection.row,
    );
    return leapingView(
      sized,
      (view) => sides.every(({ line }) => lineInView(line, scaledView(view, 0.9)) !== null),
      MOST_LEAPS,
    );
  }
  if (state.mode === "clip" && state.step === 0) return scaledView(sized, 4);
  const before = state.mode === "clip" && scene.before !== null ? scene.before.vertices : [];
  const lines = worstPlaces(lesson, state, scene.frame).map(({ place }) => place);
  const points = [...scene.places, ...before.map((vertex) => scene.frame.place(vertex.theta)), ...lines];
  const start = points.length === 0 && state.mode === "clip" ? scaledView(sized, 4) : sized;
  return leapingView(start, (view) => holds(view, points), MOST_LEAPS);
}

/**
 * @param {View} view
 * @param {Place[]} points
 */
function holds({ x, y }, points) {
  return points.every(
    (point) => point[0] >= x[0] && point[0] <= x[1] && point[1] >= y[0] && point[1] <= y[1],
  );
}

/**
 * Without vertices, what there is to see are the sides nearest to the middle of the frame; of an empty set, the
 * boundaries that contradict each other.
 * @param {Lesson} lesson
 * @param {ParameterFrame} frame
 */
function middle(lesson, frame) {
  if (lesson.fps.vertices.length > 0) return [];
  const indices = [...lesson.fps.boundaries, ...conflict(lesson).map(({ index }) => index)];
  const sides = indices.map((index) => lesson.halfPlanes[index]).map(({ a, b }) => frame.halfPlane(a, b));
  const feet = sides.map(({ a, b }) => [a[0] * b, a[1] * b]);
  return [[-1, -1], [1, 1], ...feet.filter((foot) => Math.hypot(...foot) < OUT_OF_REACH)];
}

/**
 * A point has no size, a horizontal segment no height.
 * @param {View} view
 */
function ensureSize(view) {
  /** @param {number[]} options */
  const widened = ([low, high]) => (high - low < 1e-3 ? [low - 2, high + 2] : [low, high]);
  return { x: widened(view.x), y: widened(view.y) };
}

/** @param {View} view */
function cornersOfView({ x, y }) {
  return [
    [x[0], y[0]],
    [x[1], y[1]],
  ];
}

/**
 * Rounding of a chosen point: whole steps of about a thousandth of the view, so that its decimals are short.
 * @param {ParameterFrame} frame
 * @param {View} view
 */
export function pointRounding(frame, view) {
  return [view.x, view.y].map((range, axis) =>
    frame.units[axis].times(decimalPower(Math.floor(Math.log10((range[1] - range[0]) / 400)))),
  );
}
