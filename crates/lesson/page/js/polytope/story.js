// @ts-check
// What the picture of half-planes shows, in words: the set, a step of clipping, the objective with its proof, a pivot.

import { element } from "../dom.js";
import { Rational, dot } from "../model/rational.js";
import { plain, shortEnumeration } from "../model/format.js";
import { t } from "../texts.js";
import { atMostText, exactPair, planeName, sumText } from "./document.js";
import { formText, fractionText, pairText } from "./half-planes.js";

/**
 * A fraction, with its decimal where that says more.
 * @param {Exact} text
 */
function exactValue(text) {
  const exact = Rational.parse(text);
  if (exact.denominator === 1n) return fractionText(exact);
  const decimal = plain(exact);
  const isRounded = !Rational.parseDecimal(decimal.replaceAll("\u2212", "-").replace(",", ".")).equals(exact);
  return `${fractionText(exact)} ${isRounded ? "≈" : "="} ${decimal}`;
}

/**
 * "a polygon with 5 vertices".
 * @param {PolytopeSetData} set
 */
export function kindOfPlanes(set) {
  return t(`polytope.kind-${set.kind}`, { count: set.vertices.length });
}

/**
 * What the whole set is.
 * @param {PolytopeData} answer
 */
export function setSentence(answer) {
  const { set } = answer;
  if (set === null) return "";
  if (set.contradiction !== null) return contradictionSentence(answer, set.contradiction);
  const idle = answer.half_planes.flatMap((own, index) => (own.redundant === null ? [] : [planeName(answer, index)]));
  const many = set.vertices.filter(({ active }) => active.length > 2).length;
  return [
    t("polytope.set-is", { kind: kindOfPlanes(set) }),
    idle.length === 0 ? t("polytope.none-redundant") : t("polytope.are-redundant", { names: { list: idle } }),
    many === 0 ? "" : t("polytope.degenerate", { count: many }),
  ].filter(Boolean).join(" ");
}

/**
 * @param {PolytopeData} answer
 * @param {{ by: PolytopeMultiplierData[], sum: Exact }} contradiction
 */
function contradictionSentence(answer, { by, sum }) {
  return t("polytope.set-empty", { sum: sumText(answer, by), value: fractionText(Rational.parse(sum)) });
}

/**
 * Why a half-plane changes nothing.
 * @param {PolytopeData} answer
 * @param {number} index
 * @param {PolytopeRedundancyData} redundant
 */
export function redundancySentence(answer, index, redundant) {
  const name = planeName(answer, index);
  if (redundant.why === "same-as") return t("polytope.same-as", { name, other: planeName(answer, redundant.by[0].half_plane) });
  if (redundant.why !== "dominated") return t(`polytope.redundant-${redundant.why}`, { name });
  const slack = redundant.slack ?? "0";
  const values = { name, sum: sumText(answer, redundant.by), slack: fractionText(Rational.parse(slack)) };
  return t(slack === "0" ? "polytope.dominated-touching" : "polytope.dominated", values);
}

/**
 * What a step of clipping did.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 */
export function clipSentence(state, answer) {
  if (state.step === 0) return t("polytope.step-none");
  const step = answer.steps[state.step - 1];
  const text = { formula: answer.half_planes[step.half_plane].text };
  const name = planeName(answer, step.half_plane);
  const kind = kindOfPlanes(step.set);
  if (step.redundant !== null) {
    const why = redundancySentence(answer, step.half_plane, step.redundant);
    return `${t("polytope.step-idle", { name, text })} ${why}`;
  }
  if (step.set.contradiction !== null) return `${t("polytope.step-emptied", { name, text })} ${contradictionSentence(answer, step.set.contradiction)}`;
  /** @param {Exact[][]} points */
  const listed = (points) => shortEnumeration(points.map((point) => pairText(exactPair(point))));
  return [
    t("polytope.step-cut", { name, text, kind }),
    step.born.length > 0 ? t("polytope.step-born", { count: step.born.length, corners: listed(step.born) }) : "",
    step.lost.length > 0 ? t("polytope.step-lost", { count: step.lost.length, corners: listed(step.lost) }) : "",
  ].filter(Boolean).join(" ");
}

/**
 * How far the set reaches, and where.
 * @param {PolytopeData} answer
 */
export function objectiveSentence(answer) {
  const { objective } = answer;
  if (objective === null) return "";
  const form = formText(exactPair(objective.form));
  if (objective.outcome === "empty") return t("polytope.objective-empty");
  if (objective.outcome === "unbounded") {
    return t("polytope.objective-unbounded", { form, point: pairText(exactPair(objective.point)), ray: pairText(exactPair(objective.ray)) });
  }
  const { face } = objective;
  if (face.kind === "whole") return t("polytope.objective-zero");
  const points = shortEnumeration(face.points.map((point) => pairText(exactPair(point))));
  const direction = face.direction === null ? "" : pairText(exactPair(face.direction));
  return `${t("polytope.objective-value", { form, value: exactValue(objective.value) })} ${t(`polytope.face-${face.kind}`, { points, direction })}`;
}

/**
 * The multipliers that prove the maximum, in numbers and words.
 * @param {PolytopeData} answer
 */
export function proofStory(answer) {
  const { objective } = answer;
  if (objective === null || objective.outcome !== "bounded") return [];
  const { proof, ways } = objective;
  const form = formText(exactPair(objective.form));
  const rows = proof.map(({ half_plane, multiplier }) => element("tr", {},
    element("th", { scope: "row" }, planeName(answer, half_plane)),
    element("td", {}, `${fractionText(Rational.parse(multiplier))} ·`),
    element("td", {}, atMostText(answer.half_planes[half_plane]))));
  const others = ways.first.slice(1).map((way) => element("li", {}, sumText(answer, way)));
  return [
    element("h4", {}, t("polytope.proof")),
    element("p", { id: "objective-proof", "data-proof": JSON.stringify(proof) }, t("polytope.proof-sum", { sum: sumText(answer, proof), form, value: fractionText(Rational.parse(objective.value)) })),
    element("table", { class: "sum" }, element("tbody", {}, rows, element("tr", { class: "total" },
      element("th", { scope: "row" }, t("polytope.sum")), element("td", {}), element("td", {}, `${form} ≤ ${fractionText(Rational.parse(objective.value))}`)))),
    element("p", { id: "objective-ways", "data-count": ways.count, "data-unique": `${ways.unique}` }, t(ways.unique ? "polytope.proof-unique" : ways.count === 1 ? "polytope.proof-and-nothing" : "polytope.proof-ways", { count: ways.count })),
    others.length > 0 ? element("ul", {}, others) : null,
    element("p", { class: "hint" }, t("polytope.cone-hint")),
  ];
}

/**
 * The basis that is shown, and the pivot that follows.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 */
export function pivotSentence(state, answer) {
  const { simplex, set } = answer;
  if (set?.kind === "empty") return t("polytope.simplex-empty");
  if (simplex === null) return t("polytope.simplex-no-corner");
  const basis = simplex.bases[Math.min(state.pivot, simplex.bases.length - 1)];
  const [one, other] = basis.half_planes.map((index) => planeName(answer, index));
  const here = t("polytope.basis", { corner: pairText(exactPair(basis.theta)), one, other, value: exactValue(basis.value) });
  const { pivot } = basis;
  if (pivot === null) return `${here} ${t("polytope.simplex-optimal")}`;
  const leaving = planeName(answer, pivot.leaving);
  if (pivot.entering === null) return `${here} ${t("polytope.simplex-endless", { leaving, ray: pairText(exactPair(pivot.direction)) })}`;
  const entering = planeName(answer, pivot.entering);
  if (pivot.degenerate) return `${here} ${t("polytope.pivot-degenerate", { leaving, entering })}`;
  const growth = dot(exactPair(answer.objective?.form ?? []), exactPair(pivot.direction)).times(Rational.parse(pivot.length ?? "0"));
  return `${here} ${t("polytope.pivot", { leaving, entering, growth: fractionText(growth) })}`;
}

/**
 * All bases so far as a table.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 */
export function simplexTable(state, answer) {
  const { simplex } = answer;
  if (simplex === null) return [];
  const heads = ["polytope.table-basis", "polytope.table-corner", "polytope.table-value", "polytope.table-times", "polytope.table-pivot"];
  const rows = simplex.bases.slice(0, state.pivot + 1).map((basis, k) => {
    const { pivot } = basis;
    const way = pivot === null ? t("polytope.table-optimal") : `${planeName(answer, pivot.leaving)} → ${pivot.entering === null ? "∞" : planeName(answer, pivot.entering)}`;
    return element("tr", { "data-basis": basis.half_planes.join(" "), "data-degenerate": `${pivot?.degenerate ?? false}`, class: k === state.pivot ? "chosen" : "" },
      element("td", {}, basis.half_planes.map((index) => planeName(answer, index)).join(" ")),
      element("td", {}, pairText(exactPair(basis.theta))),
      element("td", {}, fractionText(Rational.parse(basis.value))),
      element("td", {}, basis.multipliers.map((text) => fractionText(Rational.parse(text))).join("; ")),
      element("td", {}, way, pivot?.degenerate ? ` ${t("polytope.table-degenerate")}` : ""));
  });
  return [
    element("h4", {}, t("polytope.table-title")),
    element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": t("polytope.table-title") },
      element("table", { id: "simplex-table" }, element("thead", {}, element("tr", {}, heads.map((key) => element("th", { scope: "col" }, t(key))))), element("tbody", {}, rows))),
    element("p", { class: "hint" }, t("polytope.bland-hint")),
  ];
}

/**
 * The corners of the set with what is active there, and why half-planes are redundant.
 * @param {PolytopeData} answer
 */
export function setStory(answer) {
  const { set } = answer;
  if (set === null) return [];
  const corners = set.vertices.map(({ theta, active }) => element("tr", { "data-listed-corner": theta.join(" ") },
    element("td", {}, pairText(exactPair(theta))),
    element("td", {}, active.map((index) => planeName(answer, index)).join(" "))));
  const idle = answer.half_planes.flatMap((own, index) => (own.redundant === null || set.kind === "empty" ? [] : [element("li", {}, redundancySentence(answer, index, own.redundant))]));
  const rays = [...set.rays.map((ray) => pairText(exactPair(ray))), ...set.lines.map((line) => `± ${pairText(exactPair(line))}`)];
  return [
    corners.length > 0 ? element("table", {}, element("thead", {}, element("tr", {}, element("th", { scope: "col" }, t("polytope.corner-head")), element("th", { scope: "col" }, t("polytope.active-head")))), element("tbody", {}, corners)) : null,
    set.area === null || set.kind === "empty" ? null : element("p", {}, t("polytope.area", { area: exactValue(set.area) })),
    rays.length > 0 ? element("p", {}, t("polytope.rays", { rays: { list: rays } })) : null,
    idle.length > 0 ? element("ul", { class: "points" }, idle) : null,
  ];
}
