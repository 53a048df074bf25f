// @ts-check
// A table from elsewhere: pasted, dropped or opened. The engine reads it, in whatever form it is; where its header does not say which
// column is which, the reader does.

import { element } from "../dom.js";
import { t } from "../texts.js";
import { sentenceOfTable } from "./refusals.js";
import { byName, rolesOf, sheetOf } from "./sheet.js";
import { notesOf } from "./table-notes.js";

/** What a column can be for, in the order of the form. */
const PURPOSES = ["x", "v", "y", "eps_column", "lower", "upper"];
const BOUNDS = ["eps_column", "lower", "upper"];
// What files call the bound of a reading.
const BOUND_NAMES = { eps_column: /^(eps(ilon)?|ε|e|error|err|tolerance|tol|u)$/i, lower: /^(lower|low|min|from|earliest|at_least)$/i, upper: /^(upper|high|max|to|latest|at_most)$/i };

// What is measured has such names, in large letters.
const QUANTITIES = ["U", "E"];
/** What can be said of how a table is written, by the key of docs/wasm.md; the first of each list leaves it to the engine. */
const TABLE_ANSWERS = { header: ["auto", "yes", "no"], decimal: ["auto", "point", "comma"], thousands: ["auto", ".", ",", " ", "'"] };
const WORDS_OF_MARKS = new Map([[".", "point"], [",", "comma"], [" ", "blank"], ["'", "apostrophe"]]);

/**
 * The key of the request for the name of a file. A table that was pasted has none: a name would stay in one language.
 * @param {string | null} file
 */
const named = (file) => (file === null ? {} : { file });

/**
 * Reads the names of the columns of a table, whether it has them from a header, and which of them have numbers.
 * @param {Engine} engine
 * @param {string | Uint8Array} table
 * @param {string | null} file
 * @param {Record<string, any>} how the table is written, as far as it was said
 * @returns {Promise<{ columns: string[], header: boolean, numeric: boolean[] | null, table: TableData | null }>}
 */
export async function columnsOf(engine, table, file, how) {
  return JSON.parse(await engine.ask("columns", table, { ...named(file), ...how }));
}

/**
 * What the columns are most likely for: as in the sheet that is there, if their names are its; else by their names and order. It is
 * sure only if no column with numbers is left.
 * @param {string[]} columns
 * @param {boolean[] | null} numeric
 * @param {Sheet | null} sheet
 * @returns {{ choice: Record<string, string>, isSure: boolean }}
 */
export function guessed(columns, numeric, sheet) {
  const number = (/** @type {number} */ k) => `${k + 1}`;
  /** @type {Record<string, string>} */
  const choice = {};
  const isKnown = sheet !== null && sheet.columns.every((name) => columns.filter((own) => own.trim() === name).length === 1);
  const roles = isKnown ? rolesOf(sheet) : [];
  roles.forEach((role, k) => {
    const key = role === "x" && "x" in choice ? "v" : role;
    choice[key] = number(columns.findIndex((own) => own.trim() === sheet?.columns[k]));
  });
  const left = columns.map((_, k) => k).filter((k) => !Object.values(choice).includes(number(k)));
  const hasBounds = BOUNDS.some((key) => key in choice);
  const isNumeric = (/** @type {number} */ k) => numeric === null || numeric[k];
  for (const [key, pattern] of Object.entries(hasBounds ? {} : BOUND_NAMES)) {
    const found = left.find((k) => k > 0 && isNumeric(k) && pattern.test(columns[k].trim()) && !QUANTITIES.includes(columns[k].trim()));
    // Beside an ε there are an x and a y.
    const hasOthers = key !== "eps_column" || columns.filter((_, k) => k !== found && isNumeric(k)).length >= 2;
    if (found === undefined || !hasOthers || (key !== "eps_column" && "eps_column" in choice)) continue;
    choice[key] = number(found);
    left.splice(left.indexOf(found), 1);
  }
  const withNumbers = left.filter(isNumeric);
  // Bounds that the table has and the sheet has not are the reader's choice, unless nothing else is left.
  if (isKnown) return { choice, isSure: withNumbers.length === 0 && (hasBounds || left.length === 0 || !BOUNDS.some((key) => key in choice)) };
  const [x, y] = withNumbers.length >= 2 ? withNumbers : left;
  if (x !== undefined) choice.x = number(x);
  if (y !== undefined) choice.y = number(y);
  const isUsual = Object.keys(choice).every((key) => ["x", "y", "eps_column"].includes(key));
  return { choice, isSure: y !== undefined && isUsual && (left.length === 2 || (numeric !== null && withNumbers.length === 2)) };
}

/**
 * How the engine is asked for a column: by its name where it has one of its own, since the number of a column may be the name of another.
 * @param {Import} from
 * @param {string | undefined} number
 */
function selector({ columns, hasHeader }, number) {
  const name = number ? columns[Number(number) - 1].trim() : "";
  const isOwn = columns.filter((own) => own.trim() === name).length === 1;
  return hasHeader && isOwn && name !== `col${number}` ? byName(name) : number;
}

/**
 * The sheet of a table, made by the engine, and what the table was taken for.
 * @param {Engine} engine
 * @param {Import} from
 * @param {Sheet} sheet what is asked so far
 * @returns {Promise<{ sheet: Sheet, notes: TableData | null }>}
 */
export async function imported(engine, from, sheet) {
  const { table, file, columns, choice, how, skip } = from;
  const [x, v, y, eps_column, lower, upper] = PURPOSES.map((purpose) => selector(from, choice[purpose]));
  const { where, through_origin, x_origin, reading, eps } = sheet.request;
  // Another column has another origin.
  const isSameX = columns[Number(choice.x) - 1]?.trim() === sheet.columns[0];
  const isOwn = [eps_column, lower, upper].some(Boolean);
  const bounds = { ...(eps_column ? { eps_column } : {}), ...(lower ? { lower } : {}), ...(upper ? { upper } : {}) };
  const options = {
    ...named(file),
    ...how,
    x: v ? [x, v] : x,
    ...(y ? { y } : {}),
    ...(isOwn ? bounds : { eps: eps ?? "2*min" }),
    ...(where ? { where } : {}),
    ...(through_origin && !v ? { through_origin } : {}),
    ...(x_origin && !v && isSameX ? { x_origin } : {}),
    ...(reading ? { reading } : {}),
    ...(skip ? { missing: "skip" } : {}),
  };
  /** @type {LessonData} */
  const data = JSON.parse(await engine.ask("lesson", table, options));
  return { sheet: sheetOf(data, options), notes: data.fit.input.table };
}

/**
 * What is said of how a table is written, after one more answer; "auto" takes an answer back.
 * @param {Record<string, any>} how
 * @param {string} key
 * @param {string | boolean} answer
 */
export function withWay(how, key, answer) {
  const ways = Object.entries({ ...how, [key]: answer });
  return Object.fromEntries(ways.filter(([, value]) => value !== "auto" && value !== false));
}

/**
 * How the table is written: for what the engine cannot know, or took for something else.
 * @param {Import} from
 */
function waysOf({ how }) {
  const lists = Object.entries(TABLE_ANSWERS).map(([key, answers]) =>
    element(
      "label",
      {},
      t(`edit.way.${key}`),
      " ",
      element(
        "select",
        { id: `import-${key}`, "data-way": key },
        answers.map((own) => element("option", { value: own, selected: (how[key] ?? "auto") === own }, t(`edit.way.${key}.${WORDS_OF_MARKS.get(own) ?? own}`))),
      ),
    ),
  );
  const units = element("input", { type: "checkbox", id: "import-units", "data-way": "units_row", checked: how.units_row === true });
  return [...lists, element("label", {}, units, t("edit.way.units"))];
}

/**
 * The form in which columns are chosen.
 * @param {Import} from
 */
export function importForm(from) {
  const { file, columns, choice, notes, skip, problem } = from;
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
    element("legend", {}, file === null ? t("edit.which-columns-pasted") : t("edit.which-columns", { file })),
    PURPOSES.map(list),
    element("p", { id: "import-notes" }, element("small", {}, notes === null ? "" : notesOf(notes))),
    waysOf(from),
    element("label", {}, element("input", { type: "checkbox", id: "import-skip", checked: skip }), t("edit.skip-missing")),
    element(
      "span",
      { class: "buttons" },
      element("button", { type: "button", id: "import-apply" }, t("edit.take")),
      element("button", { type: "button", id: "import-cancel" }, t("edit.cancel")),
    ),
    problem === null ? null : element("p", { id: "import-problem", class: "problem", role: "alert" }, sentenceOfTable(problem)),
  );
}
