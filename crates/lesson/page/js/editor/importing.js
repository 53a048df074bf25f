// @ts-check
// A table from elsewhere: pasted, dropped or opened. The engine reads it, in whatever form it is; where its header does not say which
// column is which, the reader does.

import { element } from "../dom.js";
import { t } from "../texts.js";
import { sheetOf } from "./sheet.js";

/** What a column can be for, in the order of the form. */
const PURPOSES = ["x", "v", "y", "eps_column", "lower", "upper"];
const BOUNDS = ["eps_column", "lower", "upper"];
// What files call the bound of a reading.
const BOUND_NAMES = { eps_column: /^(eps(ilon)?|ε|e|error|err|tolerance|tol|u)$/i, lower: /^(lower|low|min|from|earliest|at_least)$/i, upper: /^(upper|high|max|to|latest|at_most)$/i };

/**
 * Reads the names of the columns of a table, and whether it has them from a header.
 * @param {Engine} engine
 * @param {string | Uint8Array} table
 * @param {string} file
 * @returns {Promise<{ columns: string[], header: boolean }>}
 */
export async function columnsOf(engine, table, file) {
  return JSON.parse(await engine.ask("columns", table, { file }));
}

/**
 * What the columns are most likely for: as in the sheet that is there, if their names are its; else by their names and order.
 * @param {string[]} columns
 * @param {Sheet | null} sheet
 * @returns {{ choice: Record<string, string>, isSure: boolean }}
 */
export function guessed(columns, sheet) {
  const number = (/** @type {number} */ k) => `${k + 1}`;
  /** @type {Record<string, string>} */
  const choice = {};
  const isKnown = sheet !== null && sheet.columns.every(({ name }) => columns.filter((own) => own.trim() === name).length === 1);
  for (const { name, role } of isKnown ? sheet.columns : []) {
    const key = role === "eps" ? "eps_column" : role === "x" && "x" in choice ? "v" : role;
    choice[key] = number(columns.findIndex((own) => own.trim() === name));
  }
  const left = columns.map((_, k) => k).filter((k) => !Object.values(choice).includes(number(k)));
  const hasBounds = BOUNDS.some((key) => key in choice);
  for (const [key, pattern] of Object.entries(hasBounds ? {} : BOUND_NAMES)) {
    const found = left.find((k) => k > 0 && pattern.test(columns[k].trim()));
    if (found === undefined || (key !== "eps_column" && "eps_column" in choice)) continue;
    choice[key] = number(found);
    left.splice(left.indexOf(found), 1);
  }
  // Bounds that the table has and the sheet has not are the reader's choice, unless nothing else is left.
  if (isKnown) return { choice, isSure: hasBounds || left.length === 0 || !BOUNDS.some((key) => key in choice) };
  if (left.length > 0) choice.x = number(left[0]);
  if (left.length > 1) choice.y = number(left[1]);
  return { choice, isSure: columns.length === 2 || (left.length === 2 && columns.length === 3 && "eps_column" in choice) };
}

/**
 * How the engine is asked for a column: by its name where it has one of its own, since the number of a column may be the name of another.
 * @param {Import} from
 * @param {string | undefined} number
 */
function selector({ columns, hasHeader }, number) {
  const name = number ? columns[Number(number) - 1].trim() : "";
  const isOwn = columns.filter((own) => own.trim() === name).length === 1;
  return hasHeader && isOwn && name !== `col${number}` ? name : number;
}

/**
 * The sheet of a table, made by the engine.
 * @param {Engine} engine
 * @param {Import} from
 * @param {Sheet} sheet what is asked so far
 */
export async function imported(engine, from, sheet) {
  const { table, file, columns, choice, skip } = from;
  const [x, v, y, eps_column, lower, upper] = PURPOSES.map((purpose) => selector(from, choice[purpose]));
  const { where, through_origin, x_origin, reading, eps } = sheet.question;
  // Another column has another origin.
  const isSameX = columns[Number(choice.x) - 1]?.trim() === sheet.columns.find(({ role }) => role === "x")?.name;
  const isOwn = [eps_column, lower, upper].some(Boolean);
  const bounds = { ...(eps_column ? { eps_column } : {}), ...(lower ? { lower } : {}), ...(upper ? { upper } : {}) };
  const options = {
    file,
    x: v ? [x, v] : x,
    ...(y ? { y } : {}),
    ...(isOwn ? bounds : { eps: eps ?? "2*min" }),
    ...(where ? { where } : {}),
    ...(through_origin && !v ? { through_origin } : {}),
    ...(x_origin && !v && isSameX ? { x_origin } : {}),
    ...(reading ? { reading } : {}),
    ...(skip ? { missing: "skip" } : {}),
  };
  return sheetOf(JSON.parse(await engine.ask("lesson", table, options)));
}

/**
 * The form in which columns are chosen.
 * @param {Import} from
 */
export function importForm({ file, columns, choice, skip, problem }) {
  /** @param {string} purpose */
  const list = (purpose) =>
    element(
      "label",
      {},
      t(`edit.purpose.${purpose}`),
      " ",
      element(
        "select",
        { id: `import-${purpose}`, "data-purpose": purpose },
        purpose === "x" ? null : element("option", { value: "", selected: !choice[purpose] }, t("edit.none")),
        columns.map((name, k) => element("option", { value: `${k + 1}`, selected: choice[purpose] === `${k + 1}` }, `${k + 1}: ${name}`)),
      ),
    );
  return element(
    "fieldset",
    { id: "import", class: "controls" },
    element("legend", {}, t("edit.which-columns", { file })),
    PURPOSES.map(list),
    element("label", {}, element("input", { type: "checkbox", id: "import-skip", checked: skip }), t("edit.skip-missing")),
    element(
      "span",
      { class: "buttons" },
      element("button", { type: "button", id: "import-apply" }, t("edit.take")),
      element("button", { type: "button", id: "import-cancel" }, t("edit.cancel")),
    ),
    problem === null ? null : element("p", { id: "import-problem", class: "problem", role: "alert" }, problem),
  );
}
