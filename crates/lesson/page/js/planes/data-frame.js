// @ts-check
// The frame of the data plane: heights as measured or relative to the reference line, ready for drawing.

import { boundingView } from "./view.js";
import { boundAt } from "../model/lesson.js";
import { ONE, Rational, ZERO, coordinate, decimalPower, dot, extremes, proportions } from "../model/rational.js";

/**
 * Exact origins and units of both axes; in the residual view heights are relative to the reference line.
 * @param {Lesson} lesson
 * @param {boolean} residual
 * @returns {DataFrame}
 */
export function dataFrame(lesson, residual) {
  const reference = residual && lesson.reference !== null ? lesson.reference.theta : [ZERO, ZERO];
  const { readings } = lesson;
  const heights = readings.map((reading) => reading.y.minus(dot(reading.phi, reference)));
  const across = lesson.isLine
    ? readings.map((reading) => reading.phi[0])
    : readings.map((r) => new Rational(BigInt(r.index)));
  /**
   * @param {Rational[]} values
   * @param {Rational} least
   */
  const unitOf = (values, least) => {
    const [low, high] = values.length === 0 ? [ZERO, ONE] : extremes(values);
    const width = high.minus(low);
    const size = width.compare(least) > 0 ? width : least;
    const unit = decimalPower(size.isZero() ? 0 : size.decimalExponent());
    return { unit, origin: low.roundedTo(unit) };
  };
  const widest = readings.length === 0 ? ONE : extremes(readings.map((reading) => reading.epsilon))[1];
  // Rows are counted: ticks and predictions take a whole unit for each, however many there are.
  const x = lesson.isLine ? unitOf(across, ZERO) : { unit: ONE, origin: ZERO };
  // Relative heights keep the true zero.
  const y = unitOf(heights, widest);
  if (residual) y.origin = ZERO;
  /** @param {Rational} value */
  const placeX = (value) => coordinate(value.minus(x.origin).over(x.unit));
  /** @param {Rational} value */
  const placeY = (value) => coordinate(value.minus(y.origin).over(y.unit));
  return {
    isLine: lesson.isLine,
    exact: (axis, number) => Rational.fromNumber(number).times([x, y][axis].unit).plus([x, y][axis].origin),
    number: (axis, value) => [placeX, placeY][axis](value),
    across: (reading) => placeX(lesson.isLine ? reading.phi[0] : new Rational(BigInt(reading.index))),
    height: (phi, value) => placeY(value.minus(dot(phi, reference))),
    measured: (phi, number) => Rational.fromNumber(number).times(y.unit).plus(y.origin).plus(dot(phi, reference)),
    length: (epsilon) => coordinate(epsilon.over(y.unit)),
    line: (theta) => {
      const [d1, d2] = [theta[0].minus(reference[0]), theta[1].minus(reference[1])];
      return {
        slope: coordinate(d1.times(x.unit).over(y.unit)),
        start: coordinate(d1.times(x.origin).plus(d2).minus(y.origin).over(y.unit)),
      };
    },
    prediction: (reading, theta) => placeY(dot(reading.phi, theta).minus(dot(reading.phi, reference))),
    // Only the direction counts, whatever the length.
    direction: (ray) => {
      const [slope, start] = proportions([ray[0].times(x.unit), ray[0].times(x.origin).plus(ray[1])]).numbers;
      return { slope, start };
    },
  };
}

/**
 * The view that holds all fitted readings.
 * @param {Lesson} lesson
 * @param {DataFrame} frame
 * @param {Rational} s
 */
export function automaticDataView(lesson, frame, s) {
  const points = lesson.readings.flatMap((reading) => {
    const u = frame.across(reading);
    const v = frame.height(reading.phi, reading.y);
    const factor = s.compare(ONE) > 0 ? s : ONE;
    const ends = [boundAt(reading, "lower", factor), boundAt(reading, "upper", factor)];
    return [[u, v], ...ends.flatMap((end) => (end === null ? [] : [[u, frame.height(reading.phi, end)]]))];
  });
  return points.length === 0 ? { x: [0, 1], y: [0, 1] } : boundingView(points, 0.07);
}
