// @ts-check
// What the page shows, in one place. Every control changes this state; every view is drawn from it.

import { Rational, ZERO, extremes } from "./model/rational.js";
import { boundsOf, halfPlanesOf, regionWithout, rightHandSide, shapingHalfPlanes, steppedRegion, sweptRegion } from "./model/lesson.js";
import { kindText } from "./model/format.js";
import { isSliver, parameterFrame, usefulShear } from "./planes/view.js";
import { givenStop, sweepStops } from "./model/sweep.js";

// An error bound shorter than this share of the range of the heights is too short to see.
const SHORT_BAR = new Rational(1n, 25n);

/**
 * The state at the start, and a way to change it. Listeners are called after every change.
 * @param {Lesson} lesson
 * @returns {Store}
 */
export function createStore(lesson) {
  lesson.stops = sweepStops(lesson);
  /** @type {Listener[]} */
  const listeners = [];
  /** @type {State} */
  let state = {
    mode: "explore",
    order: 0,
    step: 0,
    stop: givenStop(lesson.stops),
    without: [],
    selection: null,
    hover: null,
    layers: new Set(),
    residual: barsAreTooShort(lesson),
    straighten: isSliver(parameterFrame(lesson, ZERO), lesson.fps),
    parameterView: null,
    dataView: null,
    playing: false,
  };
  return {
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

/** @type {Map<boolean, ParameterFrame>} */
const frames = new Map();

/**
 * @param {Lesson} lesson
 * @param {boolean} straighten
 */
function frameOf(lesson, straighten) {
  const found = frames.get(straighten) ?? parameterFrame(lesson, straighten ? usefulShear(lesson) : ZERO);
  frames.set(straighten, found);
  return found;
}

/** @type {{ key: string, scene: Scene } | null} */
let latest = null;

/**
 * What the state amounts to: the region shown, the one it is compared with, and the half-planes on the way.
 * Kept until the state shows something else.
 * @param {Lesson} lesson
 * @param {State} state
 */
export function sceneOf(lesson, state) {
  const { mode, order, step, stop, without, straighten } = state;
  const key = [mode, order, step, stop, without.join("+"), straighten].join();
  if (latest?.key !== key) latest = { key, scene: makeScene(lesson, state) };
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
