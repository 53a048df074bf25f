// @ts-check
// What is shown at the moment, in words and numbers: the mode, the kind of the set, its PUI, area and active rows.

import { byId, element, patch } from "../dom.js";
import { ONE, Rational, ZERO, evaluate } from "../model/rational.js";
import { boundClass, boundMark, decimal, endText, kindText, shortFraction, switchedOff, thetaName } from "../model/format.js";
import { activeAlong, activeAt, partOf } from "../model/lesson.js";
import { boundAtStop } from "../model/sweep.js";
import { numberText, rich, said, t } from "../texts.js";

const MOST_ACTIVE = 12;

/**
 * An exact number as shown: its decimal, and the fraction behind it.
 * @param {Rational} exact
 * @param {string} shown
 * @param {string | null} [id]
 */
export function numberWithFraction(exact, shown, id = null) {
  const text = exact.toString();
  const fraction =
    numberText(text) === shown
      ? null
      : element("span", { class: "fraction", title: text }, shortFraction(text));
  return element(
    "span",
    { class: "exact", id, "data-exact": text },
    element("span", { class: "decimal" }, shown),
    fraction ? " " : null,
    fraction,
  );
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 */
function sentence(lesson, state, scene) {
  if (state.mode === "clip") {
    const order = lesson.data.orders[state.order];
    return t("summary.clip", { step: state.step, all: order.steps.length, order: said(order.name) });
  }
  if (state.mode === "epsilon") {
    const { name, shown } = boundAtStop(lesson, lesson.stops[state.stop]);
    const isEach = lesson.epsilon === null;
    if (scene.s.equals(ONE)) return isEach ? t("summary.each-given") : t("summary.given", { name, value: shown });
    return isEach
      ? t("summary.each-times", { value: shown })
      : t("summary.times", { name, value: shown, factor: decimal(scene.s) });
  }
  if (state.mode === "leave-one-out" && state.without.length > 0) return switchedOff(state.without);
  return t("summary.all");
}

/**
 * The width of an interval, or nothing.
 * @param {Ends} ends
 */
function widthOf({ lower, upper }) {
  return lower === null || upper === null ? null : upper.minus(lower);
}

/**
 * One end of an interval, rounded outward; "−∞" or "∞" where there is none.
 * @param {Ends} bounds
 * @param {"lower" | "upper"} end
 * @param {string} id
 */
function endOf(bounds, end, id) {
  const value = bounds[end];
  if (value === null) return element("span", { id, "data-exact": "" }, end === "lower" ? "−∞" : "∞");
  return numberWithFraction(value, endText(value, bounds, end), id);
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 */
function areaOf(lesson, state, scene) {
  const { region } = scene;
  if (region.kind === "empty") return ZERO;
  const stop = state.mode === "epsilon" ? lesson.stops[state.stop] : null;
  const area = region === lesson.fps ? lesson.data.fit.fps.area : stop && partOf(lesson, stop).area;
  return (area && writtenArea(area, stop?.s ?? ZERO)) ?? shoelace(region);
}

/**
 * The area as the engine wrote it: null where that takes too many digits.
 * @param {MeasureData | AreaPolynomialData} area
 * @param {Rational} s
 */
function writtenArea(area, s) {
  if ("exact" in area) return area.exact === null ? null : Rational.parse(area.exact);
  const { constant, slope, quadratic } = area;
  if (constant === null || slope === null || quadratic === null) return null;
  return evaluate({ constant, slope, quadratic }, s);
}

/**
 * Steps and switched-off readings come without an area, and a long fraction is not written; the vertices are exact, and so is the
 * sum.
 * @param {Region} region
 */
function shoelace(region) {
  if (region.rays.length > 0 || region.lines.length > 0) return null;
  const { vertices } = region;
  const terms = vertices.map(({ theta: p }, k) => {
    const q = vertices[(k + 1) % vertices.length].theta;
    return p[0].times(q[1]).minus(q[0].times(p[1]));
  });
  return terms.reduce((sum, term) => sum.plus(term), ZERO).over(new Rational(2n));
}

/**
 * Names of the half-planes active somewhere on the region, in the order of the rows.
 * @param {Lesson} lesson
 * @param {Scene} scene
 */
function activeNames(lesson, scene) {
  const { region } = scene;
  const active = [
    ...region.vertices.flatMap((_, index) => activeAt(lesson, region, index)),
    ...region.boundaries.flatMap((index) => activeAlong(lesson, region, index)),
  ];
  const found = new Map(active.map((name) => [`${name.row} ${name.bound}`, name]));
  return [...found.values()].sort(
    (p, q) => (p.row ?? Infinity) - (q.row ?? Infinity) || (p.bound < q.bound ? 1 : -1),
  );
}

/**
 * Draws the summary.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 */
export function drawSummary(lesson, state, scene) {
  const { region, bounds } = scene;
  const rows = [0, 1].map((axis) => {
    const name = thetaName(lesson, axis);
    const id = `pui-theta${axis + 1}`;
    if (bounds === null)
      return element(
        "tr",
        {},
        element("th", { scope: "row" }, name),
        element("td", { colspan: 3, id: `${id}-none` }, t("summary.no-value")),
      );
    const width = widthOf(bounds[axis]);
    return element(
      "tr",
      {},
      element("th", { scope: "row" }, name),
      element("td", { class: "number" }, endOf(bounds[axis], "lower", `${id}-lower`)),
      element("td", { class: "number" }, endOf(bounds[axis], "upper", `${id}-upper`)),
      element("td", { class: "number" }, width === null ? "∞" : decimal(width, 3)),
    );
  });
  const heads = ["PUI", t("summary.lower"), t("summary.upper"), t("summary.width")].map((head) =>
    element("th", { scope: "col" }, head),
  );
  const area = areaOf(lesson, state, scene);
  const names = activeNames(lesson, scene);
  const shown = names.length > MOST_ACTIVE + 2 ? MOST_ACTIVE : names.length;
  patch(byId("summary"), [
    element(
      "p",
      { id: "shown" },
      element("strong", {}, sentence(lesson, state, scene)),
      " ",
      rich("summary.set", {
        set: element(
          "span",
          { id: "kind", "data-kind": region.kind },
          kindText(region.kind, region.vertices.length),
        ),
      }),
    ),
    element(
      "div",
      { class: "scroll" },
      element(
        "table",
        { class: "pui" },
        element("thead", {}, element("tr", {}, heads)),
        element("tbody", {}, rows),
      ),
    ),
    element(
      "p",
      {},
      rich("summary.area", {
        area:
          area === null
            ? element("span", { id: "area", "data-exact": "" }, t("summary.infinite"))
            : numberWithFraction(area, decimal(area), "area"),
      }),
    ),
    element(
      "p",
      { id: "active" },
      rich("summary.active", {
        names: names.length === 0 ? t("summary.none") : marks(names.slice(0, shown)),
      }),
    ),
    names.length > shown
      ? element(
          "details",
          { id: "active-more" },
          element("summary", {}, t("summary.more", { count: names.length - shown })),
          element("p", {}, marks(names.slice(shown))),
        )
      : null,
  ].filter((part) => part !== null));
}

/** @param {BoundName[]} names */
function marks(names) {
  return names.flatMap((name, k) => [
    ...(k > 0 ? [", "] : []),
    element("span", { class: `name ${boundClass(name)}` }, boundMark(name)),
  ]);
}
