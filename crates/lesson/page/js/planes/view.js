// @ts-check
// From exact values to the screen. A frame is an exact origin and unit per axis: subtracting the origin happens in
// fractions, so that what remains is small and safe as a floating-point number. A view is the part of the frame that
// is shown.

import { verticesAt } from "../model/lesson.js";
import { ONE, Rational, ZERO, coordinate, decimalPower, dot, extremes, proportions } from "../model/rational.js";

const WORTH_STRAIGHTENING = 0.02;
const FARTHEST_PIXEL = 1e6;

/**
 * A power of ten near a positive width: as a unit it keeps the fractions short.
 * @param {Rational} width
 */
function unitFor(width) {
  return decimalPower(width.decimalExponent());
}

/**
 * The frame of the parameter plane. With a shear c the second axis shows θ₂ + c·θ₁, for a line its height at x = c,
 * which opens thin diagonal sets.
 */
export class ParameterFrame {
  /**
   * @param {Pair} origin
   * @param {Rational[]} widths
   * @param {Rational} shear
   */
  constructor(origin, widths, shear) {
    this.shear = shear;
    this.units = widths.map(unitFor);
    const sheared = [origin[0], origin[1].plus(shear.times(origin[0]))];
    this.origin = sheared.map((value, k) => value.roundedTo(this.units[k].times(decimalPower(-1))));
  }

  /**
   * Axis values of a parameter point: θ₁ and θ₂ + c·θ₁.
   * @param {Pair} theta
   */
  axes(theta) {
    return this.shear.isZero() ? theta : [theta[0], theta[1].plus(this.shear.times(theta[0]))];
  }

  /**
   * Frame coordinates, as numbers.
   * @param {Pair} theta
   */
  place(theta) {
    return this.axes(theta).map((value, k) => this.coordinate(k, value));
  }

  /**
   * The frame coordinate of an exact value on an axis.
   * @param {number} axis
   * @param {Rational} value
   */
  coordinate(axis, value) {
    return coordinate(value.minus(this.origin[axis]).over(this.units[axis]));
  }

  /**
   * A direction in frame coordinates, of length 1.
   * @param {Pair} theta
   */
  direction(theta) {
    const [x, y] = proportions(this.axes(theta).map((value, k) => value.over(this.units[k]))).numbers;
    const length = Math.hypot(x, y) || 1;
    return [x / length, y / length];
  }

  /**
   * The exact value of frame coordinate `number` on an axis.
   * @param {number} axis
   * @param {number} number
   */
  axisValue(axis, number) {
    return Rational.fromNumber(number).times(this.units[axis]).plus(this.origin[axis]);
  }

  /**
   * The parameter point at frame coordinates, rounded to whole multiples of the units given.
   * @param {Place} position
   * @param {Rational[]} rounding
   */
  theta(position, rounding) {
    const [first, second] = position.map((number, axis) =>
      this.axisValue(axis, number).roundedTo(rounding[axis]),
    );
    return [first, second.minus(this.shear.times(first))];
  }

  /**
   * The half-plane a·θ ≤ b in frame coordinates, with |a| = 1.
   * @param {Pair} a
   * @param {Rational} b
   * @returns {Line}
   */
  halfPlane(a, b) {
    const sheared = [a[0].minus(this.shear.times(a[1])), a[1]];
    const rest = b.minus(dot(sheared, this.origin));
    const { numbers, scale } = proportions(sheared.map((value, k) => value.times(this.units[k])));
    const length = Math.hypot(...numbers) || 1;
    return { a: numbers.map((value) => value / length), b: coordinate(rest.over(scale)) / length };
  }
}

/**
 * The mean x, rounded: where the height of a line says most. For two regressors, the slope that does the same.
 * @param {Lesson} lesson
 */
export function usefulShear(lesson) {
  const square = lesson.readings.map((r) => r.phi[1].times(r.phi[1])).reduce((sum, v) => sum.plus(v), ZERO);
  const mixed = lesson.readings.map((r) => r.phi[0].times(r.phi[1])).reduce((sum, v) => sum.plus(v), ZERO);
  if (square.isZero()) return ZERO;
  const mean = mixed.over(square);
  const spread = extremes(lesson.readings.map((r) => r.phi[0]));
  const width = spread[1].minus(spread[0]);
  return width.isZero() ? mean : mean.roundedTo(unitFor(width).times(decimalPower(-1)));
}

/** @param {Pair[]} points */
function spreadOf(points) {
  return [0, 1].map((axis) => {
    const [least, greatest] = extremes(points.map((point) => point[axis]));
    return { middle: least.plus(greatest).over(new Rational(2n)), width: greatest.minus(least) };
  });
}

/**
 * The frame around the feasible set; where that has no size, around what can be seen beside it.
 * @param {Lesson} lesson
 * @param {Rational} shear
 */
export function parameterFrame(lesson, shear) {
  /** @param {Pair} options */
  const axes = ([first, second]) => [first, second.plus(shear.times(first))];
  const { fit, sweep } = lesson.data;
  // Sets grow with the error bounds: the last one holds all others.
  const widest = sweep?.breakpoints.at(-1);
  const wide = widest ? verticesAt(lesson, widest, Rational.parse(widest.s.exact)) : [];
  const estimates = [fit.least_squares, fit.minimax].flatMap((estimate) => (estimate === null ? [] : [estimate.theta]));
  /** @param {NumberData[]} theta */
  const exact = (theta) => theta.map((value) => Rational.parse(value.exact));
  const sets = [lesson.fps.vertices.map((v) => v.theta), wide, estimates.map(exact)];
  const points = sets.map((set) => set.map(axes)).filter((set) => set.length > 0);
  const origin = points.length > 0 ? spreadOf(points[0]).map((axis) => axis.middle) : [ZERO, ZERO];
  const widths = [0, 1].map((axis) => {
    const found = points.map((set) => spreadOf(set)[axis].width).find((width) => width.sign() > 0);
    return found ?? widthOfReadings(lesson, axis, shear);
  });
  return new ParameterFrame([origin[0], origin[1].minus(shear.times(origin[0]))], widths, shear);
}

/**
 * Nothing has a size (a strip, say): a few error bounds as seen along the axis.
 * @param {Lesson} lesson
 * @param {number} axis
 * @param {Rational} shear
 */
function widthOfReadings(lesson, axis, shear) {
  if (lesson.readings.length === 0) return ONE;
  const [, epsilon] = extremes(lesson.readings.map((reading) => reading.epsilon));
  const column = lesson.readings.map(({ phi }) => (axis === 1 ? phi[1] : phi[0].minus(shear.times(phi[1]))));
  const [, phi] = extremes(column.map((value) => value.absolute()));
  const size = epsilon.isZero() ? ONE : epsilon;
  return phi.isZero() ? size : size.over(phi);
}

/**
 * Whether the set is so thin a sliver that it needs straightening to be seen.
 * @param {ParameterFrame} frame
 * @param {Region} region
 */
export function isSliver(frame, region) {
  if (region.vertices.length < 3) return false;
  const places = region.vertices.map((vertex) => frame.place(vertex.theta));
  const { x, y } = boundingView(places, 0);
  const area = places.reduce((sum, p, k) => {
    const q = places[(k + 1) % places.length];
    return sum + p[0] * q[1] - p[1] * q[0];
  }, 0);
  return Math.abs(area) / 2 < WORTH_STRAIGHTENING * (x[1] - x[0]) * (y[1] - y[0]);
}

/**
 * The view {x: [low, high], y: [low, high]} around points, padded by a share of its size.
 * @param {Place[]} points
 * @param {number} padding
 */
export function boundingView(points, padding) {
  /** @param {number} axis */
  const range = (axis) => {
    const values = points.map((point) => point[axis]);
    const low = Math.min(...values);
    const high = Math.max(...values);
    const room = (high - low || 1) * padding;
    return [low - room, high + room];
  };
  return { x: range(0), y: range(1) };
}

/**
 * The view scaled by a factor about a point (its centre by default).
 * @param {View} view
 * @param {number} factor
 * @param {Place} [centre]
 */
export function scaledView(
  view,
  factor,
  [cx, cy] = [(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2],
) {
  /**
   * @param {number[]} range
   * @param {number} c
   */
  const scale = (range, c) => range.map((value) => c + (value - c) * factor);
  return { x: scale(view.x, cx), y: scale(view.y, cy) };
}

/**
 * The view moved by shares of its width and height.
 * @param {View} view
 * @param {number} right
 * @param {number} up
 */
export function shiftedView(view, right, up) {
  /**
   * @param {number[]} range
   * @param {number} share
   */
  const shift = (range, share) => range.map((value) => value + share * (range[1] - range[0]));
  return { x: shift(view.x, right), y: shift(view.y, up) };
}

/**
 * The smallest of the nested views base, 2·base, 4·base, … that is fit; growing in leaps keeps the axes still.
 * @param {View} base
 * @param {(view: View) => boolean} isFit
 * @param {number} most
 */
export function leapingView(base, isFit, most) {
  let view = base;
  for (let leap = 0; leap < most && !isFit(view); leap += 1) view = scaledView(view, 2);
  return view;
}

/**
 * Maps frame coordinates to pixels of a drawing area {left, top, width, height} and back.
 * @param {View} view
 * @param {Area} area
 * @returns {ScreenMap}
 */
export function screenMap(view, area) {
  // Pixels that far outside the picture only need to stay outside: greater numbers are no coordinates for SVG.
  /** @param {number} value */
  const pixel = (value) => Math.max(-FARTHEST_PIXEL, Math.min(FARTHEST_PIXEL, value));
  const sx = area.width / (view.x[1] - view.x[0]);
  const sy = area.height / (view.y[1] - view.y[0]);
  return {
    area,
    view,
    to: ([x, y]) => [pixel(area.left + (x - view.x[0]) * sx), pixel(area.top + (view.y[1] - y) * sy)],
    from: ([px, py]) => [view.x[0] + (px - area.left) / sx, view.y[1] - (py - area.top) / sy],
  };
}
