// @ts-check
// The parameter plane: half-planes with hatching on the side they forbid, the region, layers, and the chosen point.

import { byId, element, patch } from "../dom.js";
import { axes, mark, pathThrough, plotArea, round } from "./axes.js";
import { clipped, cornersInView, cornersOf, lineInView } from "./region.js";
import { activeAt, halfPlaneIndex } from "../model/lesson.js";
import { boundClass, decimal, digitsFor, kindText, nameOfX, thetaName, withUnit } from "../model/format.js";
import { t } from "../texts.js";
import { screenMap } from "./view.js";
import { automaticView } from "./parameter-view.js";
import { worstPoints } from "./worst-lines.js";
import { chosenPoint, vertexMarks, vertexNumbers } from "./vertex-marks.js";

/**
 * The names of the axes, with the meaning of the second one when it is straightened.
 * @param {Lesson} lesson
 * @param {ParameterFrame} frame
 */
function axisNames(lesson, frame) {
  const { model, units } = lesson.data;
  const plain = [0, 1].map((axis) => thetaName(lesson, axis));
  const slope = withUnit(t("axis.slope"), units.theta1);
  if (frame.shear.isZero()) return lesson.isLine ? [slope, withUnit(t("axis.intercept"), units.theta2)] : plain;
  const at = decimal(frame.shear, Math.max(6, digitsFor(frame.shear, lesson.widths.phi[0])));
  return model.kind === "line"
    ? [slope, withUnit(t("axis.height", { x: nameOfX(lesson.data), at }), units.y)]
    : [plain[0], withUnit(`θ₂ + ${at}·θ₁`, units.theta2)];
}

/**
 * Draws the parameter plane.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 * @param {Layer[]} layers
 * @param {Size} size
 * @param {number} focused
 * @returns {ScreenMap}, for what the pointer does
 */
export function drawParameterPlane(lesson, state, scene, layers, size, focused) {
  const { frame } = scene;
  const view = state.parameterView ?? automaticView(lesson, state, scene, layers);
  const map = screenMap(view, plotArea(size.width, size.height));
  /**
   * @param {number} axis
   * @param {number} number
   */
  const exact = (axis, number) => frame.axisValue(axis, number);
  /**
   * @param {number} axis
   * @param {Rational} value
   */
  const number = (axis, value) => frame.coordinate(axis, value);
  const chosen = state.hover ?? state.selection;
  const { left, top, width, height } = map.area;
  patch(byId("parameter-plane"), [
    element("title", { id: "parameter-plane-title" }, t("parameter-plane.set", { set: scene.summary })),
    definitions({ left, top, width, height }),
    axes(map, exact, number, axisNames(lesson, frame)),
    element(
      "g",
      { "clip-path": "url(#parameter-clip)", "aria-hidden": "true" },
      comparison(lesson, scene, state, map),
      element(
        "g",
        {},
        scene.lines.map((entry) => halfPlaneLine(entry, scene, chosen, map)),
      ),
      filled(lesson, scene.region, frame, map, "region"),
      cutOff(lesson, scene, map),
      strip(scene, chosen, map),
      currentLine(lesson, scene, map),
      layers.filter((layer) => state.layers.has(layer.id)).map((layer) => layerDrawing(layer, frame, map)),
    ),
    arrows(lesson, scene, map),
    element(
      "g",
      { role: "group", "aria-label": t("parameter-plane.vertices"), id: "vertices" },
      vertexMarks(lesson, state, scene, map, focused),
    ),
    element(
      "g",
      { "aria-hidden": "true", id: "vertex-numbers" },
      vertexNumbers(state, scene, map, layerMarks(layers, state, frame, map)),
    ),
    chosenPoint(lesson, state, scene, map),
    worstPoints(lesson, state, frame, map),
    emptyNote(scene, map),
  ]);
  const svg = byId("parameter-plane");
  svg.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
  svg.setAttribute("data-kind", scene.region.kind);
  return map;
}

/** @param {Area} area */
function definitions(area) {
  return element(
    "defs",
    {},
    element(
      "clipPath",
      { id: "parameter-clip" },
      element("rect", { x: area.left, y: area.top, width: area.width, height: area.height }),
    ),
    element(
      "pattern",
      { id: "hatch", width: 7, height: 7, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
      element("rect", { class: "hatch-ground", width: 7, height: 7 }),
      element("path", { class: "hatch-line", d: "M0 0V7" }),
    ),
  );
}

/**
 * @param {Lesson} lesson
 * @param {Region} region
 * @param {ParameterFrame} frame
 * @param {ScreenMap} map
 * @param {string} name
 */
function filled(lesson, region, frame, map, name) {
  const shown = cornersInView(cornersOf(lesson, region, frame, map.view), map.view);
  const points = shown.map((corner) => corner.point);
  return element(
    "g",
    {},
    element("path", { class: `${name} fill`, d: pathThrough(map, points, true) }),
    element("path", { class: `${name} edge`, d: edgesPath(shown, map) }),
  );
}

/**
 * The edges of a polygon cut to the view, without those that only the view has made.
 * @param {Corner[]} corners
 * @param {ScreenMap} map
 */
function edgesPath(corners, map) {
  /**
   * @param {Corner} corner
   * @param {number} k
   */
  const edge = (corner, k) => [corner.point, corners[(k + 1) % corners.length].point];
  return corners.map((corner, k) => (corner.cut ? "" : pathThrough(map, edge(corner, k), false))).join("");
}

/**
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {State} state
 * @param {ScreenMap} map
 */
function comparison(lesson, scene, state, map) {
  if (scene.before === null || state.mode === "clip") return element("g");
  return filled(lesson, scene.before, scene.frame, map, "former");
}

/**
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {ScreenMap} map
 */
function cutOff(lesson, scene, map) {
  const { current, before } = scene;
  if (current === null || before === null || current.redundant !== null) return element("path");
  const corners = cornersOf(lesson, before, scene.frame, map.view);
  const line = scene.lines.find((entry) => entry.halfPlane.index === current.half_plane)?.line;
  if (line === undefined) return element("path");
  const beyond = { a: line.a.map((value) => -value), b: -line.b };
  const shown = clipped(cornersInView(corners, map.view), beyond, true).map((corner) => corner.point);
  return element("path", { class: "cut-off", d: pathThrough(map, shown, true) });
}

/**
 * A line with ticks on the side that it forbids.
 * @param {Line} line
 * @param {ScreenMap} map
 * @param {Attributes} attributes
 */
function hatchedLine(line, map, attributes) {
  const ends = lineInView(line, map.view);
  if (ends === null) return element("g", attributes);
  const [from, to] = ends.map(map.to);
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
  // The forbidden side is on the right of the way from `from` to `to`: on the screen that is (−dy, dx).
  const [ox, oy] = [(-(to[1] - from[1]) / length) * 3.5, ((to[0] - from[0]) / length) * 3.5];
  /**
   * @param {number} dx
   * @param {number} dy
   */
  const path = (dx, dy) =>
    `M${round(from[0] + dx)} ${round(from[1] + dy)}L${round(to[0] + dx)} ${round(to[1] + dy)}`;
  return element(
    "g",
    attributes,
    element("path", { class: "ticks", d: path(ox, oy) }),
    element("path", { class: "line", d: path(0, 0) }),
  );
}

/**
 * @param {SceneLine} entry
 * @param {Scene} scene
 * @param {Choice | null} chosen
 * @param {ScreenMap} map
 */
function halfPlaneLine({ halfPlane, line }, scene, chosen, map) {
  const active =
    chosen?.kind === "vertex" && chosen.index < scene.places.length && chosen.active?.has(halfPlane.index);
  const classes = ["bound", boundClass(halfPlane.name)];
  if (!scene.shaping.has(halfPlane.index)) classes.push("redundant");
  if (active || (chosen?.kind === "reading" && chosen.row === halfPlane.name.row)) classes.push("chosen");
  if (chosen?.kind === "point" && chosen.near === halfPlane.index) classes.push("chosen");
  return hatchedLine(line, map, { class: classes.join(" "), "data-half-plane": halfPlane.index });
}

/**
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {ScreenMap} map
 */
function currentLine(lesson, scene, map) {
  const { current } = scene;
  if (current === null) return element("g");
  const entry = scene.lines.find(({ halfPlane }) => halfPlane.index === current.half_plane);
  return entry === undefined ? element("g") : hatchedLine(entry.line, map, { class: "bound current" });
}

/**
 * Between the two lines of a reading lie the parameters that this reading allows.
 * @param {Scene} scene
 * @param {Choice | null} chosen
 * @param {ScreenMap} map
 */
function strip(scene, chosen, map) {
  if (chosen?.kind !== "reading") return element("path");
  const sides = scene.lines.filter(({ halfPlane }) => halfPlane.name.row === chosen.row);
  if (sides.length === 0) return element("path");
  const { x, y } = map.view;
  const whole = [
    [x[0], y[0]],
    [x[1], y[0]],
    [x[1], y[1]],
    [x[0], y[1]],
  ].map((point) => ({ point, cut: true }));
  const shown = sides.reduce((corners, { line }) => clipped(corners, line, false), whole);
  return element("path", {
    class: "strip",
    d: pathThrough(
      map,
      shown.map((corner) => corner.point),
      true,
    ),
  });
}

/**
 * Where the layers that are shown have marks, in pixels.
 * @param {Layer[]} layers
 * @param {State} state
 * @param {ParameterFrame} frame
 * @param {ScreenMap} map
 */
function layerMarks(layers, state, frame, map) {
  return layers
    .filter(({ id, shape }) => shape !== null && state.layers.has(id))
    .flatMap(({ points }) => points.map((point) => map.to(frame.place(point))));
}

/**
 * @param {Layer} layer
 * @param {ParameterFrame} frame
 * @param {ScreenMap} map
 */
function layerDrawing(layer, frame, map) {
  const { shape } = layer;
  return element(
    "g",
    { class: `layer layer-${layer.id}`, "data-layer-shown": layer.id },
    layer.polygon === null
      ? null
      : element("path", {
          class: `outline layer-${layer.id}`,
          d: edgesPath(
            cornersInView(
              layer.polygon.map((p) => frame.place(p)),
              map.view,
            ),
            map,
          ),
        }),
    shape === null
      ? null
      : layer.points
          .map((point) => map.to(frame.place(point)))
          .map((place) => [
            mark(shape, place, { class: "halo" }),
            mark(shape, place, { class: `mark layer-${layer.id}` }),
          ]),
  );
}

/**
 * Where the view cuts the region, it goes on: an arrow says so.
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {ScreenMap} map
 */
function arrows(lesson, scene, map) {
  const shown = cornersInView(cornersOf(lesson, scene.region, scene.frame, map.view), map.view);
  if (shown.length < 2) return element("g");
  const drawn = shown.map((corner, k) => {
    if (!corner.cut) return null;
    const [p, q] = [corner.point, shown[(k + 1) % shown.length].point].map(map.to);
    if (Math.hypot(p[0] - q[0], p[1] - q[1]) < 1 && shown.length > 2) return null;
    const [x, y] = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
    const [dx, dy] = outward(x, y, map.area);
    const turn = (Math.atan2(dy, dx) * 180) / Math.PI;
    return element("path", {
      class: "goes-on",
      d: "M-20 0H-4M-10-5L-3 0L-10 5",
      transform: `translate(${round(x)} ${round(y)}) rotate(${turn})`,
    });
  });
  return element("g", { "aria-hidden": "true" }, drawn);
}

/**
 * @param {number} x
 * @param {number} y
 * @param {Area} area
 */
function outward(x, y, { left, top, width, height }) {
  const sides = [
    { distance: x - left, way: [-1, 0] },
    { distance: left + width - x, way: [1, 0] },
    { distance: y - top, way: [0, -1] },
    { distance: top + height - y, way: [0, 1] },
  ];
  return sides.sort((p, q) => p.distance - q.distance)[0].way;
}

/**
 * @param {Scene} scene
 * @param {ScreenMap} map
 */
function emptyNote(scene, map) {
  if (scene.region.kind !== "empty") return element("text");
  const { left, top, width } = map.area;
  return element(
    "text",
    { class: "note", x: left + width / 2, y: top + 26, "text-anchor": "middle" },
    kindText("empty", 0),
  );
}

/**
 * Indices of the half-planes active at the chosen vertex, for highlighting.
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {Choice | null} choice
 */
export function withActive(lesson, scene, choice) {
  if (choice?.kind !== "vertex" || choice.index >= scene.places.length) return choice;
  const names = activeAt(lesson, scene.region, choice.index);
  return { ...choice, active: new Set(names.map((name) => halfPlaneIndex(lesson, name))) };
}
