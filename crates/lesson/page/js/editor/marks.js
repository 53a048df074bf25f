// @ts-check
// Which decimal mark the cells of a sheet have, and the error bound and the conditions that are typed beside them.

import { hasDecimalComma } from "../texts.js";
import { cellText, withMark } from "../model/table.js";

const SIGN = "[-+\\u2212]?";
const NUMBER = new RegExp(`^${SIGN}(\\d+[.,]?\\d*|[.,]\\d+)(e${SIGN}\\d+)?$`, "i");
// What may be a number in the thousands.
const THOUSANDS = new RegExp(`^${SIGN}[1-9]\\d{0,2}[.,]\\d{3}$`);

/**
 * The mark in a cell: "." or ","; nothing in a whole number and in what is no decimal.
 * @param {string} cell
 */
function markIn(cell) {
  const text = cell.trim();
  return NUMBER.test(text) ? (/[.,]/.exec(text)?.[0] ?? "") : "";
}

/** @param {Sheet} sheet */
const cellsIn = ({ rows }) => rows.flatMap(({ cells }) => cells);

/** @param {Sheet} sheet */
const hasPlainComma = (sheet) => cellsIn(sheet).some((cell) => markIn(cell) === "," && !THOUSANDS.test(cell.trim()));

/**
 * The mark that the cells have: where nobody has said it, the one that all decimals have.
 * @param {Sheet} sheet
 * @returns {DecimalMark}
 */
export function markOf(sheet) {
  if (sheet.request.decimal === "comma") return "comma";
  return hasPlainComma(sheet) && !cellsIn(sheet).some((cell) => markIn(cell) === ".") ? "comma" : "point";
}

/**
 * A cell with the mark of its sheet. In a sheet without other decimals of its mark, 1,234 may mean thousands: it is left as it is, for
 * the engine to refuse.
 * @param {string} cell
 * @param {DecimalMark} mark
 * @param {Sheet} sheet
 */
export function withDecimalMark(cell, mark, sheet) {
  const other = mark === "comma" ? "." : ",";
  if (markIn(cell) !== other) return cell;
  const text = cell.trim();
  const isOpen = THOUSANDS.test(text) && !(mark === "point" && hasPlainComma(sheet));
  return isOpen ? cell : text.replace(other, mark === "comma" ? "," : ".");
}

/**
 * The sheet, and the text of a cell, once it is typed or pasted where the page shows decimal commas: 1,234 is no thousands there, and
 * 1.234 is asked back unless the cells have decimal points.
 * @param {Sheet} sheet
 * @param {string} text
 * @param {string[]} [beside] the cells that are pasted with it
 * @returns {{ sheet: Sheet, text: string }}
 */
export function typedIn(sheet, text, beside = []) {
  const mark = markIn(text);
  if (mark === "" || !hasDecimalComma()) return { sheet, text };
  const withComma = { ...sheet, request: { ...sheet.request, decimal: /** @type {DecimalMark} */ ("comma") } };
  const hasPoint = cellsIn(sheet).some((cell) => markIn(cell) === ".");
  const isOpen = THOUSANDS.test(text.trim());
  if (mark === ".") {
    const isPoint = hasPoint || beside.some((cell) => markIn(cell) === "." && !THOUSANDS.test(cell));
    return { sheet: isOpen && !isPoint ? withComma : sheet, text };
  }
  if (!hasPoint) return { sheet: withComma, text };
  return { sheet, text: markOf(sheet) === "point" && isOpen ? text.replace(",", ".") : text };
}

/**
 * A number as a cell of the sheet, with no fewer decimals than the cell before: they say how exact a reading is.
 * @param {Sheet} sheet
 * @param {Rational} value
 * @param {string} [before]
 */
export function cellIn(sheet, value, before = "") {
  const text = cellText(value);
  /** @param {string} number */
  const decimals = (number) => /^[^.,e/]*[.,](\d*)$/i.exec(number.trim())?.[1].length ?? 0;
  const more = decimals(before) - decimals(text);
  const isDecimal = !/[e/]/.test(text);
  const padded = isDecimal && more > 0 ? `${text}${text.includes(".") ? "" : "."}${"0".repeat(more)}` : text;
  return withMark(padded, markOf(sheet));
}

/**
 * Whether error bounds and conditions have decimal commas: in languages that do, and beside cells that do.
 * @param {Sheet} sheet
 */
export const showsComma = (sheet) => hasDecimalComma() || markOf(sheet) === "comma";

/**
 * A formula that is typed, such as `theta1 <= 5,5`, as the engine reads it: 1,5 is a number, 1,2,3 is none. Where decimals have
 * commas, each mark stands for the other one, but 0.5 is a number, too. In a sheet without decimal points 1.234 may mean thousands:
 * the engine reads it as 1,234 and refuses it.
 * @param {string} text
 * @param {Sheet} sheet
 */
export function typedFormula(text, sheet) {
  if (!showsComma(sheet)) return text;
  const hasPoint = cellsIn(sheet).some((cell) => markIn(cell) === ".");
  /** @param {string} number */
  const isPlain = (number) => !number.includes(",") && markIn(number) === "." && (hasPoint || !THOUSANDS.test(number));
  return text.replace(/[\d.,]+/g, (number) => (isPlain(number) ? number : swapped(number)));
}

/**
 * A text with points for commas and commas for points.
 * @param {string} text
 */
export const swapped = (text) => text.replace(/[.,]/g, (mark) => (mark === "," ? "." : ","));
