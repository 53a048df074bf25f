// @ts-check
// Readings moved in the data plane: with the mouse, with a finger once the reading is chosen, with Shift and the arrow keys. Values are
// whole multiples of a small part of the view, so that their decimals are short.

import { all, closest } from "../dom.js";
import { readingOfRow } from "../model/lesson.js";
import { ONE, Rational, ZERO, decimalPower, dot } from "../model/rational.js";
import { dataFrame } from "../planes/data-frame.js";

// So many pixels are a movement and no click.
const STARTS_AT = 4;
// So many pixels to a side do not change x: most movements are meant to go up or down.
const STICKS = 8;
const SMALL_MOVE = 1;
const LARGE_MOVE = 10;
// Parts of the view that are told apart.
const STEPS_IN_VIEW = 400;

/** @type {Record<string, number[]>} */
const MOVES = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1], PageUp: [0, LARGE_MOVE], PageDown: [0, -LARGE_MOVE], Home: [-LARGE_MOVE, 0], End: [LARGE_MOVE, 0] };

/**
 * The power of ten that takes some hundreds of steps through the view along an axis.
 * @param {DataFrame} frame
 * @param {number[]} range
 * @param {number} axis
 */
export function stepOf(frame, range, axis) {
  const size = frame.exact(axis, range[1]).minus(frame.exact(axis, range[0])).over(new Rational(BigInt(STEPS_IN_VIEW)));
  return decimalPower(size.decimalExponent());
}

/**
 * Where a place of the picture is: x, and y as measured; null for a coordinate that a picture of two regressors has not.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {ScreenMap} map
 * @param {Place} at
 * @param {Pair | null} phi the regressors, where they stay
 */
export function measuredAt(lesson, state, map, at, phi) {
  const frame = dataFrame(lesson, state.residual);
  const [u, v] = map.from(at);
  const x = lesson.isLine ? frame.exact(0, u).roundedTo(stepOf(frame, map.view.x, 0)) : null;
  const height = frame.exact(1, v);
  const above = phi ?? (x === null ? null : [x, ONE]);
  const reference = state.residual && lesson.reference !== null && above !== null ? dot(above, lesson.reference.theta) : ZERO;
  return { x, y: height.plus(reference).roundedTo(stepOf(frame, map.view.y, 1)) };
}

/**
 * @param {PageElement} svg
 * @param {MouseEvent} event
 */
function placeOf(svg, event) {
  const box = svg.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/**
 * Connects the data plane.
 * @param {PageElement} svg
 * @param {Store} store
 * @param {() => Drawn} current
 * @param {ReadingEdits} edits
 */
export function connectDragging(svg, store, current, edits) {
  /** @type {{ row: number, from: Place, offset: Place, key: string, moved: boolean, aside: boolean, views: boolean[] } | null} */
  let drag = null;
  let drags = 0;
  svg.addEventListener("pointerdown", (event) => {
    const item = closest(event, "[data-reading]");
    if (item === null || drag !== null || event.button !== 0 || event.shiftKey) return;
    const row = Number(item.dataset.reading);
    const { selection } = store.get();
    // A finger scrolls the page unless it is on what was chosen.
    if (event.pointerType === "touch" && !(selection?.kind === "reading" && selection.row === row)) return;
    const at = placeOf(svg, event);
    const own = pixelOf(store.lesson(), store.get(), current().dataMap, row);
    drags += 1;
    drag = { row, from: at, offset: [own[0] - at[0], own[1] - at[1]], key: `drag ${drags}`, moved: false, aside: false, views: [] };
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener("pointermove", (event) => {
    if (drag === null) return;
    const at = placeOf(svg, event);
    if (!drag.moved) {
      if (Math.hypot(at[0] - drag.from[0], at[1] - drag.from[1]) < STARTS_AT) return;
      drag.moved = true;
      drag.views = hold(store, current());
      store.change({ selection: { kind: "reading", row: drag.row }, hover: null });
    }
    const lesson = store.lesson();
    if (!lesson.rowIndex.has(drag.row)) return;
    const { phi } = readingOfRow(lesson, drag.row);
    drag.aside ||= Math.abs(at[0] - drag.from[0]) > STICKS;
    const place = [at[0] + drag.offset[0], at[1] + drag.offset[1]];
    const { x, y } = measuredAt(lesson, store.get(), current().dataMap, place, drag.aside && lesson.isLine ? null : phi);
    edits.move(drag.row, drag.aside ? x : null, y, drag.key);
  });
  const end = () => {
    if (drag === null) return;
    const { moved, views } = drag;
    drag = null;
    if (!moved) return;
    release(store, views);
    edits.settle();
    // The click that follows would let go of the reading.
    svg.addEventListener("click", swallow, { capture: true, once: true });
    setTimeout(() => svg.removeEventListener("click", swallow, { capture: true }), 0);
  };
  svg.addEventListener("pointerup", end);
  svg.addEventListener("pointercancel", end);
  svg.addEventListener("dblclick", (event) => {
    const map = current().dataMap;
    const at = placeOf(svg, event);
    const { left, top, width, height } = map.area;
    const isInside = at[0] >= left && at[0] <= left + width && at[1] >= top && at[1] <= top + height;
    if (closest(event, "[data-reading],[data-handle]") !== null || !isInside) return;
    const { x, y } = measuredAt(store.lesson(), store.get(), map, at, null);
    if (x !== null) edits.add(x, y);
  });
  svg.addEventListener("keydown", (event) => onKey(event, store, current, edits), { capture: true });
}

/** @param {Event} event */
function swallow(event) {
  event.stopPropagation();
}

/**
 * A picture that followed the readings would hide that they move: while one is moved, the views stay.
 * @param {Store} store
 * @param {Drawn} drawn
 */
function hold(store, { dataMap, parameterMap }) {
  const { dataView, parameterView } = store.get();
  store.change({ dataView: dataView ?? dataMap.view, parameterView: parameterView ?? parameterMap.view });
  return [dataView === null, parameterView === null];
}

/**
 * @param {Store} store
 * @param {boolean[]} held which views were held
 */
function release(store, [data, parameter]) {
  store.change({ ...(data ? { dataView: null } : {}), ...(parameter ? { parameterView: null } : {}) });
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 * @param {ScreenMap} map
 * @param {number} row
 */
function pixelOf(lesson, state, map, row) {
  const frame = dataFrame(lesson, state.residual);
  const reading = readingOfRow(lesson, row);
  return map.to([frame.across(reading), frame.height(reading.phi, reading.y)]);
}

/**
 * @param {KeyboardEvent} event
 * @param {Store} store
 * @param {() => Drawn} current
 * @param {ReadingEdits} edits
 */
function onKey(event, store, current, edits) {
  const item = closest(event, "[data-reading]");
  if (item === null) return;
  const row = Number(item.dataset.reading);
  const move = MOVES[event.key];
  if (event.key === "Delete" || event.key === "Backspace") edits.remove(row);
  else if (event.shiftKey && move !== undefined) {
    const [lesson, state] = [store.lesson(), store.get()];
    const frame = dataFrame(lesson, state.residual);
    const { view } = current().dataMap;
    const { phi, y } = readingOfRow(lesson, row);
    /** @param {number} axis @param {number[]} range */
    const by = (axis, range) => stepOf(frame, range, axis).times(new Rational(BigInt(move[axis] * SMALL_MOVE)));
    if (!lesson.isLine && move[0] !== 0) return;
    edits.move(row, lesson.isLine ? phi[0].plus(by(0, view.x)) : null, y.plus(by(1, view.y)), `keys ${row}`);
    edits.settle();
  } else return;
  event.preventDefault();
  event.stopPropagation();
}

/** The reading of a row in the picture, for the focus. @param {PageElement} svg @param {number} row */
export function drawnAt(svg, row) {
  return [...all("[data-reading]", svg)].find((item) => item.dataset.reading === `${row}`) ?? null;
}
