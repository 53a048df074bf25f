// @ts-check
// The data plane: readings with their error bars, the corridor of all feasible lines, and the lines of parameters.
// With two regressors there is no line to draw: the row number runs along, and predictions stand in the bars.

import { byId, element, patch } from "../dom.js";
import { axes, mark, pathThrough, plotArea, round } from "./axes.js";
import { screenMap } from "./view.js";
import { automaticDataView, dataFrame } from "./data-frame.js";
import { bounded, boxEnvelopes, corridorPath, curvePath } from "./corridor.js";
import { endLabels } from "./end-labels.js";
import { worstLines } from "./worst-lines.js";
import { activeAt, boundAt, readingOfRow } from "../model/lesson.js";
import { nameOfX, plain, withUnit } from "../model/format.js";
import { ONE } from "../model/rational.js";
import { said, t } from "../texts.js";

/** How far a bar goes on where nothing bounds it, in pixels. */
const OPEN_END = 28;

/**
 * Draws the data plane. @returns {ScreenMap}
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 * @param {Layer[]} layers
 * @param {Size} size
 * @param {number} focused
 */
export function drawDataPlane(lesson, state, scene, layers, size, focused) {
  const frame = dataFrame(lesson, state.residual);
  const view = state.dataView ?? automaticDataView(lesson, frame, scene.s);
  const map = screenMap(view, plotArea(size.width, size.height));
  const { x, y } = columnNames(lesson);
  const heightName =
    state.residual && lesson.reference !== null ? t(`height.${lesson.reference.name}`, { y }) : y;
  const rows = lesson.isLine ? null : rowTicks(lesson, map);
  const { left, top, width, height } = map.area;
  patch(byId("data-plane"), [
    element(
      "title",
      { id: "data-plane-title" },
      t("data-plane.readings", { count: lesson.readings.length }),
    ),
    element(
      "defs",
      {},
      element("clipPath", { id: "data-clip" }, element("rect", { x: left, y: top, width, height })),
    ),
    axes(map, frame.exact, frame.number, [x, heightName], rows),
    element(
      "g",
      { "clip-path": "url(#data-clip)", "aria-hidden": "true" },
      boxEnvelopes(layers, state, frame, map),
      element("path", { class: "corridor", d: corridorPath(lesson, state, scene, frame, map) }),
      lesson.others.map((other) => otherReading(lesson, other, frame, map)),
      estimateLines(lesson, state, layers, frame, map),
    ),
    element(
      "g",
      { "clip-path": "url(#data-clip)", role: "group", "aria-label": t("readings.title"), id: "readings-drawn" },
      lesson.readings.map((reading) => drawnReading(lesson, state, scene, reading, frame, map, focused)),
    ),
    element(
      "g",
      { "clip-path": "url(#data-clip)", "aria-hidden": "true" },
      chosenLine(lesson, state, scene, frame, map),
    ),
    worstLines(lesson, state, frame, map),
  ]);
  byId("data-plane").setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
  return map;
}

/** @param {Lesson} lesson */
function columnNames(lesson) {
  const { model, units } = lesson.data;
  return { x: model.kind === "line" ? withUnit(nameOfX(lesson.data), units.x) : t("readings.row"), y: withUnit(model.y, units.y) };
}

/**
 * @param {Lesson} lesson
 * @param {ScreenMap} map
 */
function rowTicks(lesson, map) {
  const every = Math.max(1, Math.ceil(lesson.readings.length / (map.area.width / 40)));
  const marks = lesson.readings
    .filter((r) => r.index % every === 0)
    .map((r) => ({ at: r.index, label: `${r.row}` }));
  return { marks: marks.filter(({ at }) => at >= map.view.x[0] && at <= map.view.x[1]), note: "" };
}

/**
 * @param {Lesson} lesson
 * @param {OtherReading} other
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
function otherReading(lesson, other, frame, map) {
  if (!lesson.isLine) return null;
  const place = [frame.number(0, other.phi[0]), bounded(frame.height(other.phi, other.y), map)];
  const [x, y] = map.to(place);
  return element("circle", { class: "other", cx: round(x), cy: round(y), r: 2.5 });
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Layer[]} layers
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
function estimateLines(lesson, state, layers, frame, map) {
  const lines = layers
    .filter(
      (layer) =>
        layer.id !== "lp" &&
        layer.points.length === 1 &&
        (layer.id === "least-squares" || state.layers.has(layer.id)),
    )
    .map((layer) =>
      element("path", {
        class: `curve layer-${layer.id}`,
        d: curvePath(lesson, layer.points[0], frame, map),
      }),
    );
  return element("g", {}, lines);
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 */
function chosenLine(lesson, state, scene, frame, map) {
  const chosen = state.hover ?? state.selection;
  if (chosen?.kind === "point")
    return element("path", { class: "curve of-point", d: curvePath(lesson, chosen.theta, frame, map) });
  if (chosen?.kind !== "vertex" || chosen.index >= scene.region.vertices.length) return element("path");
  const { theta } = scene.region.vertices[chosen.index];
  const ends = activeAt(lesson, scene.region, chosen.index).flatMap(({ row, bound: name }) => {
    if (row === null) return [];
    const bound = /** @type {"upper" | "lower"} */ (name === "upper" ? "upper" : "lower");
    const reading = readingOfRow(lesson, row);
    const end = boundAt(reading, bound, scene.s) ?? reading.y;
    const place = map.to([frame.across(reading), frame.height(reading.phi, end)]);
    return [{ place, bound, text: t("data-plane.end", { row }) }];
  });
  const labels = endLabels(ends, map.area).map(({ text, x, y, anchor }) =>
    element("text", { class: "end-label", x: round(x), y: round(y), "text-anchor": anchor }, text),
  );
  return element(
    "g",
    {},
    element("path", { class: "curve of-vertex", d: curvePath(lesson, theta, frame, map) }),
    ends.map(({ place }) => mark("ring", place, { class: "active-end" })),
    labels,
  );
}

/**
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 * @param {Reading} reading
 * @param {DataFrame} frame
 * @param {ScreenMap} map
 * @param {number} focused
 */
function drawnReading(lesson, state, scene, reading, frame, map, focused) {
  const chosen = state.hover ?? state.selection;
  const u = frame.across(reading);
  const v = frame.height(reading.phi, reading.y);
  const [x, y] = map.to([u, v]);
  const ends = { upper: boundAt(reading, "upper", scene.s), lower: boundAt(reading, "lower", scene.s) };
  const place = (/** @type {Rational | null} */ end, /** @type {number} */ open) =>
    end === null ? open : map.to([u, frame.height(reading.phi, end)])[1];
  // A bar goes on a little where nothing bounds it, and ends in an arrow there.
  const top = place(ends.upper, place(ends.lower, y) - OPEN_END);
  const bottom = place(ends.lower, place(ends.upper, y) + OPEN_END);
  const used = readingUse(scene, reading);
  const classes = ["reading"];
  if (!used.shaping) classes.push("idle");
  if (used.off) classes.push("off");
  if (used.current) classes.push("current");
  if (chosen?.kind === "reading" && chosen.row === reading.row) classes.push("chosen");
  if (chosen?.kind === "point") {
    if (chosen.violated?.has(reading.row)) classes.push("violated");
    if (chosen.near !== undefined && lesson.halfPlanes[chosen.near].reading === reading) classes.push("chosen");
  }
  const name = lesson.isLine ? nameOfX(lesson.data) : t("readings.row");
  const abscissa = lesson.isLine ? plain(reading.phi[0], lesson.widths.phi[0]) : `${reading.row}`;
  return element(
    "g",
    {
      class: classes.join(" "),
      "data-reading": reading.row,
      role: "button",
      tabindex: reading.index === Math.min(focused, lesson.readings.length - 1) ? 0 : -1,
      "aria-pressed": `${state.selection?.kind === "reading" && state.selection.row === reading.row}`,
      "aria-label": t("data-plane.spoken", { row: reading.row, name, abscissa, bounds: spokenBounds(lesson, reading) }),
    },
    element("rect", {
      class: "hit",
      x: round(x - 9),
      y: round(Math.min(top, y - 9)),
      width: 18,
      height: round(Math.max(bottom - top, 18)),
    }),
    element("path", {
      class: "bar",
      d: `M${round(x)} ${round(top)}V${round(bottom)}${cap(x, top, ends.upper === null ? 5 : 0)}${cap(x, bottom, ends.lower === null ? -5 : 0)}`,
    }),
    end(lesson, scene, reading, "upper", [x, top]),
    end(lesson, scene, reading, "lower", [x, bottom]),
    hasDot(reading) ? element("circle", { class: "dot", cx: round(x), cy: round(y), r: 3.2 }) : element("path"),
  );
}

/**
 * The end of a bar: a stroke across, or an arrow head that comes back by so much.
 * @param {number} x
 * @param {number} y
 * @param {number} back
 */
function cap(x, y, back) {
  return `M${round(x - 4)} ${round(y + back)}L${round(x)} ${round(y)}L${round(x + 4)} ${round(y + back)}`;
}

/**
 * Bounds without a y have nothing between them to be marked.
 * @param {Reading} reading
 */
function hasDot(reading) {
  if (reading.fixed === null) return true;
  return ![reading.fixed.upper, reading.fixed.lower].some((end) => end?.equals(reading.y));
}

/**
 * @param {Lesson} lesson
 * @param {Reading} reading
 */
function spokenBounds(lesson, reading) {
  const { y } = lesson.data.model;
  if (reading.fixed === null && reading.middle.equals(reading.y))
    return `${y} = ${plain(reading.y, lesson.widths.y)} ± ${plain(reading.epsilon)}`;
  const [upper, lower] = [boundAt(reading, "upper", ONE), boundAt(reading, "lower", ONE)];
  const words = [lower === null ? [] : [t("data-plane.at-least", { end: plain(lower, lesson.widths.y) })], upper === null ? [] : [t("data-plane.at-most", { end: plain(upper, lesson.widths.y) })]];
  return said({ list: words.flat() });
}

/**
 * @param {Scene} scene
 * @param {Reading} reading
 */
function readingUse(scene, reading) {
  const { among } = scene;
  const bounds = [reading.halfPlanes.upper, reading.halfPlanes.lower].filter((index) => index !== null);
  return {
    off: scene.region.without.includes(reading.row) || (among !== null && !bounds.some((index) => among.has(index))),
    shaping: bounds.some((index) => scene.shaping.has(index)),
    current: scene.current !== null && bounds.includes(scene.current.half_plane),
  };
}

/**
 * An end that shapes the region has the triangle that the lists use for its name.
 * @param {Lesson} lesson
 * @param {Scene} scene
 * @param {Reading} reading
 * @param {"upper" | "lower"} bound
 * @param {Place} place
 */
function end(lesson, scene, reading, bound, place) {
  const index = reading.halfPlanes[bound];
  if (index === null || !scene.shaping.has(index)) return element("path");
  return mark(`${bound}-end`, place, { class: `end ${bound}` });
}
