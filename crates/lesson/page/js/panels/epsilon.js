// @ts-check
// The ε slider: the same readings with larger or smaller error bounds.

import { byId, element, patch, targetOf } from "../dom.js";
import { Rational } from "../model/rational.js";
import { numberWithFraction } from "./summary.js";
import { namesList } from "./clipping.js";
import { demands, hopeless, sweepOf } from "../model/lesson.js";
import { boundAtStop, givenStop } from "../model/sweep.js";
import { t } from "../texts.js";

// Parts of the slider that two labels side by side, or half a label at an end, take on a narrow screen.
const NEAR_LABELS = 0.35;
const NEAR_END = 0.12;

/**
 * Connects the slider and its buttons.
 * @param {Store} store
 */
export function connectEpsilon(store) {
  /** @param {number} stop */
  const go = (stop) => store.change({ mode: "epsilon", stop });
  byId("epsilon-slider").addEventListener("input", (event) => go(Number(targetOf(event).value)));
  byId("epsilon-next").addEventListener("click", () => {
    const next = store.lesson().stops.findIndex((stop, k) => k > store.get().stop && stop.breakpoint !== null);
    if (next >= 0) go(next);
  });
  byId("epsilon-previous").addEventListener("click", () => {
    const earlier = store.lesson().stops.map((stop, k) => (k < store.get().stop && stop.breakpoint !== null ? k : -1));
    if (Math.max(...earlier) >= 0) go(Math.max(...earlier));
  });
  byId("epsilon-given").addEventListener("click", () => go(givenStop(store.lesson().stops)));
  byId("epsilon-least").addEventListener("click", () => {
    const least = leastStop(store.lesson());
    if (least >= 0) go(least);
  });
}

/** @param {Lesson} lesson */
function leastStop(lesson) {
  const least = lesson.data.sweep?.least ?? null;
  return least === null ? -1 : lesson.stops.findIndex((stop) => stop.s.toString() === least.exact);
}

/**
 * What the slider moves: the one error bound, or the factor of all of them.
 * @param {Lesson} lesson
 */
const symbolOf = (lesson) => (lesson.epsilon === null ? "s" : "ε");

/**
 * The slider's range. The stops are evenly spaced on it; so are their ticks.
 * @param {Lesson} lesson
 */
export function drawStops(lesson) {
  const { stops } = lesson;
  byId("tab-epsilon").disabled = stops.length === 0;
  byId("epsilon-slider").max = `${Math.max(0, stops.length - 1)}`;
  const last = Math.max(1, stops.length - 1);
  const least = leastStop(lesson);
  const at = stops.flatMap((stop, k) => (stop.breakpoint === null && k !== givenStop(stops) ? [] : [k]));
  const given = givenStop(stops);
  const symbol = symbolOf(lesson);
  // Two labels that would run into each other stand below each other.
  const isNear = least >= 0 && Math.abs(given - least) / last < NEAR_LABELS;
  const marks = at.map((k) => {
    const kind = k === least ? "least" : k === given ? `given${isNear ? " below" : ""}` : "";
    const label = k === least ? t(k === given ? "epsilon.tick-both" : "epsilon.tick-least", { symbol }) : k === given ? t("epsilon.tick-given") : "";
    // Labels at the ends of the slider stay on it.
    const side = k / last < NEAR_END ? " first" : k / last > 1 - NEAR_END ? " last" : "";
    return element("span", { class: `stop ${kind}${side}`, style: `left:${((100 * k) / last).toFixed(3)}%` }, label);
  });
  patch(byId("epsilon-ticks"), marks);
}

/**
 * The value of the slider, in words.
 * @param {Lesson} lesson
 * @param {Stop} stop
 */
export function epsilonText(lesson, stop) {
  const { name, shown } = boundAtStop(lesson, stop);
  return `${name} = ${shown}`;
}

/**
 * What happens at the slider's value, in one sentence.
 * @param {Lesson} lesson
 * @param {Stop} stop
 */
export function epsilonSentence(lesson, stop) {
  const least = lesson.data.sweep?.least ?? null;
  if (least === null) return t("epsilon.hopeless", { why: hopeless(lesson) ?? "" });
  const sMin = Rational.parse(least.exact);
  if (stop.s.equals(sMin))
    return sMin.isZero() ? t("epsilon.born-zero", { demands: demands(lesson) }) : t("epsilon.born");
  if (stop.s.compare(sMin) < 0)
    return t("epsilon.empty", { demands: demands(lesson) });
  if (stop.breakpoint === null)
    return t("epsilon.between", { symbol: symbolOf(lesson) });
  const { entering, leaving } = sweepOf(lesson).breakpoints[stop.breakpoint];
  const parts = [];
  if (entering.length > 0) parts.push(t("epsilon.become-active", { bounds: namesList(entering) }));
  if (leaving.length > 0) parts.push(t("epsilon.become-redundant", { bounds: namesList(leaving) }));
  return parts.length === 0 ? t("epsilon.end") : t("epsilon.breakpoint", { symbol: symbolOf(lesson), changes: parts.join("; ") });
}

/**
 * Draws the slider's state.
 * @param {Lesson} lesson
 * @param {State} state
 */
export function drawEpsilon(lesson, state) {
  if (lesson.stops.length === 0) return;
  const stop = lesson.stops[state.stop];
  const slider = byId("epsilon-slider");
  slider.value = `${state.stop}`;
  slider.setAttribute(
    "aria-valuetext",
    stop.breakpoint === null ? epsilonText(lesson, stop) : t("epsilon.spoken", { value: epsilonText(lesson, stop) }),
  );
  const { name, exact, shown } = boundAtStop(lesson, stop);
  const value = byId("epsilon-value");
  value.dataset.s = stop.s.toString();
  value.dataset.breakpoint = `${stop.breakpoint ?? ""}`;
  patch(value, [`${name} = `, numberWithFraction(exact, shown)]);
  byId("epsilon-story").textContent = epsilonSentence(lesson, stop);
  byId("epsilon-least").disabled = leastStop(lesson) < 0;
}
