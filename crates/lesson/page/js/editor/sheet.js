// @ts-check
// The readings as text that can be changed, and what is asked of them. A sheet is never changed: every edit is another one, and the
// engine makes a lesson of each.

import { markOf, withDecimalMark } from "./marks.js";
import { cellsOf, rowRanges, tableText } from "../model/table.js";

/** Keys of the question that name columns or rows: the sheet has these in another form. */
const ABOUT_COLUMNS = ["x", "y", "eps_column", "lower", "upper", "rows", "row_numbers", "without", "where_row"];
/** What describes a file that the sheet is no longer, or a report. */
const ABOUT_FILES = ["header", "delimiter", "thousands", "comment", "skip_lines", "units_row", "missing", "format", "digits", "rounding", "exact", "no_eui"];

/**
 * The sheet from which the engine makes this lesson again.
 * @param {LessonData} data
 * @returns {Sheet}
 */
export function sheetOf(data) {
  const { asked, columns } = data;
  const regressors = typeof asked.x === "string" ? 1 : 2;
  /** @type {SheetColumn["role"][]} */
  const roles = Array(regressors).fill("x");
  if (asked.y !== undefined) roles.push("y");
  if (asked.eps_column !== undefined) roles.push("eps");
  if (asked.lower !== undefined) roles.push("lower");
  if (asked.upper !== undefined) roles.push("upper");
  const bounds = roles.map((role) => !["x", "y"].includes(role));
  /** @param {FittedReadingData} reading @param {boolean} isFitted */
  const row = (reading, isFitted) => {
    // The bounds of a reading that is not fitted are in the document only if their cells are.
    const cells = cellsOf(asked, reading).map((cell, k) => (isFitted || !bounds[k] ? cell : (reading.cells?.[k] ?? "")));
    return { number: reading.row, cells, isFitted };
  };
  const rows = [...data.readings.map((own) => row(own, true)), ...data.others.map((own) => row(own, false))];
  return {
    columns: distinct(roles.map((role, k) => ({ name: columns[k], role }))),
    rows: rows.sort((p, q) => p.number - q.number).map(({ cells, isFitted }) => ({ cells, isFitted })),
    question: questionOf(asked),
  };
}

/**
 * What of a question is not about columns, rows or the form of a file. That the cells have decimal commas is kept: so 1,234 is no
 * thousands.
 * @param {Record<string, any>} asked
 */
export function questionOf(asked) {
  const isKept = (/** @type {string} */ key) => (key === "decimal" ? asked.decimal === "comma" : ![...ABOUT_COLUMNS, ...ABOUT_FILES].includes(key));
  return Object.fromEntries(Object.entries(asked).filter(([key]) => isKept(key)));
}

/**
 * Columns are told apart by their names.
 * @param {SheetColumn[]} columns
 */
export function distinct(columns) {
  /** @type {Set<string>} */
  const taken = new Set();
  return columns.map(({ name, role }, k) => {
    let free = name.trim() === "" ? `column ${k + 1}` : name.trim();
    while (taken.has(free)) free += "'";
    taken.add(free);
    return { name: free, role };
  });
}

/**
 * The rows that are readings, by index; the k-th of them is reading k + 1. A row in which numbers are still missing is none yet.
 * @param {Sheet} sheet
 */
export function usedRows({ columns, rows }) {
  return rows.flatMap(({ cells, isFitted }, k) => {
    const isThere = cells.map((cell) => cell.trim() !== "");
    /** @param {string} role */
    const filled = (role) => columns.flatMap((column, at) => (column.role === role ? [isThere[at]] : []));
    const ends = [...filled("lower"), ...filled("upper")];
    const hasBound = !isFitted || (filled("eps").every(Boolean) && (ends.length === 0 || ends.some(Boolean)));
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
  return tableText(sheet.columns.map(({ name }) => name), rows, mark);
}

/**
 * How a column is asked for by its name: in quotes where the name is digits, which may be the number of another column.
 * @param {string} name
 */
export const byName = (name) => (/^\d+$/.test(name) ? `"${name}"` : name);

/**
 * What is asked of the text, as docs/wasm.md has it.
 * @param {Sheet} sheet
 * @returns {Record<string, any>}
 */
export function optionsOf(sheet) {
  const { columns, rows, question: asked } = sheet;
  const named = (/** @type {SheetColumn["role"]} */ role) => columns.filter((column) => column.role === role).map(({ name }) => byName(name));
  const x = named("x");
  const without = usedRows(sheet).flatMap((at, k) => (rows[at].isFitted ? [] : [k + 1]));
  const text = markOf(sheet) === "comma" ? { delimiter: "semicolon", decimal: "comma" } : { delimiter: "comma", decimal: "point" };
  /** @type {Record<string, any>} */
  const options = { ...asked, x: x.length === 1 ? x[0] : x, header: "yes", ...text, comment: "none" };
  const [y, eps, lower, upper] = [named("y"), named("eps"), named("lower"), named("upper")].map(([name]) => name);
  Object.assign(options, y === undefined ? {} : { y }, lower === undefined ? {} : { lower }, upper === undefined ? {} : { upper });
  if (eps !== undefined) options.eps_column = eps;
  // Errors have bounds of one kind.
  if (eps !== undefined || lower !== undefined || upper !== undefined) delete options.eps;
  if (without.length > 0) options.without = rowRanges(without);
  return options;
}

/**
 * What to type to have the same answer from the program, for the file of {@link csvOf}.
 * @param {Sheet} sheet
 * @param {string} file
 */
export function commandOf(sheet, file) {
  const options = optionsOf(sheet);
  const words = ["boundfit", "fit", file];
  /** @param {string} word */
  const quoted = (word) => (/^[\w./:=@%+,-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
  // What the command line would take for two columns, or for another option, is a column by its number.
  const column = (/** @type {string | undefined} */ name) =>
    name !== undefined && /^-|,/.test(name) ? `${sheet.columns.findIndex((own) => own.name === name) + 1}` : name;
  if (options.decimal === "comma") words.push("--delimiter", options.delimiter, "--decimal", options.decimal);
  const regressors = [options.x].flat().map(column).join(",");
  const [y, eps_column, lower, upper] = [options.y, options.eps_column, options.lower, options.upper].map(column);
  const names = { x: regressors, y, eps: options.eps, "eps-column": eps_column, lower, upper };
  for (const [name, value] of Object.entries(names)) if (value !== undefined) words.push(`--${name}`, quoted(value));
  // Where every column is asked for by what may be its number, the first row may be taken for a reading.
  if (sheet.columns.every(({ name }) => /^\d+$/.test(column(name) ?? ""))) words.push("--header", "yes");
  for (const condition of options.where ?? []) words.push("--where", quoted(condition));
  if (options.without) words.push("--without", options.without.map((/** @type {number[]} */ own) => own.join("..")).join(","));
  if (options.through_origin) words.push("--through-origin");
  if (options.x_origin !== undefined) words.push(`--x-origin=${quoted(options.x_origin)}`);
  if (options.reading !== undefined && options.reading !== "decimal") words.push("--reading", options.reading);
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
 * The sheet with another answer to a part of the question; undefined takes it away.
 * @param {Sheet} sheet
 * @param {Record<string, any>} changes
 * @returns {Sheet}
 */
export function withQuestion(sheet, changes) {
  const asked = Object.entries({ ...sheet.question, ...changes }).filter(([, value]) => value !== undefined);
  return { ...sheet, question: Object.fromEntries(asked) };
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
  const kept = sheet.columns.flatMap(({ role }, k) => (role === "x" || role === "y" ? [k] : []));
  /** @type {SheetColumn[]} */
  const added = kind === "eps" ? [] : kind === "column" ? [{ name: "eps", role: "eps" }] : [{ name: "lower", role: "lower" }, { name: "upper", role: "upper" }];
  const rows = sheet.rows.map(({ cells, isFitted }, at) => {
    const own = known.get(numbers.get(at) ?? 0) ?? { width: "", lower: "", upper: "" };
    const bounds = kind === "eps" ? [] : kind === "column" ? [own.width] : [own.lower, own.upper];
    return { cells: [...kept.map((k) => cells[k]), ...bounds], isFitted };
  });
  const columns = distinct([...kept.map((k) => sheet.columns[k]), ...added]);
  // A multiple of the least bound is right for any readings.
  const eps = kind === "eps" ? (sheet.question.eps ?? [...known.values()][0]?.width ?? "2*min") : undefined;
  return withQuestion({ ...sheet, columns, rows }, { eps: eps === "" ? "2*min" : eps?.replace(",", ".") });
}

/**
 * Whether two sheets say the same.
 * @param {Sheet} one
 * @param {Sheet} other
 */
export function isSameSheet(one, other) {
  /** @param {Sheet} sheet */
  const words = ({ columns, rows, question }) => JSON.stringify([columns, rows, Object.entries(question).sort()]);
  return one === other || words(one) === words(other);
}
