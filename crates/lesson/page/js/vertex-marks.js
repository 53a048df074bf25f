// What can be pointed at in the parameter plane: the vertices and the free point.

import { element } from "./dom.js";
import { round } from "./axes.js";
import { activeAt } from "./model.js";
import { boundText, enumeration, vertexName } from "./format.js";

/** The vertices of the region shown, each a button of its own. */
export function vertexMarks(lesson, state, scene, map, focused) {
  const chosen = state.hover ?? state.selection;
  const born = new Set(scene.current?.born ?? []);
  const bornPlaces = [...born].map((index) => lesson.points[index]);
  const middlePlace = scene.places.reduce(
    (sum, p) => [sum[0] + p[0] / scene.places.length, sum[1] + p[1] / scene.places.length],
    [0, 0],
  );
  const centre = map.to(middlePlace);
  const lettered = [];
  return scene.places.map((place, index) => {
    const [x, y] = map.to(place);
    const { theta } = scene.region.vertices[index];
    const shown =
      x >= map.area.left - 1 &&
      x <= map.area.left + map.area.width + 1 &&
      y >= map.area.top - 1 &&
      y <= map.area.top + map.area.height + 1;
    const isNew = bornPlaces.some((point) => point[0].equals(theta[0]) && point[1].equals(theta[1]));
    const isChosen = chosen?.kind === "vertex" && chosen.index === index;
    const length = Math.hypot(x - centre[0], y - centre[1]) || 1;
    const offset =
      scene.places.length === 1
        ? [14, -8]
        : [((x - centre[0]) / length) * 16, ((y - centre[1]) / length) * 16 + 5];
    // Letters that would cover each other say nothing.
    const free = isChosen || lettered.every(([px, py]) => Math.hypot(px - x, py - y) > 15);
    if (free && shown) lettered.push([x, y]);
    const active = enumeration(activeAt(lesson, scene.region, index).map(boundText));
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
      free
        ? element(
            "text",
            { class: "letter", x: round(offset[0]), y: round(offset[1]), "text-anchor": "middle" },
            vertexName(index),
          )
        : null,
    );
  });
}

/** The free point, under the pointer or chosen. */
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
