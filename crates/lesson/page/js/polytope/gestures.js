// @ts-check
// Mouse, touch and keyboard in the picture of half-planes: a drag draws a line, moves one, turns one, or moves the objective.

import { byId, closest } from "../dom.js";
import { ONE, Rational, dot } from "../model/rational.js";
import { round } from "../planes/axes.js";
import { scaledView, shiftedView } from "../planes/view.js";
import { plainOf } from "./document.js";
import { PIXELS_PER_UNIT, arrowTip } from "./drawing.js";
import { gridPointOn, otherSide, planeLeftOf, planeInText, planeThrough, textWith, textWithAnother, textWithoutLine, turnedNormal } from "./editing.js";
import { shownExercise, snapUnit, snapped } from "./scene.js";

const ZOOM_STEP = 1.5;
const LARGEST_COEFFICIENT = 8;
const LEAST_DRAG = 8;

/** @type {Record<string, number[]>} */
const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** What is dragged. @typedef {{ move: (at: Place) => void, end: (at: Place) => void }} Drag */

/**
 * Connects the picture.
 * @param {PolytopeStore} store
 * @param {() => PolytopeDrawn} current
 */
export function connectHalfPlanePicture(store, current) {
  const svg = byId("half-plane-picture");
  /** @type {Drag | null} */
  let drag = null;
  /** @param {PointerEvent} event */
  const placeOf = (event) => {
    const box = svg.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  svg.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || drag !== null || shownExercise(store.get()) !== null) return;
    drag = dragFrom(store, current, event, placeOf(event));
    if (drag === null) return;
    svg.setPointerCapture(event.pointerId);
    // The picture stays still under the hand.
    store.change({ view: current().map.view });
  });
  svg.addEventListener("pointermove", (event) => drag?.move(placeOf(event)));
  const end = (/** @type {PointerEvent} */ event) => {
    const own = drag;
    drag = null;
    own?.end(placeOf(event));
  };
  svg.addEventListener("pointerup", end);
  // What was not done is taken back, or stays as far as it got.
  svg.addEventListener("pointercancel", () => {
    drag = null;
    byId("line-being-drawn").setAttribute("d", "");
  });
  svg.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keyPressed(store, current, event)) return;
    event.preventDefault();
  });
  svg.addEventListener("wheel", (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    const { map } = current();
    store.change({ view: scaledView(map.view, event.deltaY > 0 ? 1.15 : 1 / 1.15, map.from(placeOf(/** @type {PointerEvent} */ (/** @type {unknown} */ (event))))) });
  }, { passive: false });
  svg.addEventListener("click", (event) => {
    const corner = closest(event, "[data-corner]");
    if (corner !== null && store.get().tab === "simplex") store.change({ start: Number(corner.dataset.corner), pivot: 0 });
  });
  /** @param {number} factor */
  const zoom = (factor) => () => store.change({ view: scaledView(current().map.view, factor) });
  byId("plane-zoom-in").addEventListener("click", zoom(1 / ZOOM_STEP));
  byId("plane-zoom-out").addEventListener("click", zoom(ZOOM_STEP));
  byId("plane-zoom-fit").addEventListener("click", () => store.change({ view: null }));
}

/**
 * What a drag that starts here does, or null.
 * @param {PolytopeStore} store
 * @param {() => PolytopeDrawn} current
 * @param {PointerEvent} event
 * @param {Place} start
 * @returns {Drag | null}
 */
function dragFrom(store, current, event, start) {
  const state = store.get();
  if (event.shiftKey) return viewDrag(store, current, start);
  if (closest(event, "#objective-arrow") !== null) return arrowDrag(store, current, start);
  const turning = closest(event, "[data-turn]");
  if (turning !== null && state.chosen !== null) return turnDrag(store, current, state.chosen, Number(turning.dataset.turn));
  const line = closest(event, "[data-plane-line]");
  if (line !== null) return moveDrag(store, current, Number(line.dataset.planeLine), start);
  if (closest(event, "[data-corner]") !== null) return null;
  if (event.pointerType === "touch" && !state.drawing) return null;
  return state.tab === "set" ? drawDrag(store, current, start) : null;
}

/** @type {(store: PolytopeStore, current: () => PolytopeDrawn, start: Place) => Drag} */
function viewDrag(store, current, start) {
  const { view, area } = current().map;
  /** @param {Place} at */
  const move = ([x, y]) => store.change({ view: shiftedView(view, (start[0] - x) / area.width, (y - start[1]) / area.height) });
  return { move, end: () => undefined };
}

/** @type {(store: PolytopeStore, current: () => PolytopeDrawn, start: Place) => Drag} */
function arrowDrag(store, current, start) {
  // The arrow may start elsewhere when it has moved: what counts is where it started when it was taken.
  const { anchor } = current();
  const tip = arrowTip(store.get().objective);
  const grip = [start[0] - anchor[0] - tip[0], start[1] - anchor[1] - tip[1]];
  /** @param {Place} at */
  const move = (at) => {
    const [x, y] = [at[0] - anchor[0] - grip[0], anchor[1] + grip[1] - at[1]].map((pixels) => {
      const units = Math.round(pixels / PIXELS_PER_UNIT);
      return Math.max(-LARGEST_COEFFICIENT, Math.min(LARGEST_COEFFICIENT, units));
    });
    if (x !== 0 || y !== 0) setObjective(store, [new Rational(BigInt(x)), new Rational(BigInt(y))]);
  };
  return { move, end: () => undefined };
}

/**
 * @param {PolytopeStore} store
 * @param {Pair} objective
 */
export function setObjective(store, objective) {
  const before = store.get().objective;
  if (objective.every((value, k) => value.equals(before[k]))) return;
  store.change({ objective, pivot: 0 });
}

/**
 * A line follows the pointer, parallel to itself, through points of the grid.
 * @type {(store: PolytopeStore, current: () => PolytopeDrawn, index: number, start: Place) => Drag | null}
 */
function moveDrag(store, current, index, start) {
  const { text, chosen } = store.get();
  const old = planeInText(store.get(), index);
  if (old === null) return null;
  const { a } = plainOf(old);
  const { map } = current();
  let moved = false;
  /** @param {Place} at */
  const move = (at) => {
    moved ||= Math.hypot(at[0] - start[0], at[1] - start[1]) > LEAST_DRAG;
    if (!moved || store.get().tab !== "set") return;
    const through = snapped(map.from(at), snapUnit(map.view));
    store.change({ chosen: index, text: textWithAnother(text, old, { a, b: dot(a, through) }) });
  };
  // Without a drag it is a click, which chooses the line or lets go of it.
  const end = () => moved || store.change({ chosen: chosen === index ? null : index });
  return { move, end };
}

/**
 * A line turns about one of the two places by which it is held.
 * @type {(store: PolytopeStore, current: () => PolytopeDrawn, index: number, end: number) => Drag | null}
 */
function turnDrag(store, current, index, end) {
  const { text } = store.get();
  const old = planeInText(store.get(), index);
  if (old === null) return null;
  const { map } = current();
  const other = byId("half-plane-picture").querySelector(`[data-turn="${1 - end}"]`);
  if (other === null) return null;
  const unit = snapUnit(map.view);
  const place = ["cx", "cy"].map((name) => Number(other.getAttribute(name)));
  const fixed = gridPointOn(plainOf(old), snapped(map.from(place), unit));
  let { a } = plainOf(old);
  /** @param {Place} at */
  const move = (at) => {
    const to = snapped(map.from(at), unit);
    const [dx, dy] = [0, 1].map((k) => to[k].minus(fixed[k]));
    if (dx.isZero() && dy.isZero()) return;
    const left = planeThrough([dy, dx.negated()], fixed);
    // It keeps its side as it turns.
    const own = dot(left.a, a).sign() < 0 ? { a: left.a.map((value) => value.negated()), b: left.b.negated() } : left;
    a = own.a;
    store.change({ text: textWithAnother(text, old, own) });
  };
  return { move, end: () => undefined };
}

/**
 * A new line from where the drag starts to where it ends; what lies on its left stays.
 * @type {(store: PolytopeStore, current: () => PolytopeDrawn, start: Place) => Drag}
 */
function drawDrag(store, current, start) {
  const { map } = current();
  const unit = snapUnit(map.view);
  const from = snapped(map.from(start), unit);
  const preview = () => byId("line-being-drawn");
  /** @param {Place} at */
  const move = (at) => preview().setAttribute("d", `M${start.map(round).join(" ")}L${at.map(round).join(" ")}`);
  /** @param {Place} at */
  const end = (at) => {
    preview().setAttribute("d", "");
    const isClick = Math.hypot(at[0] - start[0], at[1] - start[1]) < 2 * LEAST_DRAG;
    const halfPlane = isClick ? null : planeLeftOf(from, snapped(map.from(at), unit));
    if (halfPlane === null) return store.change({ chosen: null });
    const { text, answer } = store.get();
    return store.change({ text: textWith(text, halfPlane), chosen: answer?.half_planes.length ?? 0, drawing: false });
  };
  return { move, end };
}

/**
 * Whether a key was one of the picture's.
 * @param {PolytopeStore} store
 * @param {() => PolytopeDrawn} current
 * @param {KeyboardEvent} event
 */
function keyPressed(store, current, event) {
  const way = WAYS[event.key];
  if (closest(event, "#objective-arrow") !== null && way !== undefined) {
    const next = store.get().objective.map((value, k) => value.plus(new Rational(BigInt(way[k]))));
    setObjective(store, next);
    return true;
  }
  const line = closest(event, "[data-plane-line]");
  if (line !== null && shownExercise(store.get()) === null) return lineKey(store, current, Number(line.dataset.planeLine), event);
  const corner = closest(event, "[data-corner]");
  if (corner !== null) return cornerKey(store, Number(corner.dataset.corner), event);
  if (event.target !== byId("half-plane-picture")) return false;
  const { view } = current().map;
  if (way !== undefined) store.change({ view: shiftedView(view, 0.1 * way[0], 0.1 * way[1]) });
  else if (event.key === "+" || event.key === "=") store.change({ view: scaledView(view, 1 / ZOOM_STEP) });
  else if (event.key === "-") store.change({ view: scaledView(view, ZOOM_STEP) });
  else if (event.key === "0") store.change({ view: null });
  else return false;
  return true;
}

/**
 * Keys on a line: arrows move it, with Shift they turn it, Delete deletes it, F takes the other side, Page Up and Page Down go on
 * to another one.
 * @param {PolytopeStore} store
 * @param {() => PolytopeDrawn} current
 * @param {number} index
 * @param {KeyboardEvent} event
 */
function lineKey(store, current, index, event) {
  const { answer, text } = store.get();
  const old = planeInText(store.get(), index);
  const way = WAYS[event.key];
  // Of a key that is held down some come before the engine has answered the last one.
  if (answer === null || old === null) return way !== undefined;
  const own = plainOf(old);
  const count = answer.half_planes.length;
  const { view } = current().map;
  if (way !== undefined && event.shiftKey) {
    const turned = turnedNormal(own.a, way[0] + way[1]);
    const middle = snapped([(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2], snapUnit(view));
    store.change({ chosen: index, view, text: textWithAnother(text, old, planeThrough(turned, gridPointOn(own, middle))) });
  } else if (way !== undefined) {
    const unit = snapUnit(view);
    const shift = dot(own.a, way.map((value) => unit.times(new Rational(BigInt(value)))));
    store.change({ chosen: index, view, text: textWithAnother(text, old, { a: own.a, b: own.b.plus(shift) }) });
  } else if (event.key === "Delete" || event.key === "Backspace") {
    deleteHalfPlane(store, index);
  } else if (event.key === "f" || event.key === "F") {
    flipHalfPlane(store, index);
  } else if (event.key === "PageDown" || event.key === "PageUp") {
    focusLine(store, (index + (event.key === "PageDown" ? 1 : count - 1)) % count);
  } else if (event.key === "Enter" || event.key === " ") {
    store.change({ chosen: store.get().chosen === index ? null : index });
  } else return false;
  return true;
}

/**
 * @param {PolytopeStore} store
 * @param {number} index
 */
function focusLine(store, index) {
  store.change({ chosen: index });
  /** @type {HTMLElement | null} */ (document.querySelector(`[data-plane-line="${index}"]`))?.focus();
}

/**
 * @param {PolytopeStore} store
 * @param {number} index
 */
export function deleteHalfPlane(store, index) {
  const { text } = store.get();
  const old = planeInText(store.get(), index);
  if (old !== null) store.change({ text: textWithoutLine(text, old), chosen: null, start: null });
}

/**
 * @param {PolytopeStore} store
 * @param {number} index
 */
export function flipHalfPlane(store, index) {
  const { text } = store.get();
  const old = planeInText(store.get(), index);
  if (old !== null) store.change({ text: textWithAnother(text, old, otherSide(old)), chosen: index });
}

/**
 * Keys on a corner: arrows go to the next one, Enter starts the simplex method there.
 * @param {PolytopeStore} store
 * @param {number} index
 * @param {KeyboardEvent} event
 */
function cornerKey(store, index, event) {
  const count = store.get().answer?.set?.vertices.length ?? 0;
  if (event.key === "Enter" || event.key === " ") {
    store.change({ start: index, pivot: 0 });
    return true;
  }
  const way = WAYS[event.key];
  if (way === undefined || count === 0) return false;
  const next = (index + way[0] + way[1] + count) % count;
  /** @type {HTMLElement | null} */ (document.querySelector(`[data-corner="${next}"]`))?.focus();
  return true;
}

/**
 * A new half-plane without drawing it: aslant through the middle of the picture.
 * @param {PolytopeStore} store
 * @param {() => PolytopeDrawn} current
 */
export function addHalfPlane(store, current) {
  const { view } = current().map;
  const middle = snapped([(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2], snapUnit(view));
  const { text, answer } = store.get();
  store.change({ text: textWith(text, planeThrough([ONE, ONE], middle)), chosen: answer?.half_planes.length ?? 0, view });
}
