// @ts-check
// The readings of a page as a table, from which the engine makes the page again.

import { Rational, powerOfTen } from "./rational.js";

/** More zeros than this are written as an exponent. */
const MOST_ZEROS = 15;

/**
 * An exact number as a decimal where it has one, "-0.25" or "65e-5002"; else the fraction.
 * @param {Rational} value
 */
export function cellText(value) {
  let [rest, twos, fives] = [value.denominator, 0, 0];
  for (; rest % 2n === 0n; rest /= 2n) twos += 1;
  for (; rest % 5n === 0n; rest /= 5n) fives += 1;
  if (rest !== 1n) return `${value}`;
  const places = Math.max(twos, fives);
  const size = (value.absolute().numerator * powerOfTen(places)) / value.denominator;
  const sign = value.sign() < 0 ? "-" : "";
  const digits = `${size}`;
  const zeros = digits.length - digits.replace(/0+$/, "").length;
  if (places === 0) return zeros > MOST_ZEROS ? `${sign}${digits.slice(0, -zeros)}e${zeros}` : sign + digits;
  if (places > digits.length + MOST_ZEROS) return `${sign}${digits}e-${places}`;
  const padded = digits.padStart(places + 1, "0");
  return `${sign}${padded.slice(0, -places)}.${padded.slice(-places)}`;
}

/** @param {string} text */
const quoted = (text) => `\x22${text.replaceAll("\x22", "\x22\x22")}\x22`;

/**
 * First and last of the numbers that follow each other without a gap.
 * @param {number[]} rows ascending
 */
export function rowRanges(rows) {
  /** @type {[number, number][]} */
  const ranges = [];
  for (const row of rows) {
    const last = ranges.at(-1);
    if (last !== undefined && last[1] + 1 === row) last[1] = row;
    else ranges.push([row, row]);
  }
  return ranges;
}

/**
 * The cells of a reading, in the order of the columns: as they were written where that is known, else made of its numbers, with x as it
 * was before it was counted from an origin. Of a reading that is not fitted the bounds do not matter.
 * @param {AskedData} asked
 * @param {FittedReadingData} reading
 * @returns {string[]}
 */
export function cellsOf(asked, { cells: written, phi, y, epsilon, middle, lower, upper }) {
  /** @param {{ exact: string } | undefined} number */
  const parsed = (number) => (number === undefined ? null : Rational.parse(number.exact));
  const origin = Rational.parse(asked.x_origin ?? "0");
  const regressors = phi.map(({ exact }) => Rational.parse(exact));
  const level = Rational.parse(y.exact);
  /** @type {(Rational | null)[]} */
  const cells = typeof asked.x === "string" ? [regressors[0].plus(origin)] : regressors;
  if (asked.y !== undefined) cells.push(level);
  const isFitted = [epsilon, lower, upper].some((bound) => bound !== undefined);
  const width = parsed(epsilon) ?? Rational.parse("0");
  const center = parsed(middle) ?? level;
  if (asked.eps_column !== undefined) cells.push(width);
  const grows = !isFitted || epsilon !== undefined;
  if (asked.lower !== undefined) cells.push(grows ? center.minus(width) : parsed(lower));
  if (asked.upper !== undefined) cells.push(grows ? center.plus(width) : parsed(upper));
  return cells.map((cell, k) => written?.[k] ?? (cell === null ? "" : withMark(cellText(cell), asked.decimal)));
}

/**
 * A decimal with a point as one with this mark.
 * @param {string} text
 * @param {DecimalMark} mark
 */
export const withMark = (text, mark) => (mark === "comma" ? text.replace(".", ",") : text);

/**
 * A table with a header: semicolons separate its columns where its numbers have decimal commas.
 * @param {string[]} columns
 * @param {string[][]} rows the cells
 * @param {DecimalMark} mark
 */
export function tableText(columns, rows, mark) {
  const delimiter = mark === "comma" ? ";" : ",";
  /** @param {string} cell */
  const isPlain = (cell) => !cell.includes(delimiter) && !/[\x22\r\n]/.test(cell);
  // In names a reader may take either mark for what separates columns.
  const head = columns.map((name) => (isPlain(name) && !/[,;]/.test(name) ? name : quoted(name)));
  const lines = [head, ...rows.map((cells) => cells.map((cell) => (isPlain(cell) ? cell : quoted(cell))))];
  return lines.map((cells) => `${cells.join(delimiter)}\n`).join("");
}

/**
 * The readings of a page, fitted or not, as the table that `asked` is about.
 * @param {Pick<LessonData, "asked" | "columns" | "readings" | "others">} data
 */
export function tableOf({ asked, columns, readings, others }) {
  /** @type {FittedReadingData[]} */
  const all = [...readings, ...others].sort((one, other) => one.row - other.row);
  return tableText(columns, all.map((reading) => cellsOf(asked, reading)), asked.decimal);
}
