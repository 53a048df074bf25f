// What the page shows, in one place. Every control changes this state; every view is drawn from it.

import { Rational, ZERO, extremes } from "./rational.js";
import { boundsOf, halfPlanesOf, regionWithout, rightHandSide, shapingHalfPlanes, steppedRegion, sweptRegion } from "./model.js";
import { kindText } from "./format.js";
import { isSliver, parameterFrame, usefulShear } from "./view.js";
import { givenStop, sweepStops } from "./sweep.js";

// An error bound shorter than this share of the range of the heights is too short to see.
const SHORT_BAR = new Rational(1n, 25n);

/**
 * @typedef {Object} State
 * @property {"explore"|"clip"|"epsilon"|"leave-one-out"} mode
 * @property {number} order index of the order of clipping
 * @property {number} step how many half-planes have been added
 * @property {number} stop index of the ε slider's stop
 * @property {number|null} without the row that is switched off
 * @property {Object|null} selection what was chosen: {kind: "vertex", index} | {kind: "reading", row} | {kind: "point", theta}
 * @property {Object|null} hover the same, for what the pointer or the focus is on; it wins over the selection
 * @property {Set<string>} layers ids of the layers shown
 * @property {boolean} residual whether heights are relative to the reference line
 * @property {boolean} straighten whether the second axis shows the height at the middle x
 * @property {Object|null} parameterView the part of the parameter plane shown; null: chosen to fit
 * @property {Object|null} dataView the same for the data plane
 * @property {boolean} playing whether the steps run by themselves
 */

/** The state at the start, and a way to change it. Listeners are called after every change. */
export function createStore(lesson) {
  lesson.stops = sweepStops(lesson);
  const listeners = [];
  let state = {
    mode: "explore",
    order: 0,
    step: 0,
    stop: givenStop(lesson.stops),
    without: null,
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
      const shown = (s) => [s.mode, s.order, s.step, s.stop, s.without].join();
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

// Where all bars are short beside the range of the heights, the picture is one line and nothing can be seen.
function barsAreTooShort(lesson) {
  if (lesson.reference === null || lesson.readings.length === 0) return false;
  const [lowest, highest] = extremes(lesson.readings.map((reading) => reading.y));
  const [, longest] = extremes(lesson.readings.map((reading) => reading.epsilon));
  return longest.compare(highest.minus(lowest).times(SHORT_BAR)) < 0;
}

const frames = new Map();

function frameOf(lesson, straighten) {
  if (!frames.has(straighten))
    frames.set(straighten, parameterFrame(lesson, straighten ? usefulShear(lesson) : ZERO));
  return frames.get(straighten);
}

let latest = { key: null, scene: null };

/**
 * What the state amounts to: the region shown, the one it is compared with, and the half-planes on the way.
 * Kept until the state shows something else.
 */
export function sceneOf(lesson, state) {
  const { mode, order, step, stop, without, straighten } = state;
  const key = [mode, order, step, stop, without, straighten].join();
  if (latest.key !== key) latest = { key, scene: makeScene(lesson, state) };
  return latest.scene;
}

function makeScene(lesson, { mode, order, step, stop, without, straighten }) {
  const frame = frameOf(lesson, straighten);
  const scene = { frame, region: lesson.fps, before: null, current: null };
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
  } else if (mode === "leave-one-out" && without !== null) {
    scene.region = regionWithout(
      lesson,
      lesson.data.leave_one_out.find((entry) => entry.row === without),
    );
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
