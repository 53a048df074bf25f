// @ts-check
// The readings as text that can be changed, and the request about them. A sheet is never changed: every edit is another one, and the
// engine makes a lesson of each.

import { markOf, withDecimalMark } from "./marks.js";
import { cellsOf, rowRanges, tableText } from "../model/table.js";

/** The keys of the request that name columns, in the order of the columns. */
const COLUMN_KEYS = /** @type {const} */ (["x", "y", "eps_column", "lower", "upper"]);
const BOUND_COLUMNS = /** @type {const} */ (["eps_column", "lower", "upper"]);
/** The keys that readers give in texts of their own. */
const TEXT_KEYS = ["eps", "where", "through_origin", "x_origin", "reading", "limits"];
/** What the page says besides, by the keys of docs/wasm.md. */
const PAGE_KEYS = ["file", "title", "x_unit", "y_unit", "max_readings"];
/** What a request means that does not say it. */
const DEFAULTS = new Map(Object.entries({ reading: "decimal", through_origin: false, decimal: "point" }));

/**
 * Those of some keys that say something.
 * @param {Record<string, any>} all
 * @param {readonly string[]} keys
 */
const picked = (all, keys) => Object.fromEntries(keys.flatMap((key) => ([undefined, null, DEFAULTS.get(key)].includes(all[key]) ? [] : [[key, all[key]]])));

/**
 * The sheet from which the engine makes this lesson again.
 * @param {LessonData} data
 * @param {Record<string, any>} said the request that it was made of, whose texts are kept as they are
 * @returns {Sheet}
 */
export function sheetOf(data, said = {}) {
  const { asked } = data;
  const own = COLUMN_KEYS.filter((key) => asked[key] !== undefined);
  const columns = distinct(data.columns);
  const names = columns.map(byName);
  const x = names.splice(0, typeof asked.x === "string" ? 1 : 2);
  const isBound = [...x.map(() => false), ...own.slice(1).map((key) => key !== "y")];
  /** @param {FittedReadingData} reading @param {boolean} isFitted */
  const row = (reading, isFitted) => {
    // The bounds of a reading that is not fitted are in the document only if their cells are.
    const cells = cellsOf(asked, reading).map((cell, k) => (isFitted || !isBound[k] ? cell : (reading.cells?.[k] ?? "")));
    return { number: reading.row, cells, isFitted };
  };
  const rows = [...data.readings.map((own) => row(own, true)), ...data.others.map((own) => row(own, false))];
  /** @type {FitRequest} */
  const request = { ask: "fit", x: /** @type {FitRequest["x"]} */ (x.length === 1 ? x[0] : x) };
  own.slice(1).forEach((key, k) => Object.assign(request, { [key]: names[k] }));
  // That the cells have decimal commas is kept: so 1,234 is no thousands.
  Object.assign(request, picked({ ...asked, ...picked(said, TEXT_KEYS) }, [...TEXT_KEYS, "decimal"]));
  return {
    columns,
    rows: rows.sort((p, q) => p.number - q.number).map(({ cells, isFitted }) => ({ cells, isFitted })),
    request: asked.eps === undefined ? withoutKeys(request, ["eps"]) : request,
    page: picked(asked, PAGE_KEYS),
  };
}

/**
 * What the page says besides, of the words of a link.
 * @param {Record<string, string>} words
 */
export function pageOf(words) {
  const { max_readings: most, ...texts } = picked(words, PAGE_KEYS);
  return most === undefined ? texts : { ...texts, max_readings: Number(most) };
}

/**
 * @param {FitRequest} request
 * @param {readonly string[]} keys
 */
const withoutKeys = (request, keys) => /** @type {FitRequest} */ (Object.fromEntries(Object.entries(request).filter(([key]) => !keys.includes(key))));

/**
 * The key of the request that names each column.
 * @param {Sheet} sheet
 */
export function rolesOf({ columns, request }) {
  const roles = new Map(COLUMN_KEYS.flatMap((key) => [request[key] ?? []].flat().map((name) => [name, key])));
  return columns.map((name) => roles.get(byName(name)) ?? "x");
}

/**
 * Columns are told apart by their names.
 * @param {string[]} columns
 */
function distinct(columns) {
  /** @type {Set<string>} */
  const taken = new Set();
  return columns.map((name, k) => {
    let free = name.trim() === "" ? `column ${k + 1}` : name.trim();
    while (taken.has(free)) free += "'";
    taken.add(free);
    return free;
  });
}

/**
 * The rows that are readings, by index; the k-th of them is reading k + 1. A row in which numbers are still missing is none yet.
 * @param {Sheet} sheet
 */
export function usedRows(sheet) {
  const roles = rolesOf(sheet);
  return sheet.rows.flatMap(({ cells, isFitted }, k) => {
    const isThere = cells.map((cell) => cell.trim() !== "");
    /** @param {string} role */
    const filled = (role) => roles.flatMap((own, at) => (own === role ? [isThere[at]] : []));
    const ends = [...filled("lower"), ...filled("upper")];
    const hasBound = !isFitted || (filled("eps_column").every(Boolean) && (ends.length === 0 || ends.some(Boolean)));
    return hasBound && filled("x").every(Boolean) && filled("y").every(Boolean) ? [k] : [];
  });
}

/**
 * The readings as delimited text.
 * @param {Sheet} sheet
 */
export function csvOf(sheet) {
  const mark = markOf(sheet);
  const rows = usedRows(sheet).map((k) => sheet.rows[k].cells.map((cell) => withDecimalMark(cell, mark, sheet)));
  return tableText(sheet.columns, rows, mark);
}

/**
 * How a column is asked for by its name: in quotes where the name is digits, which may be the number of another column.
 * @param {string} name
 */
export const byName = (name) => (/^\d+$/.test(name) ? `"${name}"` : name);

/**
 * The request about the text of {@link csvOf}, the same for the engine, a report and a link: which rows are left out and how the text
 * is written follows from the cells.
 * @param {Sheet} sheet
 * @returns {FitRequest}
 */
export function requestOf(sheet) {
  const without = usedRows(sheet).flatMap((at, k) => (sheet.rows[at].isFitted ? [] : [k + 1]));
  const left = without.length > 0 ? { without: rowRanges(without) } : {};
  const text = markOf(sheet) === "comma" ? { delimiter: "semicolon", decimal: "comma" } : { delimiter: "comma", decimal: "point" };
  return { ...sheet.request, ...left, header: "yes", ...text, comment: "none" };
}

/**
 * A number or formula of a request as its text.
 * @param {Given | undefined} given
 */
export const textOf = (given) => (typeof given === "object" ? given.exact : `${given ?? ""}`);

/**
 * What to type to have the same answer from the program, for the file of {@link csvOf}; null where its options cannot say it.
 * @param {Sheet} sheet
 * @param {string} file
 */
export function commandOf(sheet, file) {
  const options = requestOf(sheet);
  // The program reads a number of an option as it reads those of the table.
  const isExact = [options.eps, options.x_origin, ...(options.where ?? [])].some((given) => typeof given === "object");
  if (isExact && options.reading === "binary64") return null;
  const words = ["boundfit", "fit", file];
  /** @param {string} word */
  const quoted = (word) => (/^[\w./:=@%+,-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
  // What the command line would take for two columns, or for another option, is a column by its number.
  const column = (/** @type {string | undefined} */ name) =>
    name !== undefined && /^-|,/.test(name) ? `${sheet.columns.indexOf(name) + 1}` : name;
  if (options.decimal === "comma") words.push("--delimiter", "semicolon", "--decimal", "comma");
  const regressors = [options.x].flat().map((name) => column(name)).join(",");
  const [y, eps_column, lower, upper] = [options.y, options.eps_column, options.lower, options.upper].map(column);
  const names = { x: regressors, y, eps: options.eps === undefined ? undefined : textOf(options.eps), "eps-column": eps_column, lower, upper };
  for (const [name, value] of Object.entries(names)) if (value !== undefined) words.push(`--${name}`, quoted(value));
  // Where every column is asked for by what may be its number, the first row may be taken for a reading.
  if (sheet.columns.every((name) => /^\d+$/.test(column(name) ?? ""))) words.push("--header", "yes");
  for (const condition of options.where ?? []) words.push("--where", quoted(textOf(condition)));
  if (options.without) words.push("--without", options.without.map((own) => own.join("..")).join(","));
  if (options.through_origin) words.push("--through-origin");
  if (options.x_origin !== undefined) words.push(`--x-origin=${quoted(textOf(options.x_origin))}`);
  if (options.reading !== undefined && options.reading !== "decimal") words.push("--reading", options.reading);
  for (const [name, most] of Object.entries(options.limits ?? {})) words.push("--limit", `${name}=${most}`);
  return words.join(" ");
}

/**
 * @param {Sheet} sheet
 * @param {number} row
 * @param {number} column
 * @param {string} text
 * @returns {Sheet}
 */
export function withCell(sheet, row, column, text) {
  return withBlock(sheet, row, column, [[text]]);
}

/**
 * The sheet with a block of cells from a place on; rows are added where it goes beyond the last one, what goes beyond the last column
 * is left out.
 * @param {Sheet} sheet
 * @param {number} row
 * @param {number} column
 * @param {string[][]} block
 * @returns {Sheet}
 */
export function withBlock(sheet, row, column, block) {
  const rows = [...sheet.rows];
  block.forEach((line, k) => {
    const own = rows[row + k] ?? { cells: sheet.columns.map(() => ""), isFitted: true };
    rows[row + k] = { ...own, cells: own.cells.map((cell, at) => line[at - column] ?? cell) };
  });
  return { ...sheet, rows };
}

/**
 * @param {Sheet} sheet
 * @param {number} row
 * @returns {Sheet}
 */
export function withoutRowAt(sheet, row) {
  return { ...sheet, rows: sheet.rows.filter((_, k) => k !== row) };
}

/**
 * @param {Sheet} sheet
 * @param {number} row
 * @param {boolean} isFitted
 * @returns {Sheet}
 */
export function withFitted(sheet, row, isFitted) {
  return { ...sheet, rows: sheet.rows.map((own, k) => (k === row ? { ...own, isFitted } : own)) };
}

/**
 * The sheet with another request; undefined takes a key away.
 * @param {Sheet} sheet
 * @param {Partial<FitRequest>} changes
 * @returns {Sheet}
 */
export function withRequest(sheet, changes) {
  const request = /** @type {FitRequest} */ ({ ...sheet.request, ...changes });
  return { ...sheet, request: withoutKeys(request, Object.keys(changes).filter((key) => changes[/** @type {keyof FitRequest} */ (key)] === undefined)) };
}

/**
 * Where something is wrong by what the engine refused: a cell, or a part of the question.
 * @param {Refusal} refusal
 * @param {Sheet} sheet
 * @returns {Problem}
 */
export function problemOf(refusal, sheet) {
  const { line, column, key } = refusal;
  const row = line === undefined ? undefined : usedRows(sheet)[line - 2];
  if (row !== undefined) return { row, column: column === undefined ? null : column - 1, key: null, refusal };
  return { row: null, column: null, key: ["eps", "where"].includes(key ?? "") ? (key ?? null) : null, refusal };
}

/**
 * The sheet with bounds of another kind on the errors, those of the readings as they are.
 * @param {Sheet} sheet
 * @param {"eps" | "column" | "interval"} kind
 * @param {Map<number, { width: string, lower: string, upper: string }>} known the bounds that readings have, by number
 * @returns {Sheet}
 */
export function withBounds(sheet, kind, known) {
  const numbers = new Map(usedRows(sheet).map((at, k) => [at, k + 1]));
  const roles = rolesOf(sheet);
  const kept = roles.flatMap((role, k) => (role === "x" || role === "y" ? [k] : []));
  /** @type {(typeof BOUND_COLUMNS)[number][]} */
  const added = kind === "eps" ? [] : kind === "column" ? ["eps_column"] : ["lower", "upper"];
  const rows = sheet.rows.map(({ cells, isFitted }, at) => {
    const own = known.get(numbers.get(at) ?? 0) ?? { width: "", lower: "", upper: "" };
    const bounds = kind === "eps" ? [] : kind === "column" ? [own.width] : [own.lower, own.upper];
    return { cells: [...kept.map((k) => cells[k]), ...bounds], isFitted };
  });
  const columns = distinct([...kept.map((k) => sheet.columns[k]), ...added.map((key) => (key === "eps_column" ? "eps" : key))]);
  const named = Object.fromEntries(added.map((key, k) => [key, byName(columns[kept.length + k])]));
  // A multiple of the least bound is right for any readings.
  const text = kind === "eps" ? textOf(sheet.request.eps ?? [...known.values()][0]?.width).replace(",", ".") || "2*min" : undefined;
  const without = withoutKeys(sheet.request, BOUND_COLUMNS);
  return withRequest({ ...sheet, columns, rows, request: without }, { eps: text, ...named });
}

/**
 * Whether two sheets say the same.
 * @param {Sheet} one
 * @param {Sheet} other
 */
export function isSameSheet(one, other) {
  /** @param {Sheet} sheet */
  const words = ({ columns, rows, request, page }) => JSON.stringify([columns, rows, Object.entries(request).sort(), Object.entries(page).sort()]);
  return one === other || words(one) === words(other);
}
