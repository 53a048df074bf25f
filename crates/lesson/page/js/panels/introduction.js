// @ts-check
// The parts of the text that depend on the data.

import { all, byId, element, patch } from "../dom.js";
import { kindText, nameOfX, plain, shortList } from "../model/format.js";
import { Rational } from "../model/rational.js";
import { fillTexts, formulaText, numberText, rich, t } from "../texts.js";
import { teacherValues } from "./teacher.js";

const LONGEST_IN_FORMULA = 14;

/** The file of readings that come from none, in the words of the program. */
const STANDARD_INPUT = "standard input";

/**
 * Fills in titles, names of columns and the data set's own facts.
 * @param {Lesson} lesson
 */
export function fillIntroduction(lesson) {
  const { data } = lesson;
  const { model } = data;
  /** @type {Record<string, string>} */
  const names =
    model.kind === "line"
      ? { x: nameOfX(data), y: model.y }
      : { u: model.regressors[0], v: model.regressors[1], y: model.y };
  const { name: x, sign, size } = countedFrom(lesson, names.x ?? "");
  const shift = size === "" ? "" : ` ${sign} ${size}`;
  fillTexts({
    ...names,
    phi: rich(lesson.isLine ? "introduction.phi-line" : "introduction.phi-two", { ...names, x, shift }),
    epsilon: statedBound(lesson),
    conditions:
      data.conditions.length === 0 ? "" : t("conditions.within", { list: { list: data.conditions.map(({ text }) => formulaText(text)) } }),
    minimax: minimaxSentence(lesson),
    ...teacherValues(lesson),
  });
  byId("title").textContent = titleOf(lesson);
  byId("provenance").textContent = provenance(lesson);
  byId("epsilon-label").textContent = t(lesson.epsilon === null ? "epsilon.label-factor" : "epsilon.label");
  // A formula has no place to break a line.
  /** @type {Record<string, string>} */
  const inFormulas = { ...names, x, middle: hasOwnBounds(lesson) ? "m" : names.y };
  for (const place of all("mi[data-name]")) place.textContent = shortName(inFormulas[place.dataset.name ?? ""] ?? "");
  byId("origin-sign").textContent = sign;
  byId("origin-size").textContent = size;
  for (const place of all("[data-origin]")) place.toggleAttribute("data-off", size === "");
  for (const place of all("[data-around]")) place.toggleAttribute("data-off", hasOwnBounds(lesson));
  for (const place of all("[data-model]"))
    place.toggleAttribute("data-off", place.dataset.model !== model.kind);
  patch(byId("readings-note"), whichMatter(lesson));
  byId("condition-legend").hidden = data.conditions.length === 0;
  byId("linked-hint").textContent = t(lesson.isLine ? "linked.line" : "linked.two", {
    set: kindText(lesson.fps.kind, lesson.fps.vertices.length),
    shaded: lesson.fps.kind === "empty" ? 1 : 2,
  });
  byId("data-legend").textContent = dataLegend(lesson);
  byId("residual-label").textContent =
    lesson.reference === null ? t("view.residuals") : t(`relative.${lesson.reference.name}`);
}

/**
 * The title that was given, or one made of the file and the columns.
 * @param {Lesson} lesson
 */
function titleOf({ data }) {
  if (!data.is_default_title) return data.title;
  const { model } = data;
  const list = model.kind === "line" ? [nameOfX(data)] : model.regressors;
  // Readings that were typed or linked have no file to name.
  const key = data.file === STANDARD_INPUT ? "page.title-of-input" : "page.title";
  return t(key, { file: data.file, y: model.y, x: { list } });
}

/**
 * The column of x, and from where it is counted: `year − 1980` is the name of a difference.
 * @param {Lesson} lesson
 * @param {string} name
 */
function countedFrom({ data }, name) {
  const parts = /^(.*) ([+\u2212]) (\S+)$/s.exec(name);
  if (data.asked.x_origin === undefined || parts === null) return { name, sign: "", size: "" };
  return { name: parts[1], sign: parts[2], size: numberText(parts[3]) };
}

/**
 * Whether readings have bounds about middles of their own, which need not be what was read.
 * @param {Lesson} lesson
 */
const hasOwnBounds = ({ data, readings }) =>
  data.epsilon.uniform === null && (data.epsilon.column === null || readings.some(({ middle, y }) => !middle.equals(y)));

/** @param {Lesson} lesson */
function uniformBound({ readings }) {
  return readings.length === 0 ? "" : plain(readings[0].epsilon);
}

/** @param {Lesson} lesson */
function unitOf({ data }) {
  return data.epsilon.uniform !== null && data.units.y ? ` ${data.units.y}` : "";
}

/** @param {Lesson} lesson */
function provenance(lesson) {
  const { data, readings: { length } } = lesson;
  const { uniform, column } = data.epsilon;
  const bound =
    uniform !== null
      ? t("provenance.uniform", { epsilon: uniformBound(lesson) })
      : column === null
        ? t("provenance.own")
        : data.asked.eps === undefined
          ? t("provenance.column", { column })
          : t("provenance.rule", { rule: formulaText(data.asked.eps) });
  const readings =
    data.others.length === 0
      ? t("count.readings", { count: length })
      : t("provenance.of", { readings: length, all: length + data.others.length });
  // A title that nobody gave begins with the name of the file.
  const file = data.is_default_title || data.file === STANDARD_INPUT ? [] : [data.file];
  return [...file, readings, bound + unitOf(lesson)].join(" · ");
}

/**
 * What the error bounds are, and what they stand and fall with if they were found from the readings.
 * @param {Lesson} lesson
 */
function statedBound(lesson) {
  const { epsilon, fit } = lesson.data;
  const own = t(hasOwnBounds(lesson) ? "epsilon.stated-own" : "epsilon.stated-each");
  const stated = epsilon.uniform === null ? own : ` = ${uniformBound(lesson)}${unitOf(lesson)}`;
  const multiple = fit.input.epsilon_from_least;
  if (multiple === undefined) return stated;
  const [factor, least] = [multiple.factor, multiple.epsilon_min].map(({ exact }) => plain(Rational.parse(exact)));
  return stated + (factor === "1" ? t("epsilon.is-least", { least }) : t("epsilon.from-least", { factor, least }));
}

/** @param {Lesson} lesson */
function dataLegend(lesson) {
  const { data, fps, isLine, leastSquares } = lesson;
  const words = [
    t(hasOwnBounds(lesson) ? "legend.bars-own" : "legend.bars"),
    t(isLine ? "legend.lines" : "legend.predictions", { empty: fps.kind === "empty" ? 2 : 1 }),
  ];
  if (leastSquares !== null) words.push(t("legend.squares"));
  if (data.others.length > 0 && isLine) words.push(t("legend.others"));
  return words.join(" ");
}

/** @param {string} name */
function shortName(name) {
  return name.length <= LONGEST_IN_FORMULA ? name : `${name.slice(0, LONGEST_IN_FORMULA - 1)}…`;
}

/**
 * Which readings cannot be left out without a change.
 * @param {Lesson} lesson
 */
function whichMatter(lesson) {
  const count = lesson.readings.length;
  const rows = lesson.readings.map(({ row }) => row).filter((row) => lesson.matters.get(row));
  if (rows.length === 0) return [t("matter.none")];
  const found =
    count === 1
      ? t("matter.only")
      : rows.length === count
        ? t("matter.all", { count })
        : rows.length === 1
          ? t("matter.one", { count, row: rows[0] })
          : t("matter.some", { count, matter: rows.length, rows: shortList(rows) });
  return [`${found} `, element("span", { class: "for-screen" }, t("matter.trial"))];
}

/**
 * What remains when the error bounds shrink.
 * @param {Lesson} lesson
 */
function minimaxSentence(lesson) {
  const { conditions, epsilon, fit } = lesson.data;
  if (fit.minimax === null) return rich("minimax.none");
  const isFactor = epsilon.uniform === null;
  const values = { conditions: conditions.length, factor: isFactor ? 2 : 1 };
  return rich(fit.minimax.unique ? "minimax.unique" : "minimax.several", {
    symbol: isFactor ? "s" : "ε",
    measure: t(lesson.isLine ? "minimax.line" : "minimax.parameter", values),
  });
}
