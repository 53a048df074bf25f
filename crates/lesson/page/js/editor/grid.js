// @ts-check
// The table of readings as cells to type into.

import { element } from "../dom.js";
import { t } from "../texts.js";
import { sentenceOf } from "./refusals.js";
import { rolesOf, usedRows } from "./sheet.js";

/** @typedef {Workbench["typing"]} Typing */

const LONGEST_HEAD = 14;

/**
 * The names of the columns as heads: what they are for where the name does not say it.
 * @param {string} name
 * @param {Role} role
 */
function head(name, role) {
  return role === "x" || role === "y" ? name : `${name} (${t(`edit.role.${role}`)})`;
}

/**
 * @param {Sheet} sheet
 * @param {Problem | null} problem
 * @param {Typing} typing
 * @param {number | null} chosen the number of the reading that is chosen in the pictures
 */
export function grid(sheet, problem, typing, chosen) {
  const numbers = new Map(usedRows(sheet).map((at, k) => [at, k + 1]));
  const roles = rolesOf(sheet);
  const heads = [t("edit.row"), ...sheet.columns.map((name, k) => head(name, roles[k])), t("edit.fitted")].map((name) =>
    element("th", { scope: "col", class: name.length > LONGEST_HEAD ? "long" : null }, name),
  );
  heads.push(element("th", { scope: "col" }, element("span", { class: "unseen" }, t("edit.delete"))));
  return element(
    "table",
    { id: "sheet", class: "sheet" },
    element("thead", {}, element("tr", {}, heads)),
    element("tbody", {}, sheet.rows.map((_, at) => rowOf(sheet, at, numbers.get(at) ?? null, problem?.row === at ? problem : null, typing, chosen))),
  );
}

/**
 * @param {Sheet} sheet
 * @param {number} at
 * @param {number | null} number null for a row that is no reading yet
 * @param {Problem | null} problem
 * @param {Typing} typing
 * @param {number | null} chosen
 */
function rowOf({ columns, rows }, at, number, problem, typing, chosen) {
  const { cells, isFitted } = rows[at];
  const shown = number === null ? "–" : `${number}`;
  const classes = [number === null && "unfinished", !isFitted && "unfitted", chosen !== null && chosen === number && "chosen"];
  return element(
    "tr",
    { class: classes.filter(Boolean).join(" ") || null, "data-sheet-row": at },
    element("th", { scope: "row" }, shown),
    columns.map((column, k) => cellOf(column, cells[k], { at, k, row: shown, problem: problem?.column === k ? problem : null, typing })),
    element("td", {}, element("input", { type: "checkbox", "data-fitted": at, checked: isFitted, "aria-label": t("edit.fit-row", { row: shown }) })),
    element(
      "td",
      {},
      element("button", { type: "button", class: "plain", "data-delete": at, "aria-label": t("edit.delete-row", { row: shown }) }, "×"),
      problem !== null && problem.column === null ? problemNote(problem) : null,
    ),
  );
}

/**
 * @param {string} name
 * @param {string} text
 * @param {{ at: number, k: number, row: string, problem: Problem | null, typing: Typing }} where
 */
function cellOf(name, text, { at, k, row, problem, typing }) {
  const place = `${at} ${k}`;
  const value = typing?.place === place ? typing.text : text;
  return element(
    "td",
    {},
    element("input", {
      type: "text",
      class: "cell",
      inputmode: "text",
      autocomplete: "off",
      spellcheck: "false",
      "data-cell": place,
      size: Math.min(24, Math.max(6, value.length)),
      value,
      "aria-label": t("edit.cell", { column: name, row }),
      "aria-invalid": problem === null ? null : "true",
      "aria-describedby": problem === null ? null : "sheet-problem",
    }),
    problem === null ? null : problemNote(problem),
  );
}

/** @param {Problem} problem */
export function problemNote({ refusal }) {
  return element("span", { id: "sheet-problem", class: "problem", role: "alert" }, sentenceOf(refusal));
}
