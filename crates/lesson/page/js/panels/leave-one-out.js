// @ts-check
// The table of readings with their switches, and what the PUI gains or loses by one of them.

import { byId, closest, element, patch, targetOf } from "../dom.js";
import { boundsOf } from "../model/lesson.js";
import { THETA, endText, plain, withMinus } from "../model/format.js";

const LONG_NAME = 14;
/** @type {{ parameter: string, axis: number, end: "lower" | "upper" }[]} */
const ENDS = [
  { parameter: "theta1", axis: 0, end: "lower" },
  { parameter: "theta1", axis: 0, end: "upper" },
  { parameter: "theta2", axis: 1, end: "lower" },
  { parameter: "theta2", axis: 1, end: "upper" },
];

/**
 * Connects the table: a switch turns one reading off and any other one on again.
 * @param {Lesson} lesson
 * @param {Store} store
 */
export function connectLeaveOneOut(lesson, store) {
  byId("readings").addEventListener("change", (event) => {
    const row = Number(targetOf(event).dataset.row);
    if (targetOf(event).checked) store.change({ mode: "explore", without: null });
    else store.change({ mode: "leave-one-out", without: row });
  });
  byId("readings").addEventListener("click", (event) => {
    const button = closest(event, "button[data-show-row]");
    if (button === null) return;
    const row = Number(button.dataset.showRow);
    const { selection } = store.get();
    store.change({
      selection: selection?.kind === "reading" && selection.row === row ? null : { kind: "reading", row },
    });
  });
  byId("leave-out").addEventListener("change", (event) => {
    const row = targetOf(event).value === "" ? null : Number(targetOf(event).value);
    store.change({ mode: "leave-one-out", without: row });
  });
  /** @param {WithoutData} options */
  const option = ({ row, matters }) =>
    element("option", { value: `${row}` }, `reading ${row}${matters ? "" : " (does not matter)"}`);
  patch(
    byId("leave-out"),
    [element("option", { value: "" }, "none"), lesson.data.leave_one_out.map(option)].flat(),
  );
}

/**
 * An end of an interval, infinite where there is none.
 * @param {{ lower: Rational | null, upper: Rational | null }} interval
 * @param {"lower" | "upper"} end
 */
function shownEnd(interval, end) {
  const value = interval[end];
  if (value === null) return end === "lower" ? "−∞" : "∞";
  return endText(value, interval, end);
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 */
function effect(lesson, state, scene) {
  const entry = lesson.data.leave_one_out.find(({ row }) => row === state.without);
  if (entry === undefined)
    return [element("p", {}, "Choose a reading to switch off, here or in the table of readings below.")];
  if (!entry.matters) {
    return [
      element(
        "p",
        { id: "leave-one-out-verdict", "data-matters": "false" },
        lesson.fps.kind === "empty"
          ? `Reading ${entry.row} does not matter: without it the feasible parameter set is empty as well.`
          : `Reading ${entry.row} does not matter: without it the feasible parameter set is exactly the same, and so is the PUI.`,
      ),
    ];
  }
  const before = boundsOf(lesson.fps);
  const after = scene.bounds;
  if (before === null) {
    return [
      element(
        "p",
        { id: "leave-one-out-verdict", "data-matters": "true" },
        `Reading ${entry.row} matters: without it the set is ${after === null ? "still empty, for another reason" : "no longer empty"}.`,
      ),
    ];
  }
  const rows = ENDS.map(({ parameter, axis, end }) => {
    const moved = entry.moved.find((move) => move.parameter === parameter && move.end === end);
    const by =
      moved === undefined ? "not at all" : moved.by === null ? "to infinity" : withMinus(moved.by.decimal);
    return element(
      "tr",
      {
        "data-moved": `${parameter}-${end}`,
        "data-by": moved?.by?.exact ?? (moved === undefined ? "0" : ""),
      },
      element("th", { scope: "row" }, `${THETA[axis]} ${end}`),
      element("td", { class: "number" }, shownEnd(before[axis], end)),
      element("td", { class: "number" }, after === null ? "–" : shownEnd(after[axis], end)),
      element("td", { class: "number", title: moved?.by?.exact ?? null }, by),
    );
  });
  const heads = ["PUI end", "with it", "without it", "moves outward by"].map((head) =>
    element("th", { scope: "col" }, head),
  );
  return [
    element(
      "p",
      { id: "leave-one-out-verdict", "data-matters": "true" },
      `Reading ${entry.row} matters. The set without it (solid) contains the one with it (dashed).`,
    ),
    element(
      "div",
      { class: "scroll" },
      element(
        "table",
        { id: "leave-one-out-effect" },
        element("thead", {}, element("tr", {}, heads)),
        element("tbody", {}, rows),
      ),
    ),
  ];
}

/**
 * Draws the effect of the switch.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 */
export function drawLeaveOneOut(lesson, state, scene) {
  byId("leave-out").value = state.without === null ? "" : `${state.without}`;
  if (state.mode === "leave-one-out") patch(byId("leave-one-out-story"), effect(lesson, state, scene));
}

/**
 * Draws the table of readings.
 * @param {Lesson} lesson
 * @param {State} state
 */
export function drawReadings(lesson, state) {
  const { model } = lesson.data;
  const columns = model.kind === "line" ? [model.x] : model.regressors;
  const heads = ["row", ...columns, model.y, "ε", "matters", "use"];
  /** @param {Reading} reading */
  const row = (reading) => {
    const matters = lesson.matters.get(reading.row);
    const off = state.mode === "leave-one-out" && state.without === reading.row;
    const chosen = state.selection?.kind === "reading" && state.selection.row === reading.row;
    return element(
      "tr",
      { class: [matters ? "matters" : "idle", off && "off", chosen && "chosen"].filter(Boolean).join(" ") },
      element(
        "th",
        { scope: "row" },
        element(
          "button",
          {
            type: "button",
            class: "plain",
            "data-show-row": reading.row,
            "aria-pressed": `${chosen}`,
            "aria-label": `Show reading ${reading.row} in the pictures`,
          },
          `${reading.row}`,
        ),
      ),
      columns.map((_, k) => element("td", { class: "number" }, plain(reading.phi[k]))),
      element("td", { class: "number" }, plain(reading.y)),
      element("td", { class: "number" }, reading.fixed === null ? plain(reading.epsilon) : "one bound"),
      element("td", {}, matters ? element("b", {}, "◆ yes") : "no"),
      element(
        "td",
        {},
        element("input", {
          type: "checkbox",
          id: `leave-out-${reading.row}`,
          "data-row": reading.row,
          checked: !off,
          "aria-label": `Use reading ${reading.row}`,
        }),
      ),
    );
  };
  patch(byId("readings"), [
    element(
      "thead",
      {},
      element(
        "tr",
        {},
        heads.map((head) =>
          element("th", { scope: "col", class: head.length > LONG_NAME ? "long" : null }, head),
        ),
      ),
    ),
    element("tbody", {}, lesson.readings.map(row)),
  ]);
}
