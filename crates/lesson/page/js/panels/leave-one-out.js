// @ts-check
// The table of readings with their switches, and what the PUI gains or loses by one of them.

import { byId, closest, element, patch, targetOf } from "../dom.js";
import { boundsOf } from "../model/lesson.js";
import { THETA, decimal, endText, plain, shortEnumeration, switchedOff, withMinus } from "../model/format.js";
import { ZERO } from "../model/rational.js";

const LONG_NAME = 14;
/** @type {{ parameter: string, axis: number, end: "lower" | "upper" }[]} */
const ENDS = [
  { parameter: "theta1", axis: 0, end: "lower" },
  { parameter: "theta1", axis: 0, end: "upper" },
  { parameter: "theta2", axis: 1, end: "lower" },
  { parameter: "theta2", axis: 1, end: "upper" },
];

/**
 * Connects the table, in which any number of readings can be switched off, and the list, which switches off one.
 * @param {Store} store
 */
export function connectLeaveOneOut(store) {
  byId("readings").addEventListener("change", (event) => {
    const row = Number(targetOf(event).dataset.row);
    const { mode, without } = store.get();
    const off = new Set(mode === "leave-one-out" ? without : []);
    if (targetOf(event).checked) off.delete(row);
    else off.add(row);
    const rows = [...off].sort((p, q) => p - q);
    store.change({ mode: rows.length === 0 ? "explore" : "leave-one-out", without: rows });
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
    const { value } = targetOf(event);
    store.change({ mode: "leave-one-out", without: value === "" ? [] : [Number(value)] });
  });
  byId("outliers").addEventListener("click", (event) => {
    const button = closest(event, "button[data-way]");
    const way = store.lesson().data.outliers?.ways[Number(button?.dataset.way)];
    if (way !== undefined) store.change({ mode: "leave-one-out", without: way });
  });
}

/**
 * What can be switched off: one reading by the list, or the fewest that leave something.
 * @param {Lesson} lesson
 */
export function listSwitches(lesson) {
  patch(byId("outliers"), outlierButtons(lesson));
  /** @param {WithoutData} options */
  const option = ({ row, matters }) =>
    element("option", { value: `${row}` }, `reading ${row}${matters ? "" : " (does not matter)"}`);
  patch(
    byId("leave-out"),
    [element("option", { value: "" }, "none"), lesson.data.leave_one_out.map(option)].flat(),
  );
}

/**
 * The fewest readings to leave out, with a button for each way, where not all agree.
 * @param {Lesson} lesson
 */
function outlierButtons({ data, fps }) {
  if (fps.kind !== "empty") return [];
  if (data.outliers === null)
    return [element("small", {}, "The fewest readings to leave out are not known: conditions alone leave nothing, or it takes too long.")];
  const { least, ways, complete } = data.outliers;
  const fewest = least === 1 ? "One reading has" : `At least ${least} readings have`;
  const count = complete && ways.length === 1 ? "there is one way" : `${complete ? "" : "some "}ways to do so`;
  return [
    element("span", {}, `${fewest} to be left out for anything to agree; ${count}: `),
    element(
      "span",
      { class: "buttons", role: "group", "aria-label": "Fewest readings to leave out" },
      ways.map((rows, index) =>
        element("button", { type: "button", "data-way": `${index}` }, `without ${shortEnumeration(rows)}`),
      ),
    ),
  ];
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
 * How far an end moved outwards; null for without end.
 * @param {Rational | null} before
 * @param {Rational | null} after
 */
function movedBy(before, after) {
  if (before === null) return ZERO;
  return after === null ? null : after.minus(before).absolute();
}

/**
 * Whether two regions are the same set.
 * @param {Region} one
 * @param {Region} other
 */
function isSame(one, other) {
  /** @param {Region} region */
  const corners = ({ vertices }) => vertices.map(({ theta }) => theta.join()).sort().join(";");
  return one.kind === other.kind && one.rays.length === other.rays.length && corners(one) === corners(other);
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 */
function effect(lesson, state, scene) {
  const rows = state.without;
  if (rows.length === 0)
    return [element("p", {}, "Choose a reading to switch off, here, or several in the table of readings below.")];
  const readings = `Reading${rows.length === 1 ? "" : "s"} ${shortEnumeration(rows)}`;
  const [does, them] = rows.length === 1 ? ["does", "it"] : ["do", "them"];
  const entry = rows.length === 1 ? lesson.data.leave_one_out.find(({ row }) => row === rows[0]) : undefined;
  if (entry === undefined ? isSame(lesson.fps, scene.region) : !entry.matters) {
    return [
      element(
        "p",
        { id: "leave-one-out-verdict", "data-matters": "false" },
        lesson.fps.kind === "empty"
          ? `${readings} ${does} not matter: without ${them} the feasible parameter set is empty as well.`
          : `${readings} ${does} not matter: without ${them} the feasible parameter set is exactly the same, and so is the PUI.`,
      ),
    ];
  }
  const matter = rows.length === 1 ? "matters" : "matter";
  const before = boundsOf(lesson.fps);
  const after = scene.bounds;
  if (before === null) {
    return [
      element(
        "p",
        { id: "leave-one-out-verdict", "data-matters": "true" },
        `${readings} ${matter}: without ${them} the set is ${after === null ? "still empty, for another reason" : "no longer empty"}.`,
      ),
    ];
  }
  const ends = ENDS.map(({ parameter, axis, end }) => {
    const moved = entry?.moved.find((move) => move.parameter === parameter && move.end === end);
    const exact = movedBy(before[axis][end], after === null ? null : after[axis][end]);
    const by = exact === null ? "to infinity" : exact.isZero() ? "not at all" : withMinus(moved?.by?.decimal ?? decimal(exact));
    return element(
      "tr",
      {
        "data-moved": `${parameter}-${end}`,
        "data-by": exact?.toString() ?? "",
      },
      element("th", { scope: "row" }, `${THETA[axis]} ${end}`),
      element("td", { class: "number" }, shownEnd(before[axis], end)),
      element("td", { class: "number" }, after === null ? "–" : shownEnd(after[axis], end)),
      element("td", { class: "number", title: exact?.toString() ?? null }, by),
    );
  });
  const heads = ["PUI end", `with ${them}`, `without ${them}`, "moves outward by"].map((head) =>
    element("th", { scope: "col" }, head),
  );
  return [
    element(
      "p",
      { id: "leave-one-out-verdict", "data-matters": "true" },
      `${readings} ${matter}. The set without ${them} (solid) contains the one with ${them} (dashed).`,
    ),
    element(
      "div",
      { class: "scroll" },
      element(
        "table",
        { id: "leave-one-out-effect" },
        element("thead", {}, element("tr", {}, heads)),
        element("tbody", {}, ends),
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
  byId("leave-out").value = state.without.length === 1 ? `${state.without[0]}` : "";
  if (state.mode !== "leave-one-out") return;
  const rows = state.without;
  byId("switch-sentence").textContent =
    rows.length === 0 ? "All readings are used." : `${switchedOff(rows)} The set is now ${scene.summary}.`;
  patch(byId("leave-one-out-story"), effect(lesson, state, scene));
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
    const off = state.mode === "leave-one-out" && state.without.includes(reading.row);
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
