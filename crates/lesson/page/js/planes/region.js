// @ts-check
// Convex regions in frame coordinates, cut to the part that is shown. Unbounded regions are cut only here.

import { rightHandSide } from "../model/lesson.js";

// Far enough for a cut region to reach beyond every view, near enough for floating point.
const FAR = 1e4;

/**
 * @param {Place} o
 * @param {Place} p
 * @param {Place} q
 */
function cross(o, p, q) {
  return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}

/** @param {Place[]} points */
function convexHull(points) {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  /** @param {Place[]} list */
  const chain = (list) => {
    /** @type {Place[]} */
    const kept = [];
    for (const point of list) {
      while (kept.length > 1 && cross(kept[kept.length - 2], kept[kept.length - 1], point) <= 0) kept.pop();
      kept.push(point);
    }
    kept.pop();
    return kept;
  };
  return sorted.length < 3 ? sorted : [...chain(sorted), ...chain(sorted.reverse())];
}

/**
 * @param {Line} line
 * @param {Place} point
 */
function footOn({ a, b }, [x, y]) {
  const distance = b - a[0] * x - a[1] * y;
  return [x + distance * a[0], y + distance * a[1]];
}

/**
 * Corners of a polygon that agrees with the region inside the view and reaches beyond it where the region does.
 * @param {Lesson} lesson
 * @param {Region} region
 * @param {ParameterFrame} frame
 * @param {View} view
 * @returns {number[][]} counter-clockwise in frame coordinates; fewer than three for points and lines; [] when empty
 */
export function cornersOf(lesson, region, frame, view) {
  if (region.kind === "empty") return [];
  const centre = [(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2];
  const places = region.vertices.map((vertex) => frame.place(vertex.theta));
  if (places.length > 0 && region.rays.length === 0) return places;
  const sides = region.boundaries.map((index) => {
    const halfPlane = lesson.halfPlanes[index];
    return footOn(frame.halfPlane(halfPlane.a, rightHandSide(halfPlane, region.s)), centre);
  });
  const anchors = places.length > 0 ? places : sides.length > 0 ? sides : [centre];
  const extent = Math.max(view.x[1] - view.x[0], view.y[1] - view.y[0]);
  const far = FAR * Math.max(extent, ...anchors.map(([x, y]) => Math.hypot(x - centre[0], y - centre[1])));
  const rays = region.rays.map((ray) => frame.direction(ray));
  const ways = region.lines.flatMap((line) => {
    const [x, y] = frame.direction(line);
    return [
      [x, y],
      [-x, -y],
    ];
  });
  let points = anchors;
  /** @param {Place[]} directions */
  const spread = (directions) =>
    points.flatMap((p) => [p, ...directions.map((d) => [p[0] + far * d[0], p[1] + far * d[1]])]);
  if (ways.length > 0) points = spread(ways);
  if (rays.length > 0) points = spread(rays);
  return convexHull(points);
}

/**
 * A polygon cut by the half-plane a·u ≤ b.
 * @param {Corner[]} corners
 * @param {Line} line
 * @param {boolean} cut whether the edge that the half-plane makes is none of the region's own
 */
export function clipped(corners, { a, b }, cut) {
  /** @param {Corner} options */
  const height = ({ point }) => a[0] * point[0] + a[1] * point[1] - b;
  /** @type {Corner[]} */
  const kept = [];
  corners.forEach((corner, k) => {
    const next = corners[(k + 1) % corners.length];
    const [here, there] = [height(corner), height(next)];
    if (here <= 0) kept.push(here === 0 && there > 0 ? { point: corner.point, cut } : corner);
    if (here < 0 !== there < 0 && here !== 0 && there !== 0) {
      const t = here / (here - there);
      const point = corner.point.map((value, axis) => value + t * (next.point[axis] - value));
      kept.push({ point, cut: here < 0 ? cut : corner.cut });
    }
  });
  return kept;
}

/**
 * The corners of a polygon inside the view, each marked when the edge to the next one is the view's and not its own.
 * @param {Place[]} corners
 * @param {View} view
 */
export function cornersInView(corners, view) {
  const walls = [
    { a: [1, 0], b: view.x[1] },
    { a: [0, 1], b: view.y[1] },
    { a: [-1, 0], b: -view.x[0] },
    { a: [0, -1], b: -view.y[0] },
  ];
  const marked = corners.map((point) => ({ point, cut: false }));
  return walls.reduce((left, wall) => clipped(left, wall, true), marked);
}

/**
 * The segment of the line a·u = b inside the view, or null.
 * @param {Line} line
 * @param {View} view
 */
export function lineInView({ a, b }, view) {
  const centre = [(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2];
  const foot = footOn({ a, b }, centre);
  const along = [-a[1], a[0]];
  let [from, to] = [-Infinity, Infinity];
  for (const [axis, range] of [view.x, view.y].entries()) {
    if (along[axis] === 0) {
      if (foot[axis] < range[0] || foot[axis] > range[1]) return null;
      continue;
    }
    const ends = range.map((value) => (value - foot[axis]) / along[axis]).sort((p, q) => p - q);
    from = Math.max(from, ends[0]);
    to = Math.min(to, ends[1]);
  }
  if (from >= to) return null;
  return [from, to].map((t) => [foot[0] + t * along[0], foot[1] + t * along[1]]);
}
