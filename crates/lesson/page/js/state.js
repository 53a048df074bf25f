// @ts-check
// What the page shows, in one place. Every control changes this state; every view is drawn from it.

import { Rational, ZERO, extremes } from "./model/rational.js";
import { boundsOf, halfPlanesOf, regionWithout, rightHandSide, shapingHalfPlanes, steppedRegion, sweptRegion } from "./model/lesson.js";
import { kindText } from "./model/format.js";
import { dataFrame } from "./planes/data-frame.js";
import { isSliver, parameterFrame, usefulShear } from "./planes/view.js";
import { givenStop, sweepStops } from "./model/sweep.js";
import { currentLanguage } from "./texts.js";

// An error bound shorter than this share of the range of the heights is too short to see.
const SHORT_BAR = new Rational(1n, 25n);

/**
 * The lesson and the state at the start, and ways to change both. Listeners are called after every change.
 * @param {Lesson} first
 * @returns {Store}
 */
export function createStore(first) {
  let lesson = withStops(first);
  let state = initialState(lesson);
  /** @type {Listener[]} */
  const listeners = [];
  return {
    lesson: () => lesson,
    replace(next) {
      const before = state;
      state = carriedState(state, lesson, withStops(next));
      lesson = next;
      listeners.forEach((listener) => listener(state, before));
    },
    get: () => state,
    subscribe: (listener) => listeners.push(listener),
    change(changes) {
      const before = state;
      state = { ...state, ...changes };
      /** @param {State} s */
      const shown = (s) => [s.mode, s.order, s.step, s.stop, s.without.join("+")].join();
      // Vertices of another region are other vertices.
      if (shown(before) !== shown(state)) {
        if (!("hover" in changes) && state.hover?.kind === "vertex") state.hover = null;
        if (!("selection" in changes) && state.selection?.kind === "vertex") state.selection = null;
        if (!("parameterView" in changes)) state.parameterView = null;
      }
      listeners.forEach((listener) => listener(state, before));
    },
  };
}

/** @param {Lesson} lesson */
function withStops(lesson) {
  lesson.stops = sweepStops(lesson);
  return lesson;
}

/**
 * @param {Lesson} lesson
 * @returns {State}
 */
export function initialState(lesson) {
  return {
    mode: "explore",
    order: 0,
    step: 0,
    stop: givenStop(lesson.stops),
    without: [],
    selection: null,
    hover: null,
    layers: new Set(),
    hand: null,
    exactLines: false,
    residual: barsAreTooShort(lesson),
    straighten: isSliver(frameOf(lesson, false), lesson.fps),
    parameterView: null,
    dataView: null,
    playing: false,
    language: currentLanguage(),
  };
}

/**
 * What of a state means the same in another lesson: layers, a free point, a reading that is there too, the part of a picture that
 * the reader has chosen. Vertices and breakpoints of another set are others.
 * @param {State} state
 * @param {Lesson} lesson
 * @param {Lesson} next
 * @returns {State}
 */
function carriedState(state, lesson, next) {
  const start = initialState(next);
  const isSameTable = lesson.data.columns.join("\n") === next.data.columns.join("\n");
  if (!isSameTable || lesson.isLine !== next.isLine || lesson.readings.length === 0) return { ...start, layers: state.layers };
  const mode = state.mode === "epsilon" && next.stops.length === 0 ? "explore" : state.mode;
  const order = state.order < next.data.orders.length ? state.order : 0;
  /** @param {Choice | null} choice */
  const carried = (choice) =>
    choice?.kind === "point" ? { kind: choice.kind, theta: choice.theta } :
    choice?.kind === "reading" && next.rowIndex.has(choice.row) ? choice : null;
  const without = state.without.filter((row) => next.rowIndex.has(row));
  const residual = state.residual && next.reference !== null;
  const dataFrames = [dataFrame(lesson, state.residual), dataFrame(next, residual)];
  const planeFrames = [lesson, next].map((of) => frameOf(of, state.straighten));
  return {
    ...start,
    mode,
    order,
    step: Math.min(state.step, next.data.orders[order]?.steps.length ?? 0),
    // The same list is no change that is worth saying.
    without: without.length === state.without.length ? state.without : without,
    selection: carried(state.selection),
    hover: carried(state.hover),
    layers: state.layers,
    hand: state.hand,
    exactLines: state.exactLines,
    residual,
    straighten: state.straighten,
    dataView: sameView(state.dataView, dataFrames[0].exact, dataFrames[1].number),
    parameterView: sameView(
      state.parameterView,
      (axis, number) => planeFrames[0].axisValue(axis, number),
      (axis, value) => planeFrames[1].coordinate(axis, value),
    ),
  };
}

/**
 * A view of one frame in another one.
 * @param {View | null} view
 * @param {(axis: number, number: number) => Rational} exact
 * @param {(axis: number, value: Rational) => number} number
 */
function sameView(view, exact, number) {
  if (view === null) return null;
  /** @type {(axis: number, range: number[]) => number[]} */
  const moved = (axis, range) => range.map((end) => number(axis, exact(axis, end)));
  return { x: moved(0, view.x), y: moved(1, view.y) };
}

/**
 * Where all bars are short beside the range of the heights, the picture is one line and nothing can be seen.
 * @param {Lesson} lesson
 */
function barsAreTooShort(lesson) {
  if (lesson.reference === null || lesson.readings.length === 0) return false;
  const [lowest, highest] = extremes(lesson.readings.map((reading) => reading.y));
  const [, longest] = extremes(lesson.readings.map((reading) => reading.epsilon));
  return longest.compare(highest.minus(lowest).times(SHORT_BAR)) < 0;
}

/** @type {WeakMap<Lesson, Map<boolean, ParameterFrame>>} */
const frames = new WeakMap();

/**
 * @param {Lesson} lesson
 * @param {boolean} straighten
 */
function frameOf(lesson, straighten) {
  const own = frames.get(lesson) ?? new Map();
  const found = own.get(straighten) ?? parameterFrame(lesson, straighten ? usefulShear(lesson) : ZERO);
  frames.set(lesson, own.set(straighten, found));
  return found;
}

/** @type {{ lesson: Lesson, key: string, scene: Scene } | null} */
let latest = null;

/**
 * What the state amounts to: the region shown, the one it is compared with, and the half-planes on the way.
 * Kept until the state shows something else.
 * @param {Lesson} lesson
 * @param {State} state
 */
export function sceneOf(lesson, state) {
  const { mode, order, step, stop, without, straighten, language } = state;
  const key = [mode, order, step, stop, without.join("+"), straighten, language].join();
  if (latest?.lesson !== lesson || latest.key !== key) latest = { lesson, key, scene: makeScene(lesson, state) };
  return latest.scene;
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 */
function makeScene(lesson, { mode, order, step, stop, without, straighten }) {
  const frame = frameOf(lesson, straighten);
  const scene = /** @type {Scene} */ ({ frame, region: lesson.fps, before: null, current: null });
  if (mode === "clip") {
    const chosen = lesson.data.orders[order];
    scene.region = steppedRegion(lesson, chosen, step);
    if (step > 0) {
      scene.before = steppedRegion(lesson, chosen, step - 1);
      scene.current = chosen.steps[step - 1];
    }
  } else if (mode === "epsilon" && lesson.stops.length > 0) {
    scene.region = sweptRegion(lesson, lesson.stops[stop]);
    scene.before = lesson.fps;
  } else if (mode === "leave-one-out" && without.length > 0) {
    scene.region = regionWithout(lesson, without);
    scene.before = lesson.fps;
  }
  scene.s = scene.region.s;
  scene.bounds = boundsOf(scene.region);
  scene.lines = halfPlanesOf(lesson, scene.region)
    .filter((halfPlane) => !halfPlane.a.every((a) => a.isZero()))
    .map((halfPlane) => ({
      halfPlane,
      line: frame.halfPlane(halfPlane.a, rightHandSide(halfPlane, scene.s)),
    }));
  scene.shaping = shapingHalfPlanes(lesson, scene.region);
  scene.among = scene.region.among === null ? null : new Set(scene.region.among);
  scene.summary = kindText(scene.region.kind, scene.region.vertices.length);
  scene.places = scene.region.vertices.map((vertex) => frame.place(vertex.theta));
  return scene;
}
