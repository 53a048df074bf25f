// @ts-check
// The lines by hand and the exact ones in both planes, and what moves the former: mouse, touch and arrow keys.

import { closest, element } from "../dom.js";
import { mark, round } from "./axes.js";
import { bounded, curvePath } from "./corridor.js";
import { dataFrame } from "./data-frame.js";
import { nameOfX, plain } from "../model/format.js";
import { ONE, decimalPower } from "../model/rational.js";
import { WORST, gripsOf, cornerToCorner, lineByHand, worstVertex } from "../model/worst-line.js";
import { t } from "../texts.js";

const REACH = 22;
const STEP = 0.005;
const LEAP = 0.05;

/** @type {Record<string, number>} */
const KEYS = { ArrowUp: STEP, ArrowDown: -STEP, PageUp: LEAP, PageDown: -LEAP };

/**
 * The lines of the data plane, with a handle at each end.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
export function worstLines(lesson, state, frame, map) {
  const grips = gripsOf(lesson);
  if (state.mode !== "worst-line" || grips === null) return element("g");
  const hand = state.hand ?? cornerToCorner(lesson);
  const exact = WORST.map((name) => {
    const index = state.exactLines ? worstVertex(lesson, name) : null;
    if (index === null) return null;
    const { theta } = lesson.fps.vertices[index];
    return element("path", { class: `curve worst exact ${name}`, "data-exact-line": name, d: curvePath(lesson, theta, frame, map) });
  });
  const lines = WORST.map((name) =>
    element("path", {
      class: `curve worst ${name}`,
      "data-worst": name,
      d: curvePath(lesson, lineByHand(lesson, hand[name]), frame, map),
    }),
  );
  const handles = WORST.map((name) => grips.map((x, side) => handle(lesson, name, side, x, hand[name][side], frame, map)));
  return element("g", { id: "worst-lines" }, exact, lines, handles);
}

/**
 * @param {Lesson} lesson
 * @param {WorstName} name
 * @param {number} side
 * @param {Rational} x
 * @param {Rational} height
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
function handle(lesson, name, side, x, height, frame, map) {
  const [px, py] = map.to([frame.number(0, x), bounded(frame.height([x, ONE], height), map)]);
  const { model } = lesson.data;
  const where = `${nameOfX(lesson.data)} = ${plain(x, lesson.widths.phi[0])}`;
  return element(
    "g",
    {
      class: `handle ${name}`,
      "data-handle": name,
      "data-side": side,
      "data-height": height.toString(),
      role: "slider",
      tabindex: 0,
      "aria-orientation": "vertical",
      "aria-valuenow": height.toNumber(),
      "aria-valuetext": `${model.y} = ${plain(height, lesson.widths.y)}`,
      "aria-label": t(`worst.handle.${name}`, { where }),
    },
    element("rect", { class: "hit", x: round(px - REACH), y: round(py - REACH), width: 2 * REACH, height: 2 * REACH }),
    mark(name === "steepest" ? "triangle" : "square", [px, py], { class: "grip" }),
  );
}

/**
 * The lines by hand as points of the parameter plane.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {ParameterFrame} frame
 * @param {ScreenMap} map
 */
export function worstPoints(lesson, state, frame, map) {
  const marks = worstPlaces(lesson, state, frame).map(({ name, place }) =>
    mark(name === "steepest" ? "triangle" : "square", map.to(place), { class: `worst-point ${name}`, "data-worst-point": name }),
  );
  return element("g", { "aria-hidden": "true" }, marks);
}

/**
 * Where the lines by hand are in the parameter plane.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {ParameterFrame} frame
 */
export function worstPlaces(lesson, state, frame) {
  if (state.mode !== "worst-line" || gripsOf(lesson) === null) return [];
  const hand = state.hand ?? cornerToCorner(lesson);
  return WORST.map((name) => ({ name, place: frame.place(lineByHand(lesson, hand[name])) }));
}

/**
 * Dragging the handles of the data plane, and moving them with keys.
 * @param {PageElement} svg
 * @param {Store} store
 * @param {() => Drawn} current
 */
export function connectWorstLines(svg, store, current) {
  /** @type {PageElement | null} */
  let held = null;

  /**
   * Moves a handle from its height, a number of the view's frame, to another one.
   * @param {PageElement} item
   * @param {(number: number, view: View) => number} to
   */
  function move(item, to) {
    const lesson = store.lesson();
    const grips = gripsOf(lesson);
    if (grips === null) return;
    const { residual, hand } = store.get();
    const { view } = current().dataMap;
    const frame = dataFrame(lesson, residual);
    const name = item.dataset.handle === "steepest" ? "steepest" : "shallowest";
    const side = Number(item.dataset.side);
    const lines = hand ?? cornerToCorner(lesson);
    const phi = [grips[side], ONE];
    const [low, high] = view.y;
    const number = to(frame.height(phi, lines[name][side]), view);
    const height = frame.measured(phi, Math.max(low, Math.min(high, number)));
    // Steps of about a thousandth of the picture, so that decimals are short.
    const unit = decimalPower(frame.exact(1, high).minus(frame.exact(1, low)).decimalExponent() - 3);
    const heights = lines[name].map((before, k) => (k === side ? height.roundedTo(unit) : before));
    store.change({ hand: { ...lines, [name]: heights } });
  }

  svg.addEventListener("pointerdown", (event) => {
    const item = closest(event, "[data-handle]");
    if (item === null || event.button !== 0 || event.shiftKey) return;
    held = item;
    svg.setPointerCapture(event.pointerId);
    item.focus();
    event.preventDefault();
  });
  svg.addEventListener("pointermove", (event) => {
    const { dataMap } = current();
    const y = event.clientY - svg.getBoundingClientRect().top;
    if (held !== null) move(held, () => dataMap.from([0, y])[1]);
  });
  const release = () => {
    held = null;
  };
  svg.addEventListener("pointerup", release);
  svg.addEventListener("pointercancel", release);
  svg.addEventListener("keydown", (event) => {
    const item = closest(event, "[data-handle]");
    const share = KEYS[event.key];
    if (item === null || share === undefined) return;
    move(item, (number, { y: [low, high] }) => number + share * (event.shiftKey ? 10 : 1) * (high - low));
    event.preventDefault();
  });
}
