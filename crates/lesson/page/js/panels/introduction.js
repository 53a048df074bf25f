// @ts-check
// The parts of the text that depend on the data.

import { all, byId } from "../dom.js";
import { counted, enumeration, kindText, plain, shortEnumeration } from "../model/format.js";
import { Rational } from "../model/rational.js";

const LONGEST_IN_FORMULA = 14;

/**
 * Fills in titles, names of columns and the data set's own facts.
 * @param {Lesson} lesson
 */
export function fillIntroduction(lesson) {
  const { data } = lesson;
  const { model, epsilon } = data;
  /** @type {Record<string, string>} */
  const names =
    model.kind === "line"
      ? { x: model.x, y: model.y }
      : { u: model.regressors[0], v: model.regressors[1], y: model.y };
  byId("title").textContent = data.title;
  const rows = counted(lesson.readings.length, "reading");
  const others = data.others.length === 0 ? "" : ` of ${lesson.readings.length + data.others.length}`;
  const uniform = lesson.readings.length === 0 ? "" : plain(lesson.readings[0].epsilon);
  const bound =
    epsilon.uniform !== null
      ? `error bound ε = ${uniform}`
      : epsilon.column === null
        ? "bounds of each reading"
        : `error bounds from column ${epsilon.column}`;
  const unit = epsilon.uniform !== null && data.units.y ? ` ${data.units.y}` : "";
  byId("provenance").textContent = `${data.file} · ${rows}${others} · ${bound}${unit}`;
  const own =
    epsilon.column === null
      ? ", here half the distance between the two bounds that a reading states, about their middle; a reading that states one bound is one half-plane"
      : ", here one for each reading";
  const stated = epsilon.uniform === null ? own : ` = ${uniform}${unit}`;
  byId("epsilon-here").textContent = stated + foundFromReadings(data.fit.input.epsilon_from_least);
  byId("epsilon-label").textContent = lesson.epsilon === null ? "All error bounds times" : "Error bound";
  for (const place of all("[data-name]")) {
    const name = names[place.dataset.name ?? ""] ?? "";
    // A formula has no place to break a line.
    place.textContent = place.localName === "mi" ? shortName(name) : name;
  }
  for (const place of all("[data-model]"))
    place.toggleAttribute("data-off", place.dataset.model !== model.kind);
  const matter = lesson.readings
    .filter((reading) => lesson.matters.get(reading.row))
    .map((reading) => reading.row);
  byId("readings-note").textContent = whichMatter(lesson, matter);
  byId("conditions-here").textContent =
    data.conditions.length === 0 ? "" : `, within the ${data.conditions.length === 1 ? "condition" : "conditions"} ${enumeration(data.conditions.map(({ text }) => text))},`;
  byId("condition-legend").hidden = data.conditions.length === 0;
  byId("minimax-here").replaceChildren(...minimaxSentence(lesson));
  const [one, many] = lesson.isLine
    ? ["a line", "lines"]
    : ["one prediction for every reading", "predictions"];
  const there =
    lesson.fps.kind === "empty"
      ? ""
      : `; in the data plane it is the shaded corridor of all feasible ${many}`;
  byId("linked-hint").textContent =
    `A point in the parameter plane is ${one} in the data plane; a reading is a strip. The FPS is ${kindText(lesson.fps.kind, lesson.fps.vertices.length)}${there}.`;
  const shaded =
    lesson.fps.kind === "empty"
      ? `Shaded, where the set shown is not empty: all feasible ${many}.`
      : `Shaded: all feasible ${many}.`;
  const least = lesson.leastSquares === null ? "" : " Dashed: least squares.";
  const faint = data.others.length > 0 && lesson.isLine ? " Faint dots: rows that are not used." : "";
  byId("data-legend").textContent =
    `Bars: readings ${epsilon.uniform === null && epsilon.column === null ? "between their bounds" : "± ε"}, strong where one of their ends, marked ▾ or ▴, shapes the set shown. ${shaded}${least}${faint}`;
  byId("residual-label").textContent =
    lesson.reference === null ? "residuals" : `relative to ${lesson.reference.noun}`;
}

/**
 * What error bounds stand and fall with that were found from the readings.
 * @param {FitData["input"]["epsilon_from_least"]} multiple
 */
function foundFromReadings(multiple) {
  if (multiple === undefined) return "";
  const [factor, least] = [multiple.factor, multiple.epsilon_min].map(({ exact }) => plain(Rational.parse(exact)));
  const times = factor === "1" ? "" : `${factor} times `;
  return `, ${times}the smallest bound under which any parameter fits, ${least}. It was found from these very readings, which cannot show that errors are no larger`;
}

/** @param {string} name */
function shortName(name) {
  return name.length <= LONGEST_IN_FORMULA ? name : `${name.slice(0, LONGEST_IN_FORMULA - 1)}…`;
}

/**
 * Which readings cannot be left out without a change.
 * @param {Lesson} lesson
 * @param {number[]} matter
 */
function whichMatter(lesson, matter) {
  const count = lesson.readings.length;
  if (matter.length === 0)
    return "None of the readings matters alone: the set stays the same without any one of them.";
  const trial = "Switch a reading off to see what it does.";
  if (count === 1) return `The only reading matters: without it the set would be larger. ${trial}`;
  if (matter.length === count)
    return `All ${count} readings matter: without any one of them the set would be larger. ${trial}`;
  if (matter.length === 1)
    return `Only 1 of the ${count} readings matters: without it the set would be larger. It is number ${matter[0]}. ${trial}`;
  return `Only ${matter.length} of the ${count} readings matter: without any one of them the set would be larger. They are numbers ${shortEnumeration(matter)}. ${trial}`;
}

/**
 * What remains when the error bounds shrink.
 * @param {Lesson} lesson
 */
function minimaxSentence(lesson) {
  const { conditions, epsilon, fit } = lesson.data;
  const term = document.createElement("dfn");
  term.textContent = "minimax";
  if (fit.minimax === null)
    return ["What is left last would be the ", term, " estimate; here nothing is left, however large they are."];
  const index = document.createElement("sub");
  index.textContent = "min";
  const symbol = epsilon.uniform === null ? "s" : "ε";
  const whose = lesson.isLine ? "line" : "parameter";
  const measure = epsilon.uniform === null ? ", measured in error bounds" : "";
  const allowed = conditions.length === 0 ? "" : " that the conditions allow";
  return [
    fit.minimax.unique ? "The last parameter that is left is the " : "Any of the last parameters that are left, here more than one, is a ",
    term,
    ` estimate, at ${symbol}`,
    index,
    `: no ${whose}${allowed} has a smaller largest error${measure}.`,
  ];
}
