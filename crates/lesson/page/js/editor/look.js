// @ts-check
// What of a lesson is looked at, as words in the page's address: the tab with where it stands, layers, and how the pictures are drawn.
// What the reader has not changed has no word.

import { initialState } from "../state.js";

/** @type {Mode[]} */
const TABS = ["explore", "clip", "epsilon", "leave-one-out", "worst-line"];
/** @type {(keyof State)[]} */
const PARTS = ["mode", "order", "step", "stop", "without", "layers", "residual", "straighten"];
// Layers are few; what the address says is not.
const MOST_LAYERS = 20;

/**
 * Whether two states are looked at in different ways.
 * @param {State} state
 * @param {State} before
 */
export function isOtherLook(state, before) {
  return PARTS.some((part) => state[part] !== before[part]);
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 */
export function lookOf(lesson, state) {
  const { mode, order, step, stop, without, layers } = state;
  const start = initialState(lesson);
  const words = new URLSearchParams();
  if (mode !== start.mode) words.set("tab", mode);
  if (mode === "clip") words.set("order", `${order}`);
  if (mode === "clip") words.set("step", `${step}`);
  if (mode === "epsilon") words.set("stop", `${stop}`);
  if (without.length > 0) words.set("without", without.join(" "));
  if (layers.size > 0) words.set("layers", [...layers].join(" "));
  for (const part of /** @type {const} */ (["residual", "straighten"])) if (state[part] !== start[part]) words.set(part, state[part] ? "yes" : "no");
  return words.toString();
}

/**
 * What words in an address change in the state of this lesson; anyone may have written them, and what has no meaning here is passed over.
 * @param {string} text
 * @param {Lesson} lesson
 * @returns {Partial<State>}
 */
export function stateOfLook(text, lesson) {
  const words = new URLSearchParams(text);
  const start = initialState(lesson);
  /** @param {string} word @param {number} most */
  const whole = (word, most) => {
    const said = words.get(word) ?? "";
    return /^\d{1,6}$/.test(said) && Number(said) <= most ? Number(said) : null;
  };
  const mode = TABS.find((own) => own === words.get("tab")) ?? start.mode;
  const order = whole("order", lesson.data.orders.length - 1) ?? start.order;
  const rows = (words.get("without") ?? "").split(" ").map(Number).filter((row) => lesson.rowIndex.has(row));
  const layers = (words.get("layers") ?? "").split(" ").filter((layer) => /^[a-z-]{1,30}$/.test(layer)).slice(0, MOST_LAYERS);
  return {
    mode: mode === "epsilon" && lesson.stops.length === 0 ? start.mode : mode,
    order,
    step: whole("step", lesson.data.orders[order]?.steps.length ?? 0) ?? start.step,
    stop: whole("stop", lesson.stops.length - 1) ?? start.stop,
    without: mode === "leave-one-out" ? [...new Set(rows)].sort((p, q) => p - q) : [],
    layers: new Set(layers),
    residual: words.has("residual") ? words.get("residual") === "yes" && lesson.reference !== null : start.residual,
    straighten: words.has("straighten") ? words.get("straighten") === "yes" : start.straighten,
  };
}
