// The parts of the text that depend on the data.

import { byId } from "./dom.js";
import { counted, enumeration, kindText, plain } from "./format.js";

/** Fills in titles, names of columns and the data set's own facts. */
export function fillIntroduction(lesson) {
  const { data } = lesson;
  const { model, epsilon } = data;
  const names =
    model.kind === "line"
      ? { x: model.x, y: model.y }
      : { u: model.regressors[0], v: model.regressors[1], y: model.y };
  byId("title").textContent = data.title;
  const rows = counted(lesson.readings.length, "reading");
  const others = data.others.length === 0 ? "" : ` of ${lesson.readings.length + data.others.length}`;
  const uniform = lesson.readings.length === 0 ? "" : plain(lesson.readings[0].epsilon);
  const bound =
    epsilon.uniform === null ? `error bounds from column ${epsilon.column}` : `error bound ε = ${uniform}`;
  const unit = epsilon.uniform !== null && data.units.y ? ` ${data.units.y}` : "";
  byId("provenance").textContent = `${data.file} · ${rows}${others} · ${bound}${unit}`;
  byId("epsilon-here").textContent =
    epsilon.uniform === null ? ", here one for each reading" : ` = ${uniform}${unit}`;
  byId("epsilon-label").textContent = lesson.epsilon === null ? "All error bounds times" : "Error bound";
  for (const place of document.querySelectorAll("[data-name]"))
    place.textContent = names[place.dataset.name] ?? "";
  for (const place of document.querySelectorAll("[data-model]"))
    place.toggleAttribute("data-off", place.dataset.model !== model.kind);
  const matter = lesson.readings
    .filter((reading) => lesson.matters.get(reading.row))
    .map((reading) => reading.row);
  byId("readings-note").textContent =
    matter.length === 0
      ? "None of the readings matters alone: the set stays the same without any one of them."
      : `Only ${matter.length} of the ${rows} ${matter.length === 1 ? "matters" : "matter"}: without ${matter.length === 1 ? "it" : "one of them"} the set would be larger. ${matter.length === 1 ? "It is number" : "They are numbers"} ${enumeration(matter)}. Switch a reading off to see what it does.`;
  const [one, many] = lesson.isLine
    ? ["a line", "lines"]
    : ["one prediction for every reading", "predictions"];
  const there =
    lesson.fps.kind === "empty"
      ? ""
      : `; in the data plane it is the shaded corridor of all feasible ${many}`;
  byId("linked-hint").textContent =
    `A point in the parameter plane is ${one} in the data plane; a reading is a strip. The FPS is ${kindText(lesson.fps.kind, lesson.fps.vertices.length)}${there}.`;
  const least = lesson.leastSquares === null ? "" : " Dashed: least squares.";
  const faint = data.others.length > 0 && lesson.isLine ? " Faint dots: rows that are not used." : "";
  byId("data-legend").textContent =
    `Bars: readings ± ε, strong when they matter. ▾ ▴: upper and lower ends that shape the set. Shaded: all feasible ${many}.${least}${faint}`;
  byId("residual-label").textContent =
    lesson.reference === null ? "residuals" : `relative to ${lesson.reference.name}`;
}
