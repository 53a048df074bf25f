// @ts-check
// The intersection of half-planes, exactly: the double description method (Motzkin, Raiffa, Thompson and Thrall 1953) on the cone
// of all (θ₁, θ₂, w) with w ≥ 0 that a·θ ≤ b·w leaves. For sets that the engine could not know of: with several readings off.

import { ONE, Rational, ZERO } from "./rational.js";

/** @typedef {{ at: Rational[], tight: Set<number> }} Generator an extreme ray of the cone, and what it meets with equality */
/** @typedef {{ index: number, a: Rational[], b: Rational }} Side a·θ ≤ b */

/** The half-space w ≥ 0 among the constraints. */
const INFINITY = -1;

/**
 * The kind of the intersection, its vertices, counter-clockwise, and how it goes on.
 * @param {Side[]} sides
 * @returns {{ kind: Kind, vertices: Pair[], rays: Pair[], lines: Pair[], boundaries: number[] }}
 */
export function intersection(sides) {
  let lines = [
    [ONE, ZERO, ZERO],
    [ZERO, ONE, ZERO],
  ];
  /** @type {Generator[]} */
  let rays = [{ at: [ZERO, ZERO, ONE], tight: new Set() }];
  const before = new Set([INFINITY]);
  for (const side of sides) {
    /** @param {Rational[]} at */
    const excess = (at) => side.a[0].times(at[0]).plus(side.a[1].times(at[1])).minus(side.b.times(at[2]));
    const crossing = lines.findIndex((line) => !excess(line).isZero());
    if (crossing >= 0) {
      const line = lines[crossing];
      const by = excess(line);
      /** @param {Rational[]} at */
      const along = (at) => combined(at, ONE, line, excess(at).over(by).negated());
      lines = lines.filter((_, k) => k !== crossing).map(along);
      rays = rays.map(({ at, tight }) => ({ at: along(at), tight: new Set([...tight, side.index]) }));
      rays.push({ at: by.sign() > 0 ? line.map((value) => value.negated()) : line, tight: new Set(before) });
    } else {
      rays = cut(rays, side.index, excess);
    }
    before.add(side.index);
  }
  return describedCone(sides, lines, rays);
}

/**
 * p·s + q·t
 * @param {Rational[]} p
 * @param {Rational} s
 * @param {Rational[]} q
 * @param {Rational} t
 */
function combined(p, s, q, t) {
  return p.map((value, k) => value.times(s).plus(q[k].times(t)));
}

/**
 * The rays that a constraint leaves, and those in which it cuts the faces between neighbours.
 * @param {Generator[]} rays
 * @param {number} index
 * @param {(at: Rational[]) => Rational} excess
 */
function cut(rays, index, excess) {
  const signed = rays.map((ray) => ({ ray, by: excess(ray.at) }));
  const over = signed.filter(({ by }) => by.sign() > 0);
  const under = signed.filter(({ by }) => by.sign() < 0);
  const kept = signed.filter(({ by }) => by.sign() <= 0).map(({ ray, by }) => {
    if (by.isZero()) ray.tight.add(index);
    return ray;
  });
  for (const p of over) {
    for (const q of under) {
      const shared = [...p.ray.tight].filter((side) => q.ray.tight.has(side));
      const isFace = rays.every(
        (ray) => ray === p.ray || ray === q.ray || !shared.every((side) => ray.tight.has(side)),
      );
      if (!isFace) continue;
      const at = combined(q.ray.at, p.by, p.ray.at, q.by.negated());
      kept.push({ at: shortened(at), tight: new Set([...shared, index]) });
    }
  }
  return kept;
}

/**
 * A multiple with w = 1, or of a direction one with a component of size 1: numbers that do not grow from step to step.
 * @param {Rational[]} at
 */
function shortened(at) {
  const size = !at[2].isZero() ? at[2] : (at[0].isZero() ? at[1] : at[0]).absolute();
  return size.isZero() ? at : at.map((value) => value.over(size));
}

/**
 * @param {Side[]} sides
 * @param {Rational[][]} lines
 * @param {Generator[]} rays
 */
function describedCone(sides, lines, rays) {
  const ends = rays.filter(({ at }) => at[2].sign() > 0);
  const directions = rays.filter(({ at }) => at[2].isZero()).map(({ at }) => at.slice(0, 2));
  const kind = kindOf(lines.length, ends.length, directions.length);
  const points = ends.map(({ at }) => at.slice(0, 2).map((value) => value.over(at[2])));
  const isFlat = lines.length > 0;
  const boundaries = isFlat && kind !== "empty"
    ? ends.flatMap(({ tight }) => sides.filter(({ index, a }) => tight.has(index) && !a.every((c) => c.isZero())).slice(0, 1))
    : [];
  return {
    kind,
    vertices: isFlat || kind === "empty" ? [] : inOrder(points, directions),
    // Of a half-plane, the inner normal.
    rays: kind === "half-plane" ? boundaries.map(({ a }) => a.map((c) => c.negated())) : kind === "empty" ? [] : directions,
    lines: kind === "empty" ? [] : lines.map((line) => line.slice(0, 2)),
    boundaries: boundaries.map(({ index }) => index),
  };
}

/**
 * @param {number} lines
 * @param {number} points
 * @param {number} directions
 * @returns {Kind}
 */
function kindOf(lines, points, directions) {
  if (points === 0) return "empty";
  if (lines === 2) return "plane";
  if (lines === 1) return points === 2 ? "strip" : directions === 1 ? "half-plane" : "line";
  if (directions > 0) return points === 1 && directions === 1 ? "ray" : "unbounded-polygon";
  return points === 1 ? "point" : points === 2 ? "segment" : "polygon";
}

/**
 * Vertices counter-clockwise: from the lexicographically smallest one, or of an unbounded set from ray to ray.
 * @param {Rational[][]} points
 * @param {Rational[][]} directions
 */
function inOrder(points, directions) {
  /**
   * @param {Rational[]} p
   * @param {Rational[]} q
   */
  const cross = (p, q) => p[0].times(q[1]).minus(p[1].times(q[0]));
  if (directions.length > 0) {
    const [x, y] = [0, 1].map((axis) => directions.reduce((sum, direction) => sum.plus(direction[axis]), ZERO));
    return [...points].sort((p, q) => cross([x, y], q).compare(cross([x, y], p)));
  }
  const [first, ...rest] = [...points].sort((p, q) => p[0].compare(q[0]) || p[1].compare(q[1]));
  /** @param {Rational[]} p */
  const from = (p) => p.map((value, axis) => value.minus(first[axis]));
  return [first, ...rest.sort((p, q) => -cross(from(p), from(q)).sign())];
}
