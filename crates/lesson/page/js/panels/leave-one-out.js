// @ts-check
// The table of readings with their switches, and what the PUI gains or loses by one of them.

import { byId, closest, element, patch, targetOf } from "../dom.js";
import { boundsOf } from "../model/lesson.js";
import { decimal, endText, nameOfX, plain, shortList, switchedOff, thetaName } from "../model/format.js";
import { ZERO } from "../model/rational.js";
import { numberText, t } from "../texts.js";

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
    element("option", { value: `${row}` }, t(matters ? "switch.option" : "switch.option-idle", { row }));
  patch(
    byId("leave-out"),
    [element("option", { value: "" }, t("switch.none")), lesson.data.leave_one_out.map(option)].flat(),
  );
}

/**
 * The fewest readings to leave out, with a button for each way, where not all agree.
 * @param {Lesson} lesson
 */
function outlierButtons({ data, fps }) {
  if (fps.kind !== "empty") return [];
  if (data.outliers === null)
    return [element("small", {}, t("switch.outliers-unknown"))];
  const { least, ways, complete } = data.outliers;
  const isOnlyOne = complete && ways.length === 1;
  const fewest = isOnlyOne ? "switch.outliers-one" : complete ? "switch.outliers-all" : "switch.outliers-some";
  return [
    element("span", {}, t(fewest, { least }), " "),
    element(
      "span",
      { class: "buttons", role: "group", "aria-label": t("switch.outliers") },
      ways.map((rows, index) =>
        element("button", { type: "button", "data-way": `${index}` }, t("switch.without", { rows: shortList(rows) })),
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
    return [element("p", {}, t("switch.choose"))];
  const values = { rows: shortList(rows) };
  const entry = rows.length === 1 ? lesson.data.leave_one_out.find(({ row }) => row === rows[0]) : undefined;
  if (entry === undefined ? isSame(lesson.fps, scene.region) : !entry.matters) {
    return [
      element(
        "p",
        { id: "leave-one-out-verdict", "data-matters": "false" },
        t(lesson.fps.kind === "empty" ? "switch.idle-empty" : "switch.idle", values),
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
        t(after === null ? "switch.still-empty" : "switch.not-empty", values),
      ),
    ];
  }
  const ends = ENDS.map(({ parameter, axis, end }) => {
    const moved = entry?.moved.find((move) => move.parameter === parameter && move.end === end);
    const exact = movedBy(before[axis][end], after === null ? null : after[axis][end]);
    const by = exact === null ? t("switch.to-infinity") : exact.isZero() ? t("switch.not-at-all") : numberText(moved?.by?.decimal ?? decimal(exact, 5, "up"));
    return element(
      "tr",
      {
        "data-moved": `${parameter}-${end}`,
        "data-by": exact?.toString() ?? "",
      },
      element("th", { scope: "row" }, t(end === "lower" ? "switch.end-lower" : "switch.end-upper", { theta: thetaName(lesson, axis) })),
      element("td", { class: "number" }, shownEnd(before[axis], end)),
      element("td", { class: "number" }, after === null ? "–" : shownEnd(after[axis], end)),
      element("td", { class: "number", title: exact?.toString() ?? null }, by),
    );
  });
  const heads = [t("switch.head-end"), t("switch.head-with", values), t("switch.head-without", values), t("switch.head-moves")].map((head) =>
    element("th", { scope: "col" }, head),
  );
  return [
    element(
      "p",
      { id: "leave-one-out-verdict", "data-matters": "true" },
      t("switch.matters", values),
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
    rows.length === 0
      ? t("switch.all-used")
      : t("switch.sentence", { off: switchedOff(rows), now: t("switch.now", { set: scene.summary }) });
  patch(byId("leave-one-out-story"), effect(lesson, state, scene));
}

/**
 * Draws the table of readings.
 * @param {Lesson} lesson
 * @param {State} state
 */
export function drawReadings(lesson, state) {
  const { model } = lesson.data;
  const columns = model.kind === "line" ? [nameOfX(lesson.data)] : model.regressors;
  // ε is the distance of the bounds from their middle, which need not be y.
  const middles = lesson.readings.some(({ middle, y }) => !middle.equals(y)) ? ["m"] : [];
  const heads = [t("readings.row"), ...columns, model.y, ...middles, "ε", t("readings.matters"), t("readings.use")];
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
            "aria-label": t("readings.show", { row: reading.row }),
          },
          `${reading.row}`,
        ),
      ),
      columns.map((_, k) => element("td", { class: "number" }, plain(reading.phi[k], lesson.widths.phi[k]))),
      element("td", { class: "number" }, plain(reading.y, lesson.widths.y)),
      middles.map(() => element("td", { class: "number" }, reading.fixed === null ? plain(reading.middle, lesson.widths.y) : "")),
      element("td", { class: "number" }, reading.fixed === null ? plain(reading.epsilon) : t("readings.one-bound")),
      element("td", {}, matters ? element("b", {}, t("readings.yes")) : t("readings.no")),
      element(
        "td",
        {},
        element("input", {
          type: "checkbox",
          id: `leave-out-${reading.row}`,
          "data-row": reading.row,
          checked: !off,
          "aria-label": t("readings.use-one", { row: reading.row }),
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
