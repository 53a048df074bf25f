// @ts-check
// The stops of the ε slider: every breakpoint of the engine, exactly, and round values between them.

import { decimal } from "./format.js";
import { numberText } from "../texts.js";
import { ONE, Rational, decimalPower } from "./rational.js";

const ROUND_STOPS = 100;

/**
 * @param {Lesson} lesson
 * @returns {{s: Rational, breakpoint: number|null, piece: number|null}[]} ascending in s; the piece is the one that
 *   holds a stop that is no breakpoint
 */
export function sweepStops(lesson) {
  const { sweep } = lesson.data;
  if (sweep === null) return [];
  const breakpoints = sweep.breakpoints.map((point, k) => ({
    s: Rational.parse(point.s.exact),
    breakpoint: k,
    piece: null,
  }));
  const stops = [...breakpoints];
  const [first, last] = [breakpoints[0].s, breakpoints[breakpoints.length - 1].s];
  // Round in ε where there is one ε, else round in the factor s.
  const unit = lesson.epsilon ?? ONE;
  const span = last.minus(first);
  if (span.sign() > 0) {
    const step = roundStep(span.times(unit)).over(unit);
    const start = first.over(step).floor() + 1n;
    for (let s = new Rational(start).times(step); s.compare(last) < 0; s = s.plus(step))
      addStop(stops, breakpoints, s);
    if (ONE.compare(first) > 0 && ONE.compare(last) < 0) addStop(stops, breakpoints, ONE);
  }
  return stops.sort((p, q) => p.s.compare(q.s));
}

/** @param {Rational} span */
function roundStep(span) {
  const exponent = span.decimalExponent() - 2;
  const fitting = [1n, 2n, 5n, 10n].map((factor) => new Rational(factor).times(decimalPower(exponent)));
  return (
    fitting.find((step) => span.over(step).compare(new Rational(BigInt(ROUND_STOPS))) <= 0) ?? fitting[3]
  );
}

/**
 * @param {Stop[]} stops
 * @param {Stop[]} breakpoints
 * @param {Rational} s
 */
function addStop(stops, breakpoints, s) {
  if (stops.some((stop) => stop.s.equals(s))) return;
  const next = breakpoints.findIndex((point) => point.s.compare(s) > 0);
  if (next > 0) stops.push({ s, breakpoint: null, piece: next - 1 });
}

/**
 * Index of the stop where every error bound is as given, or the last one.
 * @param {Stop[]} stops
 */
export function givenStop(stops) {
  const found = stops.findIndex((stop) => stop.s.equals(ONE));
  return found < 0 ? stops.length - 1 : found;
}

/**
 * The one error bound at a stop, or the factor where readings have bounds of their own: exact, and as it is written everywhere.
 * @param {Lesson} lesson
 * @param {Stop} stop
 * @returns {{ name: string, exact: Rational, shown: string }}
 */
export function boundAtStop(lesson, stop) {
  const exact = lesson.epsilon === null ? stop.s : stop.s.times(lesson.epsilon);
  const engine = stop.breakpoint === null ? null : lesson.data.sweep?.breakpoints[stop.breakpoint];
  const written = lesson.epsilon === null ? engine?.s : engine?.epsilon;
  const shown = written ? numberText(written.decimal) : decimal(exact, 8);
  return { name: lesson.epsilon === null ? "s" : "ε", exact, shown };
}
