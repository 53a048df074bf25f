// @ts-check
// Numbers and names as text.

import { numberText, said, t } from "../texts.js";
import { HALF, Rational, ZERO, decimalPower, powerOfTen } from "./rational.js";

const LONGEST_FRACTION = 44;
const MOST_DIGITS = 40;
const MOST_PLACES = 10;
const LARGEST_PLAIN = 14;
const LEAST_PLAIN = -4;
const LONGEST_LIST = 12;
const SHORTEST_RUN = 3;
const THOUSANDTH = decimalPower(-3);

/**
 * A decimal with at most `digits` significant digits, the one that the engine writes.
 * @param {Rational} value
 * @param {"nearest"|"down"|"up"} rounding ends of intervals are rounded outward: lower ends down, upper ends up
 * @param {number} [digits]
 */
export function decimal(value, digits = 5, rounding = "nearest") {
  if (value.isZero()) return "0";
  const { significand, exponent, exact } = rounded(value, digits, rounding);
  let text = `${significand}`;
  if (exact) text = text.replace(/0+$/, "");
  return numberText((value.sign() < 0 ? "-" : "") + placePoint(text, exponent, exact));
}

/**
 * The rounded digits of a number other than 0, what the first of them weighs as a power of ten, and whether nothing was cut off.
 * @param {Rational} value
 * @param {number} digits
 * @param {"nearest"|"down"|"up"} rounding
 */
function rounded(value, digits, rounding) {
  let exponent = value.decimalExponent();
  const scaled = value.absolute().times(decimalPower(digits - 1 - exponent));
  let significand = scaled.floor();
  const rest = scaled.minus(new Rational(significand));
  const exact = rest.isZero();
  if (!exact) {
    // Ties go to the even digit, as in the engine: the same number must not be written in two ways.
    const half = rest.compare(HALF);
    const away =
      rounding === "nearest"
        ? half > 0 || (half === 0 && significand % 2n === 1n)
        : (rounding === "down") === value.sign() < 0;
    if (away) significand += 1n;
  }
  if (significand === powerOfTen(digits)) {
    significand /= 10n;
    exponent += 1;
  }
  return { significand, exponent, exact };
}

/**
 * The engine's rule for the digits of an interval's ends: five, or as many more as leave the printed interval at most a
 * twentieth wider than it is.
 * @param {Rational} lower
 * @param {Rational} upper
 */
export function digitsForInterval(lower, upper) {
  const room = upper.minus(lower).times(new Rational(1n, 20n));
  if (room.isZero()) return 5;
  /** @type {(value: Rational, digits: number, rounding: "down" | "up") => Rational} */
  const added = (value, digits, rounding) => {
    if (value.isZero()) return value;
    const { significand, exponent } = rounded(value, digits, rounding);
    const size = new Rational(significand).times(decimalPower(exponent + 1 - digits));
    return (value.sign() < 0 ? size.negated() : size).minus(value).absolute();
  };
  for (let digits = 5; digits <= MOST_DIGITS; digits += 1) {
    if (added(lower, digits, "down").plus(added(upper, digits, "up")).compare(room) <= 0) return digits;
  }
  return 5;
}

/**
 * An end of an interval, rounded outward; to nearest where the interval is a single number.
 * @param {Rational} value
 * @param {{ lower: Rational | null, upper: Rational | null }} interval
 * @param {"lower" | "upper"} end
 */
export function endText(value, { lower, upper }, end) {
  const outward = end === "lower" ? "down" : "up";
  if (lower === null || upper === null) return decimal(value, 5, outward);
  return decimal(value, digitsForInterval(lower, upper), lower.equals(upper) ? "nearest" : outward);
}

/**
 * The engine's rule for where the point stands and when a power of ten is written.
 * @param {string} text
 * @param {number} exponent
 * @param {boolean} exact
 */
function placePoint(text, exponent, exact) {
  const count = text.length;
  if (exponent < 0 && exponent >= LEAST_PLAIN) return `0.${"0".repeat(-1 - exponent)}${text}`;
  if (exponent >= 0 && exponent < count - 1)
    return `${text.slice(0, exponent + 1)}.${text.slice(exponent + 1)}`;
  if (exponent >= 0 && (exponent === count - 1 || (exact && exponent <= 5)))
    return text + "0".repeat(exponent + 1 - count);
  const head = count === 1 ? text : `${text[0]}.${text.slice(1)}`;
  return `${head}e${exponent}`;
}

/**
 * A measured value as it was written down, 0.013 and not 1.3e-2, when its decimal is short; else five digits, or as many more as tell
 * it from values that differ by a thousandth of `width`.
 * @param {Rational} value
 * @param {Rational} [width] how far the values beside it lie apart
 */
export function plain(value, width = ZERO) {
  const digits = digitsFor(value, width.times(THOUSANDTH));
  if (!value.isZero() && value.decimalExponent() > LARGEST_PLAIN) return decimal(value, digits);
  for (let places = 0; places <= MOST_PLACES; places += 1) {
    const scaled = value.times(decimalPower(places));
    if (scaled.denominator !== 1n) continue;
    const digits = `${scaled.absolute().numerator}`.padStart(places + 1, "0");
    const point = digits.length - places;
    const text = places === 0 ? digits : `${digits.slice(0, point)}.${digits.slice(point)}`;
    return numberText(value.sign() < 0 ? `-${text}` : text);
  }
  return decimal(value, digits);
}

/**
 * Five significant digits, or as many more as it takes to tell values apart that differ by `width`.
 * @param {Rational} value
 * @param {Rational} width
 */
export function digitsFor(value, width) {
  if (value.isZero() || width.isZero()) return 5;
  const firstThatDiffers = value.decimalExponent() - width.decimalExponent() + 1;
  return firstThatDiffers > 5 && firstThatDiffers < MOST_DIGITS ? firstThatDiffers + 1 : 5;
}

/**
 * A fraction short enough to read: the middle of a long one is left out. Tests and copies use the whole one.
 * @param {string} text
 */
export function shortFraction(text) {
  if (text.length <= LONGEST_FRACTION) return numberText(text);
  /** @param {string} part */
  const shorten = (part) => (part.length <= 20 ? part : `${part.slice(0, 9)}…${part.slice(-6)}`);
  return numberText(text.split("/").map(shorten).join("/"));
}

/**
 * The number of the condition that a half-plane belongs to, from 1.
 * @param {BoundName} name
 */
export function conditionNumber(name) {
  return Number.parseInt(name.bound.slice("where:".length), 10);
}

/**
 * The class that gives a half-plane its colour.
 * @param {BoundName} name
 */
export function boundClass(name) {
  return name.row === null ? "condition" : name.bound;
}

/**
 * Which side of an equation a half-plane is; nothing for an inequality.
 * @param {BoundName} name
 */
function conditionSide(name) {
  if (name.bound.endsWith(" upper")) return " (≤)";
  return name.bound.endsWith(" lower") ? " (≥)" : "";
}

/**
 * "upper bound of reading 14" or "condition 1" for a half-plane's name.
 * @param {BoundName} name
 */
export function boundText(name) {
  if (name.row === null) return t("bound.condition", { number: conditionNumber(name), side: conditionSide(name) });
  return t(name.bound === "upper" ? "bound.upper" : "bound.lower", { row: name.row });
}

/**
 * The same within a sentence: "the upper bound of reading 14" or "condition 1".
 * @param {BoundName} name
 */
export function theBound(name) {
  if (name.row === null) return t("bound.the-condition", { number: conditionNumber(name), side: conditionSide(name) });
  return t(name.bound === "upper" ? "wording.upper" : "wording.lower", { row: name.row });
}

/**
 * "14 ▾" for lists where space is short: ▾ upper bound, ▴ lower bound.
 * @param {BoundName} name
 */
export function boundMark(name) {
  if (name.row === null) return boundText(name);
  return `${name.row}\u202f${name.bound === "upper" ? "▾" : "▴"}`;
}

/**
 * "a, b and c".
 * @param {(string | number)[]} items
 */
export function enumeration(items) {
  return said({ list: items });
}

/**
 * A list in a text that stops when it gets long: "a, b and 48 more".
 * @param {(string | number)[]} items
 */
export function shortList(items) {
  const isLong = items.length > LONGEST_LIST + 1;
  return { list: isLong ? items.slice(0, LONGEST_LIST) : items, more: isLong ? items.length - LONGEST_LIST : 0 };
}

/**
 * An enumeration that stops when it gets long.
 * @param {(string | number)[]} items
 */
export function shortEnumeration(items) {
  return said(shortList(items));
}

/**
 * The name of x; one that is counted from an origin is a difference: `year − 1980`. Empty for two regressors.
 * @param {LessonData} data
 */
export function nameOfX({ model, asked }) {
  if (model.kind !== "line") return "";
  return asked.x_origin === undefined ? model.x : model.x.replace(/ - (?=\S+$)/, " \u2212 ");
}

/**
 * The number of vertex 0, 1, …, as reports and figures have it: 1, 2, …
 * @param {number} index
 */
export function vertexName(index) {
  return `${index + 1}`;
}

/**
 * The numbers of vertices that are drawn at one place: "4, 5", or "4–9" for many in a row.
 * @param {number[]} indices
 */
export function vertexNames(indices) {
  const runs = [];
  for (const index of indices) {
    const last = runs[runs.length - 1];
    if (last !== undefined && last[1] === index - 1) last[1] = index;
    else runs.push([index, index]);
  }
  /** @param {number[]} run */
  const part = ([first, last]) =>
    last - first < SHORTEST_RUN
      ? indices.filter((index) => index >= first && index <= last).map(vertexName)
      : [`${vertexName(first)}–${vertexName(last)}`];
  return runs.flatMap(part).join(", ");
}

/** The parameters as they are written. */
export const THETA = ["θ₁", "θ₂"];

/**
 * A name with its unit; a name such as "U (mV)" has its own already.
 * @param {string} name
 * @param {string | null | undefined} unit
 */
export function withUnit(name, unit) {
  return !unit || [`(${unit})`, `[${unit}]`].some((end) => name.endsWith(end)) ? name : `${name} (${unit})`;
}

/**
 * A parameter with its unit, where it has one.
 * @param {Lesson} lesson
 * @param {number} axis
 */
export function thetaName({ data }, axis) {
  return withUnit(THETA[axis], axis === 0 ? data.units.theta1 : data.units.theta2);
}

/**
 * A region's kind in words, with the number of vertices where that says something.
 * @param {Kind} kind
 * @param {number} vertices
 */
export function kindText(kind, vertices) {
  return t(`kind.${kind}`, { vertices });
}

/**
 * "Reading 3 is switched off." or "Readings 3 and 5 are switched off."
 * @param {number[]} rows
 */
export function switchedOff(rows) {
  return t("switch.is-off", { rows: shortList(rows) });
}
