// @ts-check
// The layers: what else can be drawn over the feasible set, and the list in which they are switched on.

import { byId, element, patch } from "../dom.js";
import { mark } from "../planes/axes.js";
import { Rational } from "../model/rational.js";
import { THETA } from "../model/format.js";
import { numberText, reasonText, said, t } from "../texts.js";

/**
 * A point to be drawn: where its fractions are too long to be written, five digits show the same.
 * @param {(NumberData | MeasureData)[]} theta
 */
const pointOf = (theta) =>
  theta.map(({ exact, decimal }) => (exact === null ? Rational.parseDecimal(decimal) : Rational.parse(exact)));

/** @param {FitData["eui"] | FitData["pui"]} ends */
function boxCorners(ends) {
  if (ends === null) return null;
  const values = ends
    .flatMap((end) => [end.lower, end.upper])
    .flatMap((end) => end?.exact ?? []);
  if (values.length < 4) return null;
  const [left, right, bottom, top] = values.map((value) => Rational.parse(value));
  return [
    [left, bottom],
    [right, bottom],
    [right, top],
    [left, top],
  ];
}

/**
 * The layers of a lesson.
 * @param {Lesson} lesson
 * @returns {Layer[]}
 */
export function layersOf(lesson) {
  const { fit, layers } = lesson.data;
  /** @param {string} key */
  const reason = (key) =>
    reasonText(fit.reasons?.[key] ?? (fit.fps.kind === "empty" ? t("reason.1") : t("reason.2")));
  /**
   * @param {string} id
   * @param {string} name
   * @param {string} note
   * @param {Shape} shape
   * @param {(NumberData | MeasureData)[] | null | undefined} theta
   * @param {string} key
   */
  const point = (id, name, note, shape, theta, key) => ({
    id,
    name,
    note,
    shape,
    polygon: null,
    points: theta ? [pointOf(theta)] : [],
    why: theta ? null : reason(key),
  });
  /**
   * @param {string} id
   * @param {string} name
   * @param {string} note
   * @param {Pair[] | null} polygon
   * @param {string} why
   */
  const area = (id, name, note, polygon, why) => {
    const drawn = polygon !== null && polygon.length > 0;
    return {
      id,
      name,
      note,
      shape: null,
      polygon: drawn ? polygon : null,
      points: [],
      why: drawn ? null : why,
    };
  };
  const { directions } = layers;
  /** @param {number[] | null} indices */
  const corners = (indices) => indices?.map((index) => lesson.points[index]) ?? null;
  // The list of an unbounded outer polygon is not a closed one.
  const bounded = fit.central !== null;
  const solved = layers.lp.flatMap((solver) => solver.claims).flatMap(({ point }) => (point === null ? [] : [point]));
  return [
    area(
      "pui-box",
      t("layer.pui-box"),
      t("layer.pui-box-note"),
      boxCorners(fit.pui),
      reason("pui"),
    ),
    area(
      "eui-box",
      t("layer.eui-box"),
      t("layer.eui-box-note"),
      boxCorners(fit.eui),
      reason("eui"),
    ),
    point(
      "least-squares",
      t("layer.least-squares"),
      t(fit.least_squares?.in_fps ? "layer.least-squares-in" : "layer.least-squares-out"),
      "cross",
      fit.least_squares?.theta,
      "least_squares",
    ),
    point("central", t("layer.central"), t("layer.central-note"), "plus", fit.central?.theta, "central"),
    point("minimax", t("layer.minimax"), minimaxNote(fit.minimax), "diamond", fit.minimax?.theta, "minimax"),
    point(
      "centroid",
      t("layer.centroid"),
      t("layer.centroid-note"),
      "triangle",
      fit.area_centroid,
      "area_centroid",
    ),
    area(
      "inner-hull",
      t("layer.inner-hull", { count: directions.count }),
      t("layer.inner-hull-note"),
      bounded ? corners(directions.inner) : null,
      reason("central"),
    ),
    area(
      "outer-polygon",
      t("layer.outer-polygon", { count: directions.count }),
      t("layer.outer-polygon-note"),
      bounded ? corners(directions.outer) : null,
      reason("central"),
    ),
    {
      id: "lp",
      name: t("layer.lp"),
      note: t("layer.lp-note"),
      shape: "square",
      polygon: null,
      points: solved.map(pointOf),
      why: solved.length > 0 ? null : t("reason.10"),
    },
  ];
}

/** @param {FitData["minimax"]} minimax */
function minimaxNote(minimax) {
  if (!minimax) return "";
  return t(minimax.unique ? "layer.minimax-unique" : "layer.minimax-several");
}

/**
 * The symbol of a layer, as in the pictures.
 * @param {Layer} layer
 */
function symbol(layer) {
  const drawing =
    layer.polygon === null && layer.shape !== null
      ? mark(layer.shape, [14, 9], { class: `mark layer-${layer.id}` })
      : element("path", { class: `outline layer-${layer.id}`, d: "M2 9H26" });
  return element("svg", { class: "symbol", width: 28, height: 18, "aria-hidden": "true" }, drawing);
}

/**
 * Draws the list of layers and the referee's table.
 * @param {Lesson} lesson
 * @param {Layer[]} layers
 * @param {State} state
 */
export function drawLayerList(lesson, layers, state) {
  /** @param {Layer} layer */
  const row = (layer) =>
    element(
      "li",
      {},
      element(
        "label",
        { class: layer.why === null ? null : "unavailable" },
        element("input", {
          type: "checkbox",
          id: `layer-${layer.id}`,
          "data-layer": layer.id,
          disabled: layer.why !== null,
          checked: state.layers.has(layer.id),
        }),
        symbol(layer),
        element(
          "span",
          {},
          element("b", {}, layer.name),
          " ",
          element("small", {}, layer.why === null ? layer.note : t("layer.not-here", { why: layer.why })),
        ),
      ),
    );
  patch(byId("layer-list"), layers.map(row));
  patch(byId("referee"), state.layers.has("lp") ? refereeTable(lesson) : []);
}

/** @param {Lesson} lesson */
function refereeTable(lesson) {
  const rows = lesson.data.layers.lp.flatMap((solver) =>
    solver.claims.map((claim) =>
      element(
        "tr",
        { "data-verdict": claim.verdict },
        element("th", { scope: "row" }, solver.source),
        element("td", {}, t(claim.end === "lower" ? "switch.end-lower" : "switch.end-upper", { theta: THETA[Number(claim.parameter.at(-1)) - 1] })),
        element(
          "td",
          { class: "number" },
          claim.claimed === null ? t("referee.none") : numberText(claim.claimed.decimal),
        ),
        element("td", {}, element("b", {}, t(`verdict.${claim.verdict.replaceAll(" ", "-")}`)), claim.reason ? `: ${said(claim.reason)}` : ""),
      ),
    ),
  );
  const heads = [t("referee.solver"), t("referee.end"), t("referee.claimed"), t("referee.verdict")].map((head) =>
    element("th", { scope: "col" }, head),
  );
  return [
    element("h4", {}, t("referee.title")),
    element(
      "p",
      {},
      t("referee.hint"),
    ),
    element(
      "div",
      { class: "scroll", tabindex: 0, role: "region", "aria-label": t("referee.table") },
      element(
        "table",
        { id: "verdicts" },
        element("thead", {}, element("tr", {}, heads)),
        element("tbody", {}, rows),
      ),
    ),
  ];
}
