// @ts-check
// What can be pointed at in the parameter plane: the vertices and the free point.

import { element } from "../dom.js";
import { round } from "./axes.js";
import { activeAt } from "../model/lesson.js";
import { boundText, shortEnumeration, vertexName, vertexNames } from "../model/format.js";
import { t } from "../texts.js";

const DIGIT_WIDTH = 8.5;
const HALF_HEIGHT = 7;
const BASELINE = 5;
/** What a mark takes, with its outline. */
const MARK_RADIUS = 6.5;
/** How far labels stand from their marks, and how they turn away from the way out. */
const DISTANCES = [7, 13, 22, 36];
const TURNS = [0, 0.4, -0.4, 0.8, -0.8, 1.25, -1.25, 1.75, -1.75, 2.4, -2.4, Math.PI];
/** After so many attempts labels without room are left out. */
const MOST_ROUNDS = 40;

/** @typedef {{ left: number, right: number, top: number, bottom: number }} Box */

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
        "aria-label": t("vertex.spoken", { vertex: vertexName(index), first: `${theta[0]}`, second: `${theta[1]}`, active }),
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
 * The numbers beside the vertices, each where it covers no mark and no other number. Vertices whose marks cover each other share
 * a number's place; so do, where there is no room at all, neighbours.
 * @param {State} state
 * @param {Scene} scene
 * @param {ScreenMap} map
 * @param {Place[]} marks what else is marked, in pixels
 */
export function vertexNumbers(state, scene, map, marks) {
  const chosen = state.hover ?? state.selection;
  const pixels = scene.places.map(map.to);
  /** @param {number} axis */
  const share = (axis) => pixels.reduce((sum, pixel) => sum + pixel[axis] / pixels.length, 0);
  const centre = [share(0), share(1)];
  const seen = pixels.flatMap((pixel, index) => (isInside(pixel, map.area) ? [index] : []));
  const obstacles = [...seen.map((index) => pixels[index]), ...marks].map(([x, y]) => around(x, y, MARK_RADIUS, MARK_RADIUS));
  let groups = together(seen, pixels);
  let labels = placedLabels(groups, pixels, centre, obstacles, map.area);
  for (let attempt = 0; labels.includes(null) && groups.length > 1 && attempt < MOST_ROUNDS; attempt += 1) {
    groups = withNeighbour(groups, labels.indexOf(null), pixels);
    labels = placedLabels(groups, pixels, centre, obstacles, map.area);
  }
  return groups.flatMap((group, k) => {
    const label = labels[k];
    if (label === null) return [];
    const isChosen = chosen?.kind === "vertex" && group.includes(chosen.index);
    const middle = { x: round((label.left + label.right) / 2), y: round((label.top + label.bottom) / 2 + BASELINE) };
    return [
      element(
        "text",
        { class: `vertex-number${isChosen ? " chosen" : ""}`, ...middle, "text-anchor": "middle" },
        vertexNames(group),
      ),
    ];
  });
}

/**
 * A box around a point.
 * @param {number} x
 * @param {number} y
 * @param {number} halfWidth
 * @param {number} halfHeight
 * @returns {Box}
 */
function around(x, y, halfWidth, halfHeight) {
  return { left: x - halfWidth, right: x + halfWidth, top: y - halfHeight, bottom: y + halfHeight };
}

/**
 * @param {Box} one
 * @param {Box} other
 */
function overlap(one, other) {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}

/**
 * The vertices in view, in groups whose marks cover each other.
 * @param {number[]} seen
 * @param {Place[]} pixels
 */
function together(seen, pixels) {
  /** @type {number[][]} */
  const groups = [];
  for (const index of seen) {
    const [x, y] = pixels[index];
    const near = groups.find(([first]) => Math.hypot(pixels[first][0] - x, pixels[first][1] - y) <= 2 * MARK_RADIUS);
    if (near === undefined) groups.push([index]);
    else near.push(index);
  }
  return groups;
}

/**
 * The groups with one of them joined to the one that is nearest to it.
 * @param {number[][]} groups
 * @param {number} joined
 * @param {Place[]} pixels
 */
function withNeighbour(groups, joined, pixels) {
  /** @param {number[]} group */
  const distance = (group) =>
    Math.hypot(...[0, 1].map((axis) => pixels[group[0]][axis] - pixels[groups[joined][0]][axis]));
  const others = groups.filter((_, k) => k !== joined);
  const nearest = others.reduce((best, group) => (distance(group) < distance(best) ? group : best));
  return others.map((group) =>
    group === nearest ? [...group, ...groups[joined]].sort((p, q) => p - q) : group,
  );
}

/**
 * Where the label of each group stands; null where there is no room for it.
 * @param {number[][]} groups
 * @param {Place[]} pixels
 * @param {Place} centre
 * @param {Box[]} obstacles
 * @param {Area} area
 */
function placedLabels(groups, pixels, centre, obstacles, area) {
  /** @type {Box[]} */
  const taken = [...obstacles];
  return groups.map((group) => {
    const found = candidates(group, pixels, centre).find(
      (box) => fitsInto(box, area) && !taken.some((other) => overlap(box, other)),
    );
    if (found !== undefined) taken.push(found);
    return found ?? null;
  });
}

/**
 * The places for a label, best first: outwards from the set, then to the sides, then farther away.
 * @param {number[]} group
 * @param {Place[]} pixels
 * @param {Place} centre
 */
function candidates(group, pixels, centre) {
  const middle = [0, 1].map((axis) => group.reduce((sum, index) => sum + pixels[index][axis], 0) / group.length);
  const away = pixels.length === 1 ? [1, -1] : [middle[0] - centre[0], middle[1] - centre[1]];
  const straight = Math.atan2(away[1], away[0]);
  const halfWidth = (DIGIT_WIDTH * vertexNames(group).length) / 2 + 1;
  const spread = Math.max(...group.map((index) => Math.hypot(...[0, 1].map((axis) => pixels[index][axis] - middle[axis]))));
  return DISTANCES.flatMap((distance) =>
    TURNS.map((turn) => {
      const [dx, dy] = [Math.cos(straight + turn), Math.sin(straight + turn)];
      // Far enough for the whole box to be beyond the marks in this direction.
      const far = distance + spread + Math.abs(dx) * halfWidth + Math.abs(dy) * HALF_HEIGHT;
      return around(middle[0] + dx * far, middle[1] + dy * far, halfWidth, HALF_HEIGHT);
    }),
  );
}

/**
 * @param {Box} box
 * @param {Area} area
 */
function fitsInto(box, { left, top, width, height }) {
  return box.left >= left + 1 && box.right <= left + width - 1 && box.top >= top + 1 && box.bottom <= top + height - 1;
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
      "aria-label": t("point.spoken"),
    },
    element("circle", { class: "hit", r: 16 }),
    element("path", { class: "hair", d: "M-14 0H14M0-14V14" }),
    element("circle", { class: "dot", r: 5 }),
  );
}
