// @ts-check
// The drawing area of a picture with its axes, and the marks both planes share.

import { element } from "../dom.js";
import { axisTicks } from "./ticks.js";

// The style sheet's, for measuring.
const AXIS_FONT = "600 13px";

/**
 * Room for tick labels and axis names.
 * @param {number} width
 * @param {number} height
 */
export function plotArea(width, height) {
  const left = width < 480 ? 52 : 58;
  return { left, top: 30, width: width - left - 14, height: height - 30 - 46 };
}

/**
 * Grid, tick labels and axis names.
 * @param {ScreenMap} map
 * @param {(axis: number, number: number) => Rational} exact
 * @param {(axis: number, value: Rational) => number} number
 * @param {string[]} names of the axes
 * @param {AxisMarks|null} given ticks for the first axis in place of round numbers
 */
export function axes(map, exact, number, names, given = null) {
  const { area, view } = map;
  const right = area.left + area.width;
  const bottom = area.top + area.height;
  const across = given ?? ticksOn(0, view.x, area.width / 85);
  const up = ticksOn(1, view.y, area.height / 55);
  /**
   * @param {number} axis
   * @param {number[]} range
   * @param {number} room
   */
  function ticksOn(axis, range, room) {
    const { ticks, note } = axisTicks(
      exact(axis, range[0]),
      exact(axis, range[1]),
      Math.max(2, Math.round(room)),
    );
    return { marks: ticks.map(({ value, label }) => ({ at: number(axis, value), label })), note };
  }
  const vertical = across.marks.map(({ at, label }) => {
    const x = round(map.to([at, 0])[0]);
    return [
      element("path", { class: "grid", d: `M${x} ${area.top}V${bottom}` }),
      element("text", { class: "tick", x, y: bottom + 17, "text-anchor": "middle" }, label),
    ];
  });
  const horizontal = up.marks.map(({ at, label }) => {
    const y = round(map.to([0, at])[1]);
    return [
      element("path", { class: "grid", d: `M${area.left} ${y}H${right}` }),
      element("text", { class: "tick", x: area.left - 6, y: y + 4, "text-anchor": "end" }, label),
    ];
  });
  const room = area.left + area.width - 4;
  return element(
    "g",
    { "aria-hidden": "true" },
    vertical,
    horizontal,
    element("rect", { class: "frame", x: area.left, y: area.top, width: area.width, height: area.height }),
    element(
      "text",
      { class: "axis", x: right, y: bottom + 38, "text-anchor": "end" },
      titled(names[0], across.note, room),
    ),
    element("text", { class: "axis", x: 4, y: 18 }, titled(names[1], up.note, room)),
  );
}

/**
 * The name of an axis and the note on its ticks; a name that does not fit into so many pixels is cut.
 * @param {string} name
 * @param {string} note
 * @param {number} room
 */
function titled(name, note, room) {
  /** @param {number} count */
  const text = (count) =>
    `${count < name.length ? `${name.slice(0, count).trimEnd()}…` : name}  ${note}`;
  let count = name.length;
  while (count > 1 && textWidth(text(count)) > room)
    count = Math.min(count - 1, Math.ceil((count * room) / textWidth(text(count))));
  return text(count);
}

/** @type {CanvasRenderingContext2D | null} */
let ruler = null;

/**
 * The width of a text in the letters of the pictures.
 * @param {string} text
 */
export function textWidth(text) {
  if (ruler === null) {
    ruler = /** @type {CanvasRenderingContext2D} */ (document.createElement("canvas").getContext("2d"));
    ruler.font = `${AXIS_FONT} ${getComputedStyle(document.body).fontFamily}`;
  }
  return ruler.measureText(text).width;
}

/**
 * A pixel coordinate with two decimals.
 * @param {number} value
 */
export function round(value) {
  return Math.round(value * 100) / 100;
}

/**
 * The path through points in frame coordinates.
 * @param {ScreenMap} map
 * @param {Place[]} points
 * @param {boolean} closed
 */
export function pathThrough(map, points, closed) {
  if (points.length === 0) return "";
  return `M${points.map((point) => map.to(point).map(round).join(" ")).join("L")}${closed ? "Z" : ""}`;
}

const SHAPES = {
  cross: "M-5-5L5 5M-5 5L5-5",
  plus: "M-7 0H7M0-7V7",
  diamond: "M0-6L6 0L0 6L-6 0Z",
  triangle: "M0-6L6 5H-6Z",
  square: "M-5-5H5V5H-5Z",
  ring: "M-6 0A6 6 0 1 1 6 0A6 6 0 1 1-6 0Z",
  "upper-end": "M-5-7H5L0 0Z",
  "lower-end": "M-5 7H5L0 0Z",
};

/**
 * A mark of one of the shapes at a pixel position.
 * @param {Shape} shape
 * @param {Place} point
 * @param {Attributes} attributes
 */
export function mark(shape, [x, y], attributes) {
  return element("path", {
    ...attributes,
    d: SHAPES[shape],
    transform: `translate(${round(x)} ${round(y)})`,
  });
}
