// @ts-check
// The corridor: at each x everything between the highest and the lowest feasible line.

import { element } from "../dom.js";
import { pathThrough } from "./axes.js";
import { lineInView } from "./region.js";
import { Rational, ZERO, dot } from "../model/rational.js";
import { pointOnBoundary } from "../model/lesson.js";

// What is higher than so many pictures is cut, lest numbers grow too large to draw.
const BEYOND = 40;

/**
 * A height that is not too far outside the view to be drawn.
 * @param {number} value
 * @param {{ view: View }} map
 */
export function bounded(value, { view }) {
  const height = view.y[1] - view.y[0];
  return Math.min(view.y[1] + BEYOND * height, Math.max(view.y[0] - BEYOND * height, value));
}

/**
 * The height of a line as a function of the abscissa.
 * @param {Height} line
 * @returns {(u: number) => number}
 */
function at({ slope, start }) {
  return (u) => slope * u + start;
}

/**
 * The corridor of any set is spanned by its vertices and rays: at each x the highest and the lowest of their lines.
 * @param {{ points: ((u: number) => number)[], rays: ((u: number) => number)[] }} generators
 * @param {number} u
 * @param {ScreenMap} map
 */
function span(generators, u, map) {
  const values = generators.points.map((value) => value(u));
  const top = generators.rays.some((ray) => ray(u) > 1e-12) ? Infinity : Math.max(...values);
  const bottom = generators.rays.some((ray) => ray(u) < -1e-12) ? -Infinity : Math.min(...values);
  return [bounded(bottom, map), bounded(top, map)];
}

/**
 * The path of all feasible lines (or predictions) of the region shown.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
export function corridorPath(lesson, state, scene, frame, map) {
  const { region } = scene;
  if (region.kind === "empty") return "";
  const { corridor } = lesson.data;
  if (lesson.isLine && state.mode === "explore" && corridor !== null)
    return enginePath(lesson, corridor, frame, map);
  const corners = region.vertices.map((vertex) => vertex.theta);
  const sides = region.boundaries.map((index) => pointOnBoundary(lesson.halfPlanes[index], region.s));
  const points = corners.length > 0 ? corners : sides.length > 0 ? sides : [[ZERO, ZERO]];
  const rays = [
    ...region.rays,
    ...region.lines.flatMap((line) => [line, line.map((value) => value.negated())]),
  ];
  if (!lesson.isLine) return predictionBars(lesson, points, rays, frame, map);
  const lines = points.map((theta) => frame.line(theta));
  const ways = rays.map((ray) => frame.direction(ray));
  // The highest line changes where two neighbouring vertices give the same height, or where a ray turns.
  const turns = [
    ...lines
      .map((line, k) => [line, lines[(k + 1) % lines.length]])
      .map(([p, q]) => (q.start - p.start) / (p.slope - q.slope)),
    ...ways.flatMap((way) => [-way.start / way.slope - 1e-9, -way.start / way.slope + 1e-9]),
  ];
  const stations = [...turns.filter((u) => u > map.view.x[0] && u < map.view.x[1]), ...map.view.x].sort(
    (p, q) => p - q,
  );
  const generators = { points: lines.map(at), rays: ways.map(at) };
  return bandPath(
    map,
    stations.map((u) => [u, ...span(generators, u, map)]),
  );
}

/**
 * @param {ScreenMap} map
 * @param {number[][]} stations
 */
function bandPath(map, stations) {
  const lower = stations.map(([u, low]) => [u, low]);
  const upper = stations.map(([u, , high]) => [u, high]).reverse();
  return pathThrough(map, [...lower, ...upper], true);
}

/**
 * The engine's own corridor, with its exact breakpoints.
 * @param {Lesson} lesson
 * @param {{ upper: EnvelopeData, lower: EnvelopeData }} corridor
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
function enginePath(lesson, { upper, lower }, frame, map) {
  /**
   * @param {EnvelopeData} envelope
   * @param {number} infinite
   */
  const edge = (envelope, infinite) => {
    if (envelope.nowhere) return map.view.x.map((u) => [u, infinite]);
    /** @param {Exact} text */
    const placed = (text) => frame.number(0, Rational.parse(text));
    const breaks = envelope.breakpoints.map(placed);
    const from = Math.max(map.view.x[0], envelope.from === null ? -Infinity : placed(envelope.from));
    const to = Math.min(map.view.x[1], envelope.to === null ? Infinity : placed(envelope.to));
    if (from > to) return map.view.x.map((u) => [u, infinite]);
    const lines = envelope.lines.map((index) => frame.line(lesson.points[index]));
    /** @param {number} u */
    const on = (u) => {
      const { slope, start } = lines[breaks.filter((b) => b < u).length];
      return [u, bounded(slope * u + start, map)];
    };
    const points = [from, ...breaks.filter((u) => u > from && u < to), to].map(on);
    if (from > map.view.x[0]) points.unshift([map.view.x[0], infinite], [from, infinite]);
    if (to < map.view.x[1]) points.push([to, infinite], [map.view.x[1], infinite]);
    return points;
  };
  const top = edge(upper, bounded(Infinity, map));
  const bottom = edge(lower, bounded(-Infinity, map));
  return pathThrough(map, [...bottom, ...top.reverse()], true);
}

/**
 * @param {Lesson} lesson
 * @param {Pair[]} points
 * @param {Pair[]} rays
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
function predictionBars(lesson, points, rays, frame, map) {
  return lesson.readings
    .map((reading) => {
      const u = frame.across(reading);
      const generators = {
        points: points.map((theta) => () => frame.prediction(reading, theta)),
        rays: rays.map((ray) => () => dot(reading.phi, ray).sign()),
      };
      const [low, high] = span(generators, u, map);
      return pathThrough(
        map,
        [
          [u - 0.3, low],
          [u + 0.3, low],
          [u + 0.3, high],
          [u - 0.3, high],
        ],
        true,
      );
    })
    .join("");
}

/**
 * What the boxes among the layers claim about lines: more than the set does.
 * @param {Layer[]} layers
 * @param {State} state
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
export function boxEnvelopes(layers, state, frame, map) {
  const boxes = layers.flatMap(({ id, polygon }) =>
    polygon !== null && id.endsWith("-box") && state.layers.has(id) ? [{ id, polygon }] : [],
  );
  if (!frame.isLine) return element("g");
  return element(
    "g",
    {},
    boxes.map((layer) => {
      const lines = layer.polygon.map((theta) => frame.line(theta));
      const turns = lines
        .map((p, k) => [p, lines[(k + 1) % 4]])
        .map(([p, q]) => (q.start - p.start) / (p.slope - q.slope));
      const stations = [...turns.filter((u) => u > map.view.x[0] && u < map.view.x[1]), ...map.view.x].sort(
        (p, q) => p - q,
      );
      const generators = {
        points: lines.map(at),
        rays: [],
      };
      return element("path", {
        class: `outline layer-${layer.id}`,
        d: bandPath(
          map,
          stations.map((u) => [u, ...span(generators, u, map)]),
        ),
      });
    }),
  );
}

/**
 * The path of the line of θ, or through its predictions.
 * @param {Lesson} lesson
 * @param {Pair} theta
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
export function curvePath(lesson, theta, frame, map) {
  if (!lesson.isLine) {
    return pathThrough(
      map,
      lesson.readings.map((r) => [frame.across(r), bounded(frame.prediction(r, theta), map)]),
      false,
    );
  }
  const { slope, start } = frame.line(theta);
  const length = Math.hypot(slope, 1);
  const ends = lineInView({ a: [-slope / length, 1 / length], b: start / length }, map.view);
  return ends === null ? "" : pathThrough(map, ends, false);
}
