// @ts-check
// The names of readings at the ends of their bars: each where it covers no other one.

import { textWidth } from "./axes.js";

/** From an end to the base line of its name, beyond the end of the bar. */
const NAME_BASE = { upper: -14, lower: 22 };
/** Letters of 13 pixels above and below their base line, with a little room. */
const NAME_ABOVE = 13;
const NAME_BELOW = 5;
const NAME_ROOM = 4;
/** A name that begins or ends at its bar covers the width of the mark. */
const NAME_ASIDE = 6;
/** Names as near to an edge of the picture begin or end at their bars. */
const NAME_EDGE = 40;

/**
 * The names with their places; one that is free nowhere near its end is left out.
 * @param {{ place: Place, bound: "upper" | "lower", text: string }[]} ends
 * @param {{ left: number, width: number }} area
 * @returns {{ text: string, x: number, y: number, anchor: "start" | "middle" | "end" }[]}
 */
export function endLabels(ends, area) {
  /** @type {number[][]} */
  const taken = [];
  return ends.flatMap(({ place: [x, y], bound, text }) => {
    const width = textWidth(text);
    const usual = x > area.left + area.width - NAME_EDGE ? "end" : x < area.left + NAME_EDGE ? "start" : "middle";
    const sides = /** @type {const} */ ([bound, bound === "upper" ? "lower" : "upper"]);
    const anchors = /** @type {const} */ ([usual, "start", "end"]);
    const tried = sides.flatMap((side) => anchors.map((anchor) => {
      const at = anchor === usual ? x : anchor === "start" ? x - NAME_ASIDE : x + NAME_ASIDE;
      const left = anchor === "start" ? at : anchor === "end" ? at - width : at - width / 2;
      const base = y + NAME_BASE[side];
      return { label: { text, x: at, y: base, anchor }, box: [left - NAME_ROOM, left + width + NAME_ROOM, base - NAME_ABOVE, base + NAME_BELOW] };
    }));
    const free = tried.find(({ box }) =>
      box[0] >= area.left - NAME_EDGE && box[1] <= area.left + area.width + NAME_EDGE &&
      taken.every((other) => box[1] <= other[0] || other[1] <= box[0] || box[3] <= other[2] || other[3] <= box[2]));
    if (free === undefined) return [];
    taken.push(free.box);
    return [free.label];
  });
}
