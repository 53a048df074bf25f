// @ts-check
// The layers: what else can be drawn over the feasible set, and the list in which they are switched on.

import { byId, element, patch } from "../dom.js";
import { mark } from "../planes/axes.js";
import { Rational } from "../model/rational.js";
import { THETA, withMinus } from "../model/format.js";

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
    .map((end) => (end !== null && "value" in end ? end.value : end))
    .filter((value) => value !== null);
  if (values.length < 4) return null;
  const [left, right, bottom, top] = values.map((value) => Rational.parse(value.exact));
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
    fit.reasons?.[key] ?? (fit.fps.kind === "empty" ? "the FPS is empty" : "the FPS is unbounded");
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
      "PUI box",
      "the smallest box around the FPS; its corners need not be feasible",
      boxCorners(fit.pui),
      reason("pui"),
    ),
    area(
      "eui-box",
      "EUI box",
      "from least squares alone; at least as large",
      boxCorners(fit.eui),
      reason("eui"),
    ),
    point(
      "least-squares",
      "Least squares",
      fit.least_squares?.in_fps ? "inside the FPS here" : "not in the FPS here",
      "cross",
      fit.least_squares?.theta,
      "least_squares",
    ),
    point("central", "Central estimate", "the middle of the PUI box", "plus", fit.central?.theta, "central"),
    point("minimax", "Minimax estimate", minimaxNote(fit.minimax), "diamond", fit.minimax?.theta, "minimax"),
    point(
      "centroid",
      "Centroid",
      "the centre of gravity of the FPS",
      "triangle",
      fit.area_centroid,
      "area_centroid",
    ),
    area(
      "inner-hull",
      `Inner hull, ${directions.count} directions`,
      "the hull of the optimisers of as many linear programs: inside the FPS",
      bounded ? corners(directions.inner) : null,
      reason("central"),
    ),
    area(
      "outer-polygon",
      `Outer polygon, ${directions.count} directions`,
      "the supporting half-planes of the same directions: around the FPS",
      bounded ? corners(directions.outer) : null,
      reason("central"),
    ),
    {
      id: "lp",
      name: "LP optimisers",
      note: "where floating-point linear programming ends up; judged below",
      shape: "square",
      polygon: null,
      points: solved.map(pointOf),
      why: solved.length > 0 ? null : "no solver returned a point",
    },
  ];
}

/** @param {FitData["minimax"]} minimax */
function minimaxNote(minimax) {
  if (!minimax) return "";
  return minimax.unique
    ? "the last point left as ε shrinks to its least value"
    : "one of the last points left as ε shrinks";
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
          element("small", {}, layer.why === null ? layer.note : `not here: ${layer.why}`),
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
        element("td", {}, `${THETA[Number(claim.parameter.at(-1)) - 1]} ${claim.end}`),
        element(
          "td",
          { class: "number" },
          claim.claimed === null ? "none" : withMinus(claim.claimed.decimal),
        ),
        element("td", {}, element("b", {}, claim.verdict), claim.reason ? `: ${claim.reason}` : ""),
      ),
    ),
  );
  const heads = ["Solver", "End of PUI", "Claimed", "Verdict"].map((head) =>
    element("th", { scope: "col" }, head),
  );
  return [
    element("h4", {}, "The referee’s verdict on the linear programs"),
    element(
      "p",
      {},
      "An exact solver judges each claim in proportion: exact, rounded (right to the last digits a float has), within tolerance (off by at most a millionth of the width), loose (too wide), or wrong.",
    ),
    element(
      "div",
      { class: "scroll", tabindex: 0, role: "region", "aria-label": "Verdicts" },
      element(
        "table",
        { id: "verdicts" },
        element("thead", {}, element("tr", {}, heads)),
        element("tbody", {}, rows),
      ),
    ),
  ];
}
