// @ts-check
// Tick marks whose labels stay readable when an axis is 1e-5 wide around 1.8e-3: the part that all labels share
// and a power of ten are taken out and written once, beside the axis.

import { Rational, decimalPower } from "../model/rational.js";
import { decimal } from "../model/format.js";
import { numberText } from "../texts.js";

// Labels with more digits than this are shortened by an offset.
const LONGEST_LABEL = 4;
const LONGEST_OFFSET = 16;
const LARGEST_PLAIN_EXPONENT = 3;

/** @type {Record<string, string>} */
const SUPERSCRIPTS = {
  "-": "⁻",
  0: "⁰",
  1: "¹",
  2: "²",
  3: "³",
  4: "⁴",
  5: "⁵",
  6: "⁶",
  7: "⁷",
  8: "⁸",
  9: "⁹",
};

/** @param {number} exponent */
function powerText(exponent) {
  return `10${[...`${exponent}`].map((digit) => SUPERSCRIPTS[digit]).join("")}`;
}

/**
 * @param {Rational} span
 * @param {number} count
 */
function niceStep(span, count) {
  const rough = span.over(new Rational(BigInt(count)));
  const exponent = rough.decimalExponent();
  const factor = [1n, 2n, 5n].find((f) => rough.compare(new Rational(f).times(decimalPower(exponent))) <= 0);
  return factor === undefined ? { factor: 1n, exponent: exponent + 1 } : { factor, exponent };
}

/** @param {Rational} value */
function plainDecimal(value) {
  if (value.isZero()) return "0";
  const fraction = Math.max(0, LONGEST_LABEL + 2 - Math.max(0, value.decimalExponent()));
  return numberText(
    value
      .toNumber()
      .toFixed(fraction)
      .replace(/(\.\d*?)0+$/, "$1")
      .replace(/\.$/, ""),
  );
}

/**
 * Whether so many digits are all there are.
 * @param {Rational} value
 */
function isShort(value) {
  if (value.isZero()) return true;
  const scale = decimalPower(LONGEST_OFFSET - 1 - value.decimalExponent());
  return value.times(scale).denominator === 1n;
}

/** @param {Rational} value */
function offsetText(value) {
  if (isShort(value)) return decimal(value, LONGEST_OFFSET);
  // The rest of the digits is the same in all labels, but there is no room for it.
  return decimal(value, LONGEST_OFFSET, "down").replace(/(e.*)?$/, "…$1");
}

/**
 * Ticks on [low, high], exact.
 * @param {Rational} low
 * @param {Rational} high greater than low
 * @param {number} count how many ticks there is room for
 * @returns {{ticks: {value: Rational, label: string}[], note: string}} `note` is what to write beside the axis:
 *   "×10⁻⁵ + 1.8e-3", or nothing
 */
export function axisTicks(low, high, count) {
  const { factor, exponent } = niceStep(high.minus(low), count);
  const unit = decimalPower(exponent);
  const first = low.over(unit).over(new Rational(factor)).floor() + 1n;
  const last = high.over(unit).over(new Rational(factor)).floor();
  const multiples = [];
  for (let k = first; k <= last; k += 1n) multiples.push(k * factor);
  const longest = multiples.reduce((most, m) => Math.max(most, `${m < 0n ? -m : m}`.length), 0);
  let offset = 0n;
  if (longest > LONGEST_LABEL) {
    const round = 10n ** BigInt(`${multiples[multiples.length - 1] - multiples[0]}`.length);
    offset = (multiples[0] / round) * round;
    // 0.999…9 + a little is better written as 1 − a little.
    if (!isShort(new Rational(offset))) offset = new Rational(multiples[0]).roundedTo(new Rational(round)).numerator;
  }
  const labels = multiples.map((m) => new Rational(m - offset).times(unit));
  const magnitudes = labels.filter((label) => !label.isZero()).map((label) => label.decimalExponent());
  const power = magnitudes.length === 0 ? 0 : Math.max(...magnitudes);
  const shown = Math.abs(power) <= LARGEST_PLAIN_EXPONENT - (power < 0 ? 1 : 0) ? 0 : power;
  const scale = decimalPower(-shown);
  const offsetValue = new Rational(offset).times(unit);
  const notes = [];
  if (shown !== 0) notes.push(`×${powerText(shown)}`);
  if (offset !== 0n) notes.push(`${offset < 0n ? "−" : "+"} ${offsetText(offsetValue.absolute())}`);
  return {
    ticks: multiples.map((m, k) => ({
      value: new Rational(m).times(unit),
      label: plainDecimal(labels[k].times(scale)),
    })),
    note: notes.join(" "),
  };
}
