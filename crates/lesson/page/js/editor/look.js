// @ts-check
// What of a lesson is looked at, as words of the page in its address: the tab with where it stands, layers, and how the pictures are drawn.
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
 * @returns {Record<string, string>}
 */
export function lookOf(lesson, state) {
  const { mode, order, step, stop, without, layers } = state;
  const start = initialState(lesson);
  /** @type {Record<string, string>} */
  const words = {};
  if (mode !== start.mode) words.tab = mode;
  if (mode === "clip") Object.assign(words, { order: `${order}`, step: `${step}` });
  if (mode === "epsilon") words.stop = `${stop}`;
  if (without.length > 0) words.without = without.join(" ");
  if (layers.size > 0) words.layers = [...layers].join(" ");
  for (const part of /** @type {const} */ (["residual", "straighten"])) if (state[part] !== start[part]) words[part] = state[part] ? "yes" : "no";
  return words;
}

/**
 * What words in an address change in the state of this lesson; anyone may have written them, and what has no meaning here is passed over.
 * @param {Record<string, string>} words
 * @param {Lesson} lesson
 * @returns {Partial<State>}
 */
export function stateOfLook(words, lesson) {
  const start = initialState(lesson);
  /** @param {string} word @param {number} most */
  const whole = (word, most) => {
    const said = words[word] ?? "";
    return /^\d{1,6}$/.test(said) && Number(said) <= most ? Number(said) : null;
  };
  const mode = TABS.find((own) => own === words.tab) ?? start.mode;
  const order = whole("order", lesson.data.orders.length - 1) ?? start.order;
  const rows = (words.without ?? "").split(" ").map(Number).filter((row) => lesson.rowIndex.has(row));
  const layers = (words.layers ?? "").split(" ").filter((layer) => /^[a-z-]{1,30}$/.test(layer)).slice(0, MOST_LAYERS);
  return {
    mode: mode === "epsilon" && lesson.stops.length === 0 ? start.mode : mode,
    order,
    step: whole("step", lesson.data.orders[order]?.steps.length ?? 0) ?? start.step,
    stop: whole("stop", lesson.stops.length - 1) ?? start.stop,
    without: mode === "leave-one-out" ? [...new Set(rows)].sort((p, q) => p - q) : [],
    layers: new Set(layers),
    residual: words.residual === undefined ? start.residual : words.residual === "yes" && lesson.reference !== null,
    straighten: words.straighten === undefined ? start.straighten : words.straighten === "yes",
  };
}
