// @ts-check
// What can be pointed at in the parameter plane: the vertices and the free point.

import { element } from "../dom.js";
import { round } from "./axes.js";
import { activeAt } from "../model/lesson.js";
import { boundText, shortEnumeration, vertexName, vertexNames } from "../model/format.js";

const NEAREST_LABELS = 24;
const LABEL_DISTANCE = 16;
const DIGIT_WIDTH = 8;
const BASELINE = 5;
// Labels stand beside marks rather than above or below them when the way out is mostly to a side.
const SIDEWAYS = 0.7;

/**
 * The vertices of the region shown, each a button of its own.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 * @param {ScreenMap} map
 * @param {number} focused
 */
export function vertexMarks(lesson, state, scene, map, focused) {
  const chosen = state.hover ?? state.selection;
  const born = new Set(scene.current?.born ?? []);
  const bornPlaces = [...born].map((index) => lesson.points[index]);
  return scene.places.map((place, index) => {
    const [x, y] = map.to(place);
    const { theta } = scene.region.vertices[index];
    const shown = isInside([x, y], map.area);
    const isNew = bornPlaces.some((point) => point[0].equals(theta[0]) && point[1].equals(theta[1]));
    const isChosen = chosen?.kind === "vertex" && chosen.index === index;
    const active = shortEnumeration(activeAt(lesson, scene.region, index).map(boundText));
    return element(
      "g",
      {
        class: ["vertex", isNew && "born", isChosen && "chosen", !shown && "outside"]
          .filter(Boolean)
          .join(" "),
        "data-vertex": index,
        "data-theta1": theta[0].toString(),
        "data-theta2": theta[1].toString(),
        role: "button",
        tabindex: index === Math.min(focused, scene.places.length - 1) ? 0 : -1,
        "aria-pressed": `${state.selection?.kind === "vertex" && state.selection.index === index}`,
        "aria-label": `Vertex ${vertexName(index)}: θ₁ = ${theta[0]}, θ₂ = ${theta[1]}; active: ${active}`,
        transform: shown ? `translate(${round(x)} ${round(y)})` : "translate(-99 -99)",
      },
      element("circle", { class: "hit", r: 13 }),
      element("circle", { class: "dot", r: isChosen ? 7 : 5 }),
    );
  });
}

/**
 * @param {Place} point
 * @param {Area} area
 */
function isInside([x, y], { left, top, width, height }) {
  return x >= left - 1 && x <= left + width + 1 && y >= top - 1 && y <= top + height + 1;
}

/**
 * The numbers beside the vertices.
 * @param {State} state
 * @param {Scene} scene
 * @param {ScreenMap} map
 */
export function vertexNumbers(state, scene, map) {
  const chosen = state.hover ?? state.selection;
  const pixels = scene.places.map(map.to);
  /** @param {number} axis */
  const share = (axis) => pixels.reduce((sum, pixel) => sum + pixel[axis] / pixels.length, 0);
  const centre = [share(0), share(1)];
  return labelGroups(pixels, map.area).map((group) => {
    const isChosen = chosen?.kind === "vertex" && group.includes(chosen.index);
    return element(
      "text",
      { class: `vertex-number${isChosen ? " chosen" : ""}`, ...besideGroup(group, pixels, centre, map.area) },
      vertexNames(group),
    );
  });
}

/**
 * The vertices in view, in groups that share a label: labels that cover each other say nothing.
 * @param {Place[]} pixels
 * @param {Area} area
 */
function labelGroups(pixels, area) {
  /** @type {number[][]} */
  const groups = [];
  pixels.forEach(([x, y], index) => {
    if (!isInside([x, y], area)) return;
    const near = groups.find((group) =>
      group.some((other) => Math.hypot(pixels[other][0] - x, pixels[other][1] - y) <= NEAREST_LABELS),
    );
    if (near === undefined) groups.push([index]);
    else near.push(index);
  });
  return groups;
}

/**
 * Where the label of a group stands: on the outer side of the set, clear of the group's marks.
 * @param {number[]} group
 * @param {Place[]} pixels
 * @param {Place} centre
 * @param {Area} area
 */
function besideGroup(group, pixels, centre, { left, width }) {
  const [xs, ys] = [0, 1].map((axis) => group.map((index) => pixels[index][axis]));
  const middle = [xs, ys].map((values) => values.reduce((sum, value) => sum + value, 0) / values.length);
  const away = pixels.length === 1 ? [1, -1] : [middle[0] - centre[0], middle[1] - centre[1]];
  const length = Math.hypot(...away) || 1;
  const [dx, dy] = away.map((value) => value / length);
  const beside = middle[1] + dy * LABEL_DISTANCE + BASELINE;
  const right = Math.max(...xs) + LABEL_DISTANCE / 2;
  const isRoom = right + DIGIT_WIDTH * vertexNames(group).length < left + width;
  /**
   * @param {number} x
   * @param {number} y
   * @param {string} anchor
   */
  const place = (x, y, anchor) => ({ x: round(x), y: round(y), "text-anchor": anchor });
  if (dx > SIDEWAYS && isRoom) return place(right, beside, "start");
  if (dx < -SIDEWAYS) return place(Math.min(...xs) - LABEL_DISTANCE / 2, beside, "end");
  if (group.length === 1) return place(middle[0] + dx * LABEL_DISTANCE, beside, "middle");
  const edge = dy < 0 ? Math.min(...ys) - LABEL_DISTANCE : Math.max(...ys) + LABEL_DISTANCE;
  return place(middle[0], edge + BASELINE, "middle");
}

/**
 * The free point, under the pointer or chosen.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {Scene} scene
 * @param {ScreenMap} map
 */
export function chosenPoint(lesson, state, scene, map) {
  const chosen = [state.hover, state.selection].find((choice) => choice?.kind === "point");
  if (chosen === undefined) return element("g");
  const [x, y] = map.to(scene.frame.place(chosen.theta));
  return element(
    "g",
    {
      id: "theta-point",
      class: "theta-point",
      role: "button",
      tabindex: 0,
      transform: `translate(${round(x)} ${round(y)})`,
      "data-theta1": chosen.theta[0].toString(),
      "data-theta2": chosen.theta[1].toString(),
      "aria-label": "Chosen parameter point. Arrow keys move it, with Shift in larger steps.",
    },
    element("circle", { class: "hit", r: 16 }),
    element("path", { class: "hair", d: "M-14 0H14M0-14V14" }),
    element("circle", { class: "dot", r: 5 }),
  );
}
