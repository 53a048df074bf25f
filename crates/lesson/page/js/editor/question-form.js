// @ts-check
// What is asked of the readings: the bound on their errors, conditions, the form of the line.

import { element } from "../dom.js";
import { problemNote } from "./grid.js";
import { cellIn, showsComma, swapped, typedFormula } from "./marks.js";
import { textOf, withBounds, withRequest } from "./sheet.js";
import { boundAt } from "../model/lesson.js";
import { ONE } from "../model/rational.js";
import { formulaText, t } from "../texts.js";

/** @type {("eps" | "column" | "interval")[]} */
const KINDS_OF_BOUNDS = ["eps", "column", "interval"];

/** What the hints show. */
const NUMBER_IN_HINT = "0.5e-3";
const CONDITION_IN_HINT = "theta1 >= 0.5";

/** @type {Record<string, string>} */
const OTHER_MARK = { "number-comma": "number-point", "number-point": "number-comma" };

/**
 * What is wrong with a formula whose marks were exchanged for the engine, in the marks that were typed.
 * @param {Problem} problem
 * @returns {Problem}
 */
function withTypedMarks({ refusal, ...place }) {
  const { kind, text } = refusal;
  return { ...place, refusal: { ...refusal, kind: OTHER_MARK[kind] ?? kind, text: text === undefined ? text : swapped(text) } };
}

/** @param {Sheet} sheet */
function kindOfBounds({ request: { eps_column, lower, upper } }) {
  if (eps_column !== undefined) return "column";
  return lower ?? upper ? "interval" : "eps";
}

/**
 * @param {Sheet} sheet
 * @param {Problem | null} problem
 * @param {{ place: string, text: string } | null} typing
 */
export function questionForm(sheet, problem, typing) {
  const kind = kindOfBounds(sheet);
  const { eps, where, through_origin } = sheet.request;
  const comma = showsComma(sheet);
  const [number, condition] = [NUMBER_IN_HINT, CONDITION_IN_HINT].map((text) => formulaText(text, comma));
  /** @param {string} id @param {string} text @param {string} width */
  const field = (id, text, width) => {
    const isWrong = problem?.key === id;
    return element(
      "label",
      { class: "field" },
      t(`edit.${id}`),
      " ",
      element("input", {
        type: "text",
        id,
        size: width,
        autocomplete: "off",
        spellcheck: "false",
        value: typing?.place === id ? typing.text : comma && isWrong ? swapped(text) : formulaText(text, comma),
        "aria-invalid": isWrong ? "true" : null,
        "aria-describedby": `${id}-hint`,
      }),
      element("small", { id: `${id}-hint` }, isWrong && problem !== null ? problemNote(comma ? withTypedMarks(problem) : problem) : t(`edit.${id}-hint`, { number, condition })),
    );
  };
  return element(
    "div",
    { class: "controls question" },
    element(
      "label",
      {},
      t("edit.bounds"),
      " ",
      element("select", { id: "bounds-kind" }, KINDS_OF_BOUNDS.map((own) => element("option", { value: own, selected: own === kind }, t(`edit.bounds.${own}`)))),
    ),
    kind === "eps" ? field("eps", textOf(eps), "14") : null,
    field("where", (where ?? []).map(textOf).join("; "), "26"),
    typeof sheet.request.x === "string"
      ? element("label", {}, element("input", { type: "checkbox", id: "through-origin", checked: through_origin === true }), t("edit.through-origin"))
      : null,
  );
}

/**
 * The sheet that a control of the form asks for; null for a control of another kind, or where nothing changes.
 * @param {PageElement} input
 * @param {Sheet} sheet
 * @param {Lesson} lesson
 */
export function askedBy(input, sheet, lesson) {
  const { id, value, checked } = input;
  const words = typedFormula(value.trim(), sheet);
  if (id === "eps") return words === sheet.request.eps ? null : withRequest(sheet, { eps: words });
  if (id === "where") {
    const conditions = words.split(";").map((own) => own.trim()).filter((own) => own !== "");
    return withRequest(sheet, { where: conditions.length === 0 ? undefined : conditions });
  }
  if (id === "through-origin") return withRequest(sheet, { through_origin: checked ? true : undefined });
  if (id !== "bounds-kind") return null;
  const kind = KINDS_OF_BOUNDS.find((own) => own === value) ?? "eps";
  /** @param {Rational | null} end */
  const text = (end) => (end === null ? "" : cellIn(sheet, end));
  const known = lesson.readings.map((reading) => {
    const [lower, upper] = [boundAt(reading, "lower", ONE), boundAt(reading, "upper", ONE)];
    // A bound on one side has no width.
    const width = lower === null || upper === null ? "" : cellIn(sheet, reading.epsilon);
    return /** @type {const} */ ([reading.row, { width, lower: text(lower), upper: text(upper) }]);
  });
  return withBounds(sheet, kind, new Map(known));
}
