// @ts-check
// The picture of half-planes: lines with hatching on the side they forbid, the set, normal cones, the objective with its
// support line and face, the path of the simplex method.

import { byId, element, patch } from "../dom.js";
import { coordinate } from "../model/rational.js";
import { axes, pathThrough, plotArea, round } from "../planes/axes.js";
import { clipped, cornersInView, cornersOf, lineInView } from "../planes/region.js";
import { screenMap } from "../planes/view.js";
import { t } from "../texts.js";
import { drawnHalfPlanes, drawnRegion, exactPair, planeName, plainOf } from "./document.js";
import { formText, pairText } from "./half-planes.js";
import { PLANE_FRAME, planeView, reachShown, shownBases, shownExercise, shownSet } from "./scene.js";

/** Pixels of the arrow for each unit of the objective. */
export const PIXELS_PER_UNIT = 16;
const SHORTEST_ARROW = 48;
const LONGEST_ARROW = 130;
const SMALL_CONE = 30;
const LARGE_CONE = 62;
const LINE_LABEL = { width: 30, height: 16 };

/**
 * Draws the picture.
 * @param {PolytopeState} state
 * @param {Size} size
 * @returns {PolytopeDrawn}
 */
export function drawHalfPlanes(state, size) {
  const area = plotArea(size.width, size.height);
  const map = screenMap(planeView(state, area), area);
  const { answer } = state;
  const { set, before, step } = answer === null ? { set: null, before: null, step: null } : shownSet(state, answer);
  const middle = [area.left + area.width / 2, area.top + area.height / 2];
  const anchor = answer === null || answer.set === null ? middle : middleOf(answer.set, answer, map) ?? middle;
  const svg = byId("half-plane-picture");
  svg.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
  svg.setAttribute("data-kind", set?.kind ?? "");
  svg.classList.toggle("drawing", state.drawing);
  const { left, top, width, height } = area;
  patch(svg, [
    element("title", { id: "half-plane-picture-title" }, t("polytope.picture")),
    element("defs", {},
      element("clipPath", { id: "half-plane-clip" }, element("rect", { x: left, y: top, width, height })),
      element("marker", { id: "arrow-head", viewBox: "0 0 10 10", refX: 8, refY: 5, markerWidth: 5, markerHeight: 5, orient: "auto-start-reverse" },
        element("path", { class: "arrow-head", d: "M0 0L10 5L0 10Z" })),
      element("pattern", { id: "plane-hatch", width: 7, height: 7, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
        element("rect", { class: "hatch-ground", width: 7, height: 7 }), element("path", { class: "hatch-line", d: "M0 0V7" })),
    ),
    axes(map, (axis, number) => PLANE_FRAME.axisValue(axis, number), (axis, value) => PLANE_FRAME.coordinate(axis, value), ["x", "y"]),
    answer === null ? element("g") : element("g", { "clip-path": "url(#half-plane-clip)" },
      set === null ? element("g") : filledSet(set, answer, map, "region"),
      cutAway(before, step, answer, map),
      planeLines(state, answer, set, map),
      supportLine(state, answer, map),
      state.tab === "objective" ? normalCones(answer, state, map) : element("g"),
      simplexWay(state, answer, map),
    ),
    answer === null || set === null ? element("g") : cornerMarks(state, answer, set, step, map),
    answer === null ? element("g") : element("g", { "aria-hidden": "true" }, lineLabels(state, answer, map)),
    answer === null || set === null || state.tab !== "objective" ? element("g") : objectiveArrow(state, anchor),
    turningPlaces(state, answer, map),
    set?.kind === "empty" ? element("text", { class: "note", x: left + width / 2, y: top + 26, "text-anchor": "middle" }, t("polytope.kind-empty")) : element("text"),
    element("path", { id: "line-being-drawn", class: "bound drawn-line" }),
  ]);
  return { map, anchor };
}

/**
 * The set, cut to the view.
 * @param {PolytopeSetData} set
 * @param {PolytopeData} answer
 * @param {ScreenMap} map
 */
function setInView(set, answer, map) {
  return cornersInView(cornersOf(drawnHalfPlanes(answer), drawnRegion(set), PLANE_FRAME, map.view), map.view);
}

/**
 * The middle of what is seen of a set, in pixels.
 * @param {PolytopeSetData} set
 * @param {PolytopeData} answer
 * @param {ScreenMap} map
 */
function middleOf(set, answer, map) {
  const points = setInView(set, answer, map).map(({ point }) => map.to(point));
  if (points.length === 0) return null;
  return [0, 1].map((axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length);
}

/**
 * @param {PolytopeSetData} set
 * @param {PolytopeData} answer
 * @param {ScreenMap} map
 * @param {string} name
 */
function filledSet(set, answer, map, name) {
  const shown = setInView(set, answer, map);
  /** @param {Corner} corner @param {number} k */
  const edge = (corner, k) => (corner.cut ? "" : pathThrough(map, [corner.point, shown[(k + 1) % shown.length].point], false));
  return element("g", {},
    element("path", { class: `${name} fill`, d: pathThrough(map, shown.map(({ point }) => point), true) }),
    element("path", { class: `${name} edge`, d: shown.map(edge).join("") }),
  );
}

/**
 * What a step cut off.
 * @param {PolytopeSetData | null} before
 * @param {PolytopeStepData | null} step
 * @param {PolytopeData} answer
 * @param {ScreenMap} map
 */
function cutAway(before, step, answer, map) {
  if (before === null || step === null || step.redundant !== null || before.kind === "empty") return element("path");
  const { a, b } = lineOf(answer, step.half_plane);
  if (a.every((value) => value === 0)) return element("path");
  const shown = clipped(setInView(before, answer, map), { a: a.map((value) => -value), b: -b }, true);
  return element("path", { class: "cut-off", d: pathThrough(map, shown.map(({ point }) => point), true) });
}

/**
 * A half-plane as numbers, with |a| = 1.
 * @param {PolytopeData} answer
 * @param {number} index
 */
function lineOf(answer, index) {
  const { a, b } = plainOf(answer.half_planes[index]);
  return a.every((value) => value.isZero()) ? { a: [0, 0], b: 0 } : PLANE_FRAME.halfPlane(a, b);
}

/**
 * How a half-plane is drawn.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 * @param {PolytopeSetData | null} set
 * @param {number} index
 */
function classesOf(state, answer, set, index) {
  const classes = ["bound", "own"];
  const { objective } = answer;
  const bases = shownBases(state, answer);
  const last = bases[bases.length - 1];
  const proof = state.tab === "objective" && objective?.outcome === "bounded" ? objective.proof : set?.contradiction?.by ?? [];
  if (state.tab === "clip" && state.step > 0 && answer.steps[state.step - 1].half_plane === index) classes.push("current");
  else if (proof.some(({ half_plane }) => half_plane === index)) classes.push("proof");
  else if (last?.half_planes.includes(index)) classes.push("basis");
  else if (set !== null && state.tab !== "clip" && answer.half_planes[index].redundant !== null) classes.push("redundant");
  if (last !== undefined && last.pivot?.entering === index) classes.push("entering");
  if (last !== undefined && last.pivot?.leaving === index) classes.push("leaving");
  if (state.chosen === index && state.tab !== "exercises") classes.push("chosen");
  return classes.join(" ");
}

/**
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 * @param {PolytopeSetData | null} set
 * @param {ScreenMap} map
 */
function planeLines(state, answer, set, map) {
  const shown = state.tab === "clip" ? state.step : answer.half_planes.length;
  const focused = Math.min(state.chosen ?? 0, answer.half_planes.length - 1);
  const isFixed = shownExercise(state) !== null;
  return element("g", { role: "group", "aria-label": t("polytope.lines") }, answer.half_planes.slice(0, shown).map((halfPlane, index) => {
    const line = lineOf(answer, index);
    const ends = line.a.every((value) => value === 0) ? null : lineInView(line, map.view);
    const name = planeName(answer, index);
    const attributes = {
      class: classesOf(state, answer, set, index), "data-plane-line": index, role: isFixed ? "img" : "button", tabindex: isFixed ? null : index === focused ? 0 : -1,
      // Of an exercise that is not solved yet nothing is told.
      "aria-label": t(halfPlane.redundant === null || set === null ? "polytope.line" : "polytope.line-redundant", { name, text: { formula: halfPlane.text } }),
      "aria-pressed": isFixed ? null : `${state.chosen === index}`,
    };
    if (ends === null) return element("g", attributes);
    const [from, to] = ends.map(map.to);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    // The forbidden side is on the right of the way from one end to the other.
    const [ox, oy] = [(-(to[1] - from[1]) / length) * 3.5, ((to[0] - from[0]) / length) * 3.5];
    /** @param {number} times */
    const way = (times) => `M${round(from[0] + ox * times)} ${round(from[1] + oy * times)}L${round(to[0] + ox * times)} ${round(to[1] + oy * times)}`;
    return element("g", attributes,
      element("path", { class: "grip", d: way(0) }),
      element("path", { class: "ticks", d: way(1) }),
      element("path", { class: "line", d: way(0) }),
    );
  }));
}

/**
 * The names of the lines, each where its line has room for it.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 * @param {ScreenMap} map
 */
function lineLabels(state, answer, map) {
  /** @type {Place[]} */
  const taken = (answer.set?.vertices ?? []).map(({ theta }) => map.to(exactPair(theta).map(coordinate)));
  const shown = state.tab === "clip" ? state.step : answer.half_planes.length;
  const { left, top, width, height } = map.area;
  return answer.half_planes.slice(0, shown).map((_, index) => {
    const line = lineOf(answer, index);
    const ends = line.a.every((value) => value === 0) ? null : lineInView(line, map.view);
    if (ends === null) return null;
    const [from, to] = ends.map(map.to);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const [ox, oy] = [(-(to[1] - from[1]) / length) * 15, ((to[0] - from[0]) / length) * 15];
    const share = [0.93, 0.07, 0.86, 0.14, 0.78, 0.22, 0.7, 0.3, 0.6, 0.4, 0.5].find((own) => {
      const [x, y] = [from[0] + own * (to[0] - from[0]) + ox, from[1] + own * (to[1] - from[1]) + oy];
      const isIn = x > left + 14 && x < left + width - 14 && y > top + 10 && y < top + height - 10;
      return isIn && taken.every(([px, py]) => Math.abs(px - x) > LINE_LABEL.width || Math.abs(py - y) > LINE_LABEL.height);
    });
    if (share === undefined) return null;
    const place = [from[0] + share * (to[0] - from[0]) + ox, from[1] + share * (to[1] - from[1]) + oy];
    taken.push(place);
    return element("text", { class: "line-name", x: round(place[0]), y: round(place[1] + 5), "text-anchor": "middle" }, planeName(answer, index));
  });
}

/**
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 * @param {PolytopeSetData} set
 * @param {PolytopeStepData | null} step
 * @param {ScreenMap} map
 */
function cornerMarks(state, answer, set, step, map) {
  const { left, top, width, height } = map.area;
  const bases = shownBases(state, answer);
  const here = bases[bases.length - 1]?.vertex ?? null;
  return element("g", { role: "group", "aria-label": t("polytope.corners") }, set.vertices.map(({ theta, active }, index) => {
    const [x, y] = map.to(exactPair(theta).map(coordinate));
    const isShown = x >= left - 1 && x <= left + width + 1 && y >= top - 1 && y <= top + height + 1;
    const isNew = step?.born.some((own) => own[0] === theta[0] && own[1] === theta[1]) ?? false;
    const names = active.map((own) => planeName(answer, own));
    const isStart = state.tab === "simplex";
    return element("g", {
      class: ["vertex", isNew && "born", here === index && "chosen", active.length > 2 && "degenerate", !isShown && "outside"].filter(Boolean).join(" "),
      "data-corner": index, "data-theta1": theta[0], "data-theta2": theta[1],
      role: isStart ? "button" : "img", tabindex: isStart ? (index === (here ?? 0) ? 0 : -1) : null,
      "aria-label": t(isStart ? "polytope.corner-start" : "polytope.corner", { corner: pairText(exactPair(theta)), names: { list: names } }),
      transform: isShown ? `translate(${round(x)} ${round(y)})` : "translate(-99 -99)",
    },
    element("circle", { class: "hit", r: 13 }),
    active.length > 2 ? element("circle", { class: "many", r: 8.5 }) : null,
    element("circle", { class: "dot", r: here === index ? 7 : 5 }));
  }));
}

/**
 * The line on which the objective has its greatest value, and the face where the set touches it.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 * @param {ScreenMap} map
 */
function supportLine(state, answer, map) {
  if (state.tab !== "objective" || state.objective.every((value) => value.isZero())) return element("g");
  const reach = reachShown(state, answer);
  if (reach === null || "ray" in reach) return element("g");
  const ends = lineInView(PLANE_FRAME.halfPlane(state.objective, reach.value), map.view);
  const far = reach.direction?.map(coordinate) ?? null;
  const points = reach.face.map((theta) => theta.map(coordinate));
  const size = (map.view.x[1] - map.view.x[0]) * 4;
  const length = far === null ? 1 : Math.hypot(far[0], far[1]);
  const along = far === null ? [] : points.slice(0, 1).map(([x, y]) => [x + (far[0] / length) * size, y + (far[1] / length) * size]);
  return element("g", { "aria-hidden": "true" },
    ends === null ? null : element("path", { id: "support-line", d: pathThrough(map, ends, false) }),
    element("path", { id: "optimal-face", d: pathThrough(map, [...points, ...along], false) }),
    points.map((place) => {
      const [x, y] = map.to(place);
      return element("circle", { class: "optimal", cx: round(x), cy: round(y), r: 9 });
    }),
  );
}

/**
 * The normal cone of each corner: the objectives that are greatest there. That of an optimal corner is larger.
 * @param {PolytopeData} answer
 * @param {PolytopeState} state
 * @param {ScreenMap} map
 */
function normalCones(answer, state, map) {
  const reach = reachShown(state, answer);
  const best = reach !== null && !("ray" in reach) ? reach.face : [];
  return element("g", { "aria-hidden": "true", id: "normal-cones" }, (answer.set?.vertices ?? []).map(({ theta, cone }) => {
    const own = exactPair(theta);
    const [x, y] = map.to(own.map(coordinate));
    const isBest = best.some((point) => point.every((value, k) => value.equals(own[k])));
    const radius = isBest ? LARGE_CONE : SMALL_CONE;
    const name = `cone${isBest ? " best" : ""}`;
    if (cone.kind === "plane") return element("circle", { class: name, cx: round(x), cy: round(y), r: radius });
    const [from, to] = cone.generators.map((generator) => {
      const [dx, dy] = exactPair(generator).map(coordinate);
      const length = Math.hypot(dx, dy) || 1;
      return [round(x + (radius * dx) / length), round(y - (radius * dy) / length)];
    });
    // Counter-clockwise on paper is sweep 0 on a screen, and no wedge is more than half a turn.
    return element("path", { class: name, d: `M${round(x)} ${round(y)}L${from.join(" ")}A${radius} ${radius} 0 0 0 ${to.join(" ")}Z` });
  }));
}

/**
 * The tip of the arrow of an objective, relative to its start, in pixels.
 * @param {Pair} objective
 */
export function arrowTip(objective) {
  const [x, y] = objective.map(coordinate);
  const length = Math.hypot(x, y) || 1;
  const long = Math.min(LONGEST_ARROW, Math.max(SHORTEST_ARROW, length * PIXELS_PER_UNIT));
  return [(x / length) * long, (-y / length) * long];
}

/**
 * @param {PolytopeState} state
 * @param {Place} anchor
 */
function objectiveArrow(state, anchor) {
  const isZero = state.objective.every((value) => value.isZero());
  const [dx, dy] = arrowTip(state.objective);
  return element("g", {
    id: "objective-arrow", class: "objective-arrow", role: "button", tabindex: 0, transform: `translate(${round(anchor[0])} ${round(anchor[1])})`,
    "aria-label": t("polytope.arrow", { form: formText(state.objective) }),
    "data-c1": state.objective[0].toString(), "data-c2": state.objective[1].toString(),
  },
  element("circle", { class: "hit", cx: isZero ? 0 : round(dx), cy: isZero ? 0 : round(dy), r: 20 }),
  isZero ? element("circle", { class: "tail", r: 7 }) : element("path", { class: "shaft", d: `M0 0L${round(dx)} ${round(dy)}`, "marker-end": "url(#arrow-head)" }),
  element("circle", { class: "tail", r: 3 }),
  element("text", { x: round(dx * 1.15), y: round(dy * 1.15 + 5), "text-anchor": dx < -8 ? "end" : dx > 8 ? "start" : "middle" }, "c"));
}

/**
 * The way of the simplex method so far, and the next step of it.
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 * @param {ScreenMap} map
 */
function simplexWay(state, answer, map) {
  const bases = shownBases(state, answer);
  const last = bases[bases.length - 1];
  if (last === undefined) return element("g");
  const places = bases.map(({ theta }) => map.to(exactPair(theta).map(coordinate)));
  const steps = places.slice(1).map((to, k) => {
    const from = places[k];
    if (Math.hypot(to[0] - from[0], to[1] - from[1]) < 1) return null;
    return element("path", { class: "walked", d: `M${from.map(round).join(" ")}L${to.map(round).join(" ")}`, "marker-end": "url(#arrow-head)" });
  });
  const ray = last.pivot !== null && last.pivot.entering === null ? exactPair(last.pivot.direction).map(coordinate) : null;
  const size = map.view.x[1] - map.view.x[0];
  const [x, y] = exactPair(last.theta).map(coordinate);
  const away = ray === null ? null : Math.hypot(ray[0], ray[1]);
  return element("g", { "aria-hidden": "true", id: "simplex-path" }, steps,
    ray === null || away === null ? null : element("path", { class: "walked endless", d: pathThrough(map, [[x, y], [x + (ray[0] / away) * size, y + (ray[1] / away) * size]], false) }));
}

/**
 * Two places on the line that is chosen, by which it can be turned.
 * @param {PolytopeState} state
 * @param {PolytopeData | null} answer
 * @param {ScreenMap} map
 */
function turningPlaces(state, answer, map) {
  if (answer === null || state.chosen === null || shownExercise(state) !== null || state.tab !== "set") return element("g");
  if (answer.half_planes[state.chosen] === undefined) return element("g");
  const line = lineOf(answer, state.chosen);
  const ends = line.a.every((value) => value === 0) ? null : lineInView(line, map.view);
  if (ends === null) return element("g");
  const [from, to] = ends.map(map.to);
  return element("g", { "aria-hidden": "true" }, [0.22, 0.78].map((share, end) =>
    element("circle", { class: "turning", "data-turn": end, cx: round(from[0] + share * (to[0] - from[0])), cy: round(from[1] + share * (to[1] - from[1])), r: 9 })));
}
