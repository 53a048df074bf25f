// @ts-check
// The worst acceptable lines in words: what the lines by hand miss, and how far they are from the exact ones.

import { byId, element, patch } from "../dom.js";
import { activeAt, conflict } from "../model/lesson.js";
import { boundMark, conditionNumber, decimal, endText, thetaName } from "../model/format.js";
import { HALF, Rational } from "../model/rational.js";
import { WORST, cornerToCorner, faultsOf, gripsOf, isGreatest, lineByHand, worstVertex } from "../model/worst-line.js";
import { numberText, t } from "../texts.js";

const MOST_MISSED = 12;
const HUNDRED = new Rational(100n);

/** @param {Store} store */
export function connectWorstLine(store) {
  byId("worst-reset").addEventListener("click", () => store.change({ hand: null }));
  byId("worst-exact").addEventListener("click", () => store.change({ exactLines: !store.get().exactLines }));
}

/**
 * The lines by hand with what is wrong with them.
 * @param {Lesson} lesson
 * @param {State} state
 */
function linesByHand(lesson, state) {
  const hand = state.hand ?? cornerToCorner(lesson);
  return WORST.map((name) => {
    const theta = lineByHand(lesson, hand[name]);
    const { missed, broken } = faultsOf(lesson, theta);
    return { name, theta, missed, broken, passes: missed.length === 0 && broken.length === 0 };
  });
}

/** @typedef {ReturnType<typeof linesByHand>[number]} ByHand */

/**
 * The numbers of all conditions, as a value for sentences that hold only for lines that keep them.
 * @param {Lesson} lesson
 */
const conditionsOf = ({ data }) => ({ list: data.conditions.map((_, k) => k + 1) });

/**
 * The numbers of the conditions that a line breaks; an equation can be broken on one side only.
 * @param {ByHand} line
 */
const brokenBy = ({ broken }) => [...new Set(broken.map(({ name }) => conditionNumber(name)))];

/**
 * Which bars a line misses and which conditions it breaks.
 * @param {ByHand} line
 */
function verdict(line) {
  const { missed, passes } = line;
  if (passes) return t("worst.passes");
  const rows = missed.map(({ reading }) => reading.row);
  const worst = missed.reduce((most, one) => (one.excess.compare(most.excess) > 0 ? one : most), missed[0]);
  const words = missed.length === 0 ? [] : [t("worst.misses", { rows: { list: rows.slice(0, MOST_MISSED), more: Math.max(0, rows.length - MOST_MISSED) }, most: { number: decimal(worst.excess, 3) } })];
  return [...words, ...brokenBy(line).map((number) => t("worst.breaks", { number }))].join("; ");
}

/**
 * How far the slope by hand is from the one that no feasible line exceeds.
 * @param {Lesson} lesson
 * @param {ByHand} line
 */
function distance(lesson, line) {
  const { name, theta, passes } = line;
  const index = worstVertex(lesson, name);
  const isUpper = isGreatest(lesson, name);
  if (index === null) return lesson.fps.kind === "empty" ? "" : t(name === "steepest" && !isUpper ? "worst.endless.falling" : `worst.endless.${name}`);
  const exact = lesson.fps.vertices[index].theta[0];
  const short = isUpper ? exact.minus(theta[0]) : theta[0].minus(exact);
  const values = { conditions: conditionsOf(lesson), by: { number: decimal(short.absolute(), 3) } };
  if (short.isZero()) return passes ? t(`worst.reached.${name}`, values) : t(`worst.equal.${name}`, { verdict: verdict(line) });
  return t(`worst.${short.sign() > 0 ? "short" : "beyond"}.${name}`, values);
}

/**
 * Slope ± half the difference of both, as school books report it, beside the exact interval.
 * @param {Lesson} lesson
 * @param {ByHand[]} lines
 * @param {boolean} isShown
 */
function result(lesson, lines, isShown) {
  const inOrder = isGreatest(lesson, "steepest") ? WORST : [...WORST].reverse();
  const [greatest, least] = inOrder.map((name) => lines[WORST.indexOf(name)].theta[0]);
  const middle = greatest.plus(least).times(HALF);
  const half = greatest.minus(least).times(HALF);
  const words = [t("worst.result", { middle: { number: decimal(middle) }, half: { number: decimal(half, 3) } })];
  const broken = [...new Set(lines.flatMap(brokenBy))].sort((p, q) => p - q);
  if (lines.some(({ missed }) => missed.length > 0)) words.push(t("worst.none-counts"));
  else if (broken.length > 0) words.push(t("worst.broken-counts", { broken: { list: broken } }));
  else if (half.sign() < 0) words.push(t("worst.swapped"));
  const ends = inOrder.map((name) => worstVertex(lesson, name));
  if (isShown && ends.every((index) => index !== null)) {
    const [upper, lower] = ends.map((index) => lesson.fps.vertices[/** @type {number} */ (index)].theta[0]);
    words.push(t("worst.exact-result", { lower: { number: endText(lower, { lower, upper }, "lower") }, upper: { number: endText(upper, { lower, upper }, "upper") } }));
    const width = upper.minus(lower);
    const counts = lines.every(({ passes }) => passes) && half.sign() >= 0 && width.sign() > 0;
    if (counts) words.push(t("worst.share", { share: { number: decimal(half.plus(half).times(HUNDRED).over(width), 3, "down") } }));
  }
  return words.join(" ");
}

/**
 * Why there is no line through all bars, and when there is one. The conditions are named where the contradiction needs them.
 * @param {Lesson} lesson
 */
function noLine(lesson) {
  if (lesson.fps.kind !== "empty") return "";
  const { minimax } = lesson.data.fit;
  const least = lesson.data.sweep?.least ?? null;
  const parts = conflict(lesson).map(({ index }) => lesson.halfPlanes[index]);
  const numbers = [...new Set(parts.flatMap(({ name, reading }) => (reading === null ? [conditionNumber(name)] : [])))].sort((p, q) => p - q);
  const needed = { conditions: { list: numbers } };
  if (parts.length > 0 && parts.every(({ reading }) => reading === null)) return t("worst.no-line-at-all", needed);
  const words = [numbers.length > 0 ? t("worst.no-line-within", needed) : t("worst.no-line")];
  const conditions = conditionsOf(lesson);
  if (lesson.epsilon !== null && minimax?.epsilon) words.push(t("worst.least-epsilon", { conditions, epsilon: { number: minimax.epsilon.decimal }, exact: minimax.epsilon.exact }));
  else if (least !== null) words.push(t("worst.least-factor", { conditions, factor: { number: least.decimal }, exact: least.exact }));
  return words.join(" ");
}

/**
 * @param {string} name
 * @param {Pair} theta
 * @param {string} words
 * @param {Record<string, unknown>} attributes
 */
function row(name, theta, words, attributes) {
  const numbers = theta.map((value) => element("td", { class: "number", title: value.toString() }, numberText(decimal(value))));
  return element("tr", attributes, element("th", { scope: "row" }, name), numbers, element("td", {}, words));
}

/**
 * What the live region says of the lines.
 * @param {Lesson} lesson
 * @param {State} state
 */
export function worstSentence(lesson, state) {
  if (gripsOf(lesson) === null) return t("worst.no-grips");
  const lines = linesByHand(lesson, state);
  return lines.map((line) => `${t(`worst.${line.name}`)}: ${verdict(line)}.`).join(" ");
}

/**
 * Draws the panel and the table below the pictures.
 * @param {Lesson} lesson
 * @param {State} state
 */
export function drawWorstLine(lesson, state) {
  byId("worst-exact").setAttribute("aria-pressed", `${state.exactLines}`);
  if (state.mode !== "worst-line") return;
  const isPossible = gripsOf(lesson) !== null;
  for (const id of ["worst-reset", "worst-exact"]) byId(id).disabled = !isPossible;
  if (!isPossible) {
    byId("worst-sentence").textContent = t("worst.no-grips");
    patch(byId("worst-line-story"), []);
    return;
  }
  const lines = linesByHand(lesson, state);
  const good = lines.every(({ passes }) => passes);
  byId("worst-sentence").textContent = (state.exactLines && noLine(lesson)) || (good ? t("worst.both-pass") : t("worst.task", { conditions: conditionsOf(lesson) }));
  const byHand = lines.map((line) =>
    row(t(`worst.${line.name}`), line.theta, verdict(line), {
      "data-by-hand": line.name,
      "data-passes": `${line.passes}`,
      "data-theta1": line.theta[0].toString(),
      "data-theta2": line.theta[1].toString(),
    }),
  );
  const exact = WORST.flatMap((name) => {
    const index = state.exactLines ? worstVertex(lesson, name) : null;
    if (index === null) return [];
    const { theta } = lesson.fps.vertices[index];
    const touched = t("worst.touches", { bounds: activeAt(lesson, lesson.fps, index).map(boundMark).join(", ") });
    return [row(t(`worst.exact.${name}`), theta, touched, { class: "exact", "data-exact": name })];
  });
  const heads = [t("worst.line"), thetaName(lesson, 0), thetaName(lesson, 1), t("worst.verdict")];
  const distances = state.exactLines ? lines.map((line) => distance(lesson, line)).filter((words) => words !== "") : [];
  patch(byId("worst-line-story"), [
    element(
      "div",
      { class: "scroll" },
      element(
        "table",
        { id: "worst-lines-table" },
        element("thead", {}, element("tr", {}, heads.map((head) => element("th", { scope: "col" }, head)))),
        element("tbody", {}, byHand, exact),
      ),
    ),
    element("p", { id: "worst-result" }, result(lesson, lines, state.exactLines)),
    ...distances.map((words) => element("p", { class: "distance" }, words)),
  ]);
}
