// @ts-check
// Exact fractions. The engine's numbers stay exact in the page until the moment they are drawn.

/**
 * @param {bigint} a
 * @param {bigint} b
 */
function greatestCommonDivisor(a, b) {
  while (b !== 0n) [a, b] = [b, a % b];
  return a < 0n ? -a : a;
}

/** @param {bigint} n */
function bitLength(n) {
  return (n < 0n ? -n : n).toString(16).length * 4;
}

/**
 * Ten to the power of a whole number ≥ 0, as a BigInt.
 * @param {number} exponent
 */
export function powerOfTen(exponent) {
  return 10n ** BigInt(exponent);
}

/** An exact rational number in lowest terms; immutable. */
export class Rational {
  /**
   * @param {bigint} numerator
   * @param {bigint} denominator
   */
  constructor(numerator, denominator = 1n) {
    if (denominator === 0n) throw new RangeError("a fraction with denominator 0");
    const sign = denominator < 0n ? -1n : 1n;
    const divisor = denominator === 1n ? 1n : greatestCommonDivisor(numerator, denominator);
    this.numerator = (sign * numerator) / divisor;
    this.denominator = (sign * denominator) / divisor;
  }

  /**
   * Reads "p/q" or "n", the form in which the engine writes exact numbers.
   * @param {Exact} text
   * @returns {Rational}
   */
  static parse(text) {
    const [numerator, denominator] = text.split("/");
    const number = Object.create(Rational.prototype);
    // The engine's fractions are in lowest terms: no need to reduce again.
    number.numerator = BigInt(numerator);
    number.denominator = denominator === undefined ? 1n : BigInt(denominator);
    return number;
  }

  /**
   * Reads a decimal as the engine writes it: "-0.25", "6.5e-5001".
   * @param {string} text
   */
  static parseDecimal(text) {
    const [digits, power = "0"] = text.split("e");
    const [whole, places = ""] = digits.split(".");
    const exponent = Number(power) - places.length;
    const mantissa = BigInt(whole + places);
    return exponent < 0
      ? new Rational(mantissa, powerOfTen(-exponent))
      : new Rational(mantissa * powerOfTen(exponent));
  }

  /**
   * The exact value of a finite binary64 number.
   * @param {number} value
   */
  static fromNumber(value) {
    let exponent = 0;
    while (!Number.isInteger(value)) {
      value *= 2;
      exponent += 1;
    }
    return new Rational(BigInt(value), 2n ** BigInt(exponent));
  }

  /** @param {Rational} other */
  plus(other) {
    return new Rational(
      this.numerator * other.denominator + other.numerator * this.denominator,
      this.denominator * other.denominator,
    );
  }

  /** @param {Rational} other */
  minus(other) {
    return this.plus(other.negated());
  }

  /** @param {Rational} other */
  times(other) {
    return new Rational(this.numerator * other.numerator, this.denominator * other.denominator);
  }

  /** @param {Rational} other */
  over(other) {
    return new Rational(this.numerator * other.denominator, this.denominator * other.numerator);
  }

  negated() {
    return new Rational(-this.numerator, this.denominator);
  }

  absolute() {
    return this.sign() < 0 ? this.negated() : this;
  }

  /** −1, 0 or 1. */
  sign() {
    return this.numerator === 0n ? 0 : this.numerator < 0n ? -1 : 1;
  }

  isZero() {
    return this.numerator === 0n;
  }

  /**
   * Negative, zero or positive as this number is less than, equal to or greater than the other.
   * @param {Rational} other
   */
  compare(other) {
    const difference = this.numerator * other.denominator - other.numerator * this.denominator;
    return difference === 0n ? 0 : difference < 0n ? -1 : 1;
  }

  /** @param {Rational} other */
  equals(other) {
    return this.numerator === other.numerator && this.denominator === other.denominator;
  }

  /** The greatest whole number that is not greater, as a BigInt. */
  floor() {
    const quotient = this.numerator / this.denominator;
    return this.numerator < 0n && quotient * this.denominator !== this.numerator ? quotient - 1n : quotient;
  }

  /**
   * The multiple of `unit` nearest to this number.
   * @param {Rational} unit
   */
  roundedTo(unit) {
    return new Rational(this.over(unit).plus(HALF).floor()).times(unit);
  }

  /** floor(log10 |this|) of a number other than 0, exact. */
  decimalExponent() {
    const magnitude = this.absolute();
    const bits = bitLength(magnitude.numerator) - bitLength(magnitude.denominator);
    // The estimate is within two of the truth; the loop decides exactly.
    let exponent = Math.floor((bits - 5) * Math.LOG10E * Math.LN2);
    while (magnitude.compare(decimalPower(exponent + 1)) >= 0) exponent += 1;
    return exponent;
  }

  /** The binary64 number next to this one; for drawing only. Safe for numerators and denominators of any size. */
  toNumber() {
    const shift = bitLength(this.denominator) - bitLength(this.numerator) + 64;
    const scaled =
      shift >= 0
        ? (this.numerator << BigInt(shift)) / this.denominator
        : this.numerator / (this.denominator << BigInt(-shift));
    // In two halves, because 2^-shift itself may be out of range.
    const half = Math.trunc(shift / 2);
    return Number(scaled) * 2 ** -half * 2 ** -(shift - half);
  }

  /** "p/q" or "n". */
  toString() {
    return this.denominator === 1n ? `${this.numerator}` : `${this.numerator}/${this.denominator}`;
  }
}

/**
 * 10^exponent for any whole exponent.
 * @param {number} exponent
 */
export function decimalPower(exponent) {
  return exponent >= 0 ? new Rational(powerOfTen(exponent)) : new Rational(1n, powerOfTen(-exponent));
}

// Beyond this nothing is told apart in a picture; squares and products of such numbers are still finite.
const FARTHEST = 1e60;
const FAR_EXPONENT = 60;

/**
 * A frame coordinate as a number; what is farther out than any view stays finite.
 * @param {Rational} value
 */
export function coordinate(value) {
  if (value.isZero()) return 0;
  if (value.decimalExponent() >= FAR_EXPONENT) return value.sign() * FARTHEST;
  return value.toNumber();
}

/**
 * Numbers in the proportion of the fractions, the greatest of them near 1, and the scale that was taken out.
 * @param {Rational[]} values
 */
export function proportions(values) {
  const sizes = values.filter((value) => !value.isZero()).map((value) => value.decimalExponent());
  const scale = decimalPower(sizes.length === 0 ? 0 : Math.max(...sizes));
  return { numbers: values.map((value) => value.over(scale).toNumber()), scale };
}

/** 0. */
export const ZERO = new Rational(0n);
/** 1. */
export const ONE = new Rational(1n);
/** 1/2. */
export const HALF = new Rational(1n, 2n);

/**
 * a₁·b₁ + a₂·b₂ of two pairs of rationals.
 * @param {Pair} a
 * @param {Pair} b
 */
export function dot(a, b) {
  return a[0].times(b[0]).plus(a[1].times(b[1]));
}

/**
 * The smaller and the greater of a non-empty list, as [least, greatest].
 * @param {Rational[]} values
 */
export function extremes(values) {
  return values.reduce(
    ([least, greatest], value) => [
      value.compare(least) < 0 ? value : least,
      value.compare(greatest) > 0 ? value : greatest,
    ],
    [values[0], values[0]],
  );
}

/**
 * The value of constant + slope·s + quadratic·s², the form in which the engine gives functions of s.
 * @param {PolynomialData} polynomial
 * @param {Rational} s
 */
export function evaluate(polynomial, s) {
  const slope = Rational.parse(polynomial.slope);
  const quadratic = polynomial.quadratic === undefined ? ZERO : Rational.parse(polynomial.quadratic);
  return Rational.parse(polynomial.constant).plus(slope.plus(quadratic.times(s)).times(s));
}
