// @ts-check
// Stepping through the clipping: the controls, and what each step did.

import { byId, element, patch, targetOf } from "../dom.js";
import { boundClass, boundText, decimal, digitsFor, kindText, shortList, theBound } from "../model/format.js";
import { inequality } from "./inspector.js";
import { numberWithFraction } from "./summary.js";
import { ONE } from "../model/rational.js";
import { numberText, rich, said, t } from "../texts.js";

const MILLISECONDS_PER_STEP = 1200;
// Whoever asked for less motion gets more time between steps, none of which is a transition.
const CALM_MILLISECONDS_PER_STEP = 2400;

/**
 * Connects the controls.
 * @param {Store} store
 */
export function connectClipping(store) {
  const last = () => store.lesson().data.orders[store.get().order].steps.length;
  /**
   * @param {number} step
   * @param {boolean} [playing]
   */
  const go = (step, playing = false) =>
    store.change({ mode: "clip", step: Math.max(0, Math.min(last(), step)), playing });
  byId("step-first").addEventListener("click", () => go(0));
  byId("step-back").addEventListener("click", () => go(store.get().step - 1));
  byId("step-forward").addEventListener("click", () => go(store.get().step + 1));
  byId("step-last").addEventListener("click", () => go(last()));
  byId("step-slider").addEventListener("input", (event) => go(Number(targetOf(event).value)));
  byId("clip-order").addEventListener("change", (event) => {
    store.change({ mode: "clip", order: Number(targetOf(event).value), step: 0, playing: false });
  });
  byId("step-play").addEventListener("click", () => {
    const { playing, step } = store.get();
    store.change({ mode: "clip", playing: !playing, step: !playing && step === last() ? 0 : step });
  });
  /** @type {ReturnType<typeof setInterval> | null} */
  let timer = null;
  store.subscribe((state) => {
    const run = state.playing && state.mode === "clip";
    if (run && timer === null) {
      timer = setInterval(() => {
        const next = store.get().step + 1;
        go(next, next < last());
      }, matchMedia("(prefers-reduced-motion: reduce)").matches ? CALM_MILLISECONDS_PER_STEP : MILLISECONDS_PER_STEP);
    } else if (!run && timer !== null) {
      clearInterval(timer);
      timer = null;
    }
  });
}

/**
 * The orders to choose from.
 * @param {Lesson} lesson
 */
export function listOrders(lesson) {
  patch(
    byId("clip-order"),
    lesson.data.orders.map((order, k) =>
      element("option", { value: `${k}`, "data-order": order.id }, said(order.name)),
    ),
  );
}

/**
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {number[]} indices
 */
function pointTexts(lesson, scene, indices) {
  return element(
    "ul",
    { class: "points" },
    indices.map((index) => {
      const [first, second] = lesson.points[index];
      const shown = [first, second].map((value, axis) =>
        numberWithFraction(value, decimal(value, digitsFor(value, scene.frame.units[axis]))),
      );
      return element(
        "li",
        { "data-theta1": first.toString(), "data-theta2": second.toString() },
        rich("wording.pair", { first: shown[0], second: shown[1] }),
      );
    }),
  );
}

/**
 * @param {Lesson} lesson
 * @param {RedundancyData} redundant
 */
function redundancy(lesson, redundant) {
  if (redundant.why === "always") return t("step.always");
  if (redundant.why === "already-empty") return t("step.already-empty");
  const terms = redundant.by.map(
    ({ half_plane, multiplier }) =>
      `${numberText(multiplier.decimal)} × (${boundText(lesson.halfPlanes[half_plane].name)})`,
  );
  const slack =
    redundant.slack === null
      ? ""
      : redundant.slack.exact === "0"
        ? ` ${t("step.touches")}`
        : ` ${t("step.clear", { slack: numberText(redundant.slack.decimal) })}`;
  if (terms.length === 0) return t("step.nothing") + slack;
  return t("step.dominated", { count: terms.length, sum: terms.join(" + ") }) + slack;
}

/**
 * What a step did, in one sentence: beside the buttons, and for the live region.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 */
export function stepSentence(lesson, state, scene) {
  if (scene.current === null)
    return t("step.zero");
  const bound = boundText(lesson.halfPlanes[scene.current.half_plane].name);
  const { born, lost, redundant } = scene.current;
  const { step } = state;
  if (redundant !== null) return t("step.redundant", { step, bound });
  const set = kindText(scene.region.kind, scene.region.vertices.length);
  return t("step.did", { step, bound, born: born.length, lost: lost.length, set });
}

/**
 * Draws the controls' state and the story of the step.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 */
export function drawClipping(lesson, state, scene) {
  const order = lesson.data.orders[state.order];
  const slider = byId("step-slider");
  slider.max = `${order.steps.length}`;
  slider.value = `${state.step}`;
  slider.setAttribute("aria-valuetext", t("step.spoken", { step: state.step, all: order.steps.length }));
  byId("clip-order").value = `${state.order}`;
  byId("clip-note").textContent = said(order.note);
  byId("step-number").textContent = `${state.step} / ${order.steps.length}`;
  const play = byId("step-play");
  play.textContent = t(state.playing ? "clip.pause" : "clip.play");
  play.setAttribute("aria-pressed", `${state.playing}`);
  // Disabled for real, a button would drop the focus of whoever has just pressed it.
  for (const id of ["step-first", "step-back"]) byId(id).ariaDisabled = `${state.step === 0}`;
  for (const id of ["step-forward", "step-last"])
    byId(id).ariaDisabled = `${state.step === order.steps.length}`;
  if (state.mode !== "clip") return;
  byId("step-sentence").textContent = stepSentence(lesson, state, scene);
  patch(byId("step-story"), story(lesson, state, scene));
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 */
function story(lesson, state, scene) {
  if (scene.current === null) return [];
  const halfPlane = lesson.halfPlanes[scene.current.half_plane];
  const { born, lost, redundant } = scene.current;
  const lists = [
    { head: t("step.born", { count: born.length }), indices: born, id: "born" },
    { head: t("step.lost", { count: lost.length }), indices: lost, id: "lost" },
  ].filter(({ indices }) => indices.length > 0);
  return [
    element(
      "p",
      {},
      element("strong", { class: `name ${boundClass(halfPlane.name)}` }, boundText(halfPlane.name)),
      ": ",
      element("span", { class: "formula" }, inequality(lesson, halfPlane, ONE)),
    ),
    element(
      "p",
      { id: "step-effect", "data-redundant": redundant?.why ?? "" },
      redundant === null
        ? t("step.cuts", { set: kindText(scene.region.kind, scene.region.vertices.length) })
        : redundancy(lesson, redundant),
    ),
    lists.map(({ head, indices, id }) =>
      element(
        "div",
        { id: `step-${id}` },
        element("h4", {}, head),
        pointTexts(lesson, scene, indices),
      ),
    ),
  ].flat();
}

/**
 * "the upper bound of reading 14 and the lower bound of reading 36", as a value of a text.
 * @param {BoundName[]} names
 */
export function namesList(names) {
  return shortList(names.map(theBound));
}
