// @ts-check
// A reading at another place, as cells.

import { cellIn } from "./marks.js";
import { rolesOf } from "./sheet.js";
import { boundAt, readingOfRow } from "../model/lesson.js";
import { HALF, ONE, Rational, ZERO } from "../model/rational.js";

/**
 * The cells of a reading without numbers yet, but for a bound like that of the one before.
 * @param {Sheet} sheet
 */
export function newCells(sheet) {
  const last = sheet.rows[sheet.rows.length - 1];
  return rolesOf(sheet).map((role, k) => (role === "eps_column" ? (last?.cells[k] ?? "") : ""));
}

/**
 * The sheet with a row moved: bounds of its own go with y.
 * @param {Sheet} sheet
 * @param {number} at
 * @param {Rational | null} x null where it stays
 * @param {Rational} y
 * @param {Lesson} lesson
 * @param {number | null} number which reading of the lesson it is; null for one that is not there yet
 * @returns {Sheet}
 */
export function movedSheet(sheet, at, x, y, lesson, number) {
  const reading = number !== null && lesson.rowIndex.has(number) ? readingOfRow(lesson, number) : null;
  const origin = Rational.parse(lesson.data.asked.x_origin ?? "0");
  /** @param {"lower" | "upper"} end */
  const bound = (end) => {
    const known = reading === null ? null : boundAt(reading, end, ONE);
    if (reading !== null) return known === null ? null : known.plus(y.minus(reading.y));
    const half = halfWidth(lesson);
    return end === "lower" ? y.minus(half) : y.plus(half);
  };
  const cells = rolesOf(sheet).map((role, k) => {
    const cell = sheet.rows[at].cells[k];
    if (role === "x") return x === null ? cell : cellIn(sheet, x.plus(origin), cell);
    if (role === "y") return cellIn(sheet, y, cell);
    if (role === "eps_column") return cell;
    const end = bound(role);
    return end === null ? "" : cellIn(sheet, end, cell);
  });
  return { ...sheet, rows: sheet.rows.map((own, k) => (k === at ? { ...own, cells } : own)) };
}

/**
 * Half the distance between the bounds of the last reading that has both.
 * @param {Lesson} lesson
 */
function halfWidth(lesson) {
  for (const reading of [...lesson.readings].reverse()) {
    const [lower, upper] = [boundAt(reading, "lower", ONE), boundAt(reading, "upper", ONE)];
    if (lower !== null && upper !== null) return upper.minus(lower).times(HALF);
  }
  return ZERO;
}
