// @ts-check
// The half-planes as text, one a line, with what each is called and what is wrong with it beside it.

import { byId, element, patch, targetOf } from "../dom.js";
import { t } from "../texts.js";
import { planeName } from "./document.js";
import { typedNumber } from "./exercises.js";
import { addHalfPlane, deleteHalfPlane, flipHalfPlane, setObjective } from "./gestures.js";

/** Sets to begin with. */
const EXAMPLES = [
  ["polygon", "x >= 0\ny >= 0\nx + 2y <= 8\n3x + y <= 9\nx + y <= 7"],
  ["degenerate", "x >= 0\ny >= 0\nx + y <= 4\nx <= 4\nx - y <= 4\nx + 3y <= 10"],
  ["unbounded", "x >= 0\ny >= 1\n-x + y <= 3\n-x + 3y <= 13"],
  ["empty", "x + y <= 2\nx >= 2\ny >= 1\nx - y <= 4"],
  ["point", "x + y <= 4\nx >= 3\ny >= 1\ny <= 5"],
  ["segment", "x + 2y = 6\nx >= 0\ny >= 1"],
  ["strip", "-x + 2y <= 4\nx - 2y <= 2\n-x + 2y <= 7"],
];

/**
 * @param {PolytopeStore} store
 * @param {() => PolytopeDrawn} current
 */
export function connectPlaneEditor(store, current) {
  byId("plane-text").addEventListener("input", (event) => store.change({ text: targetOf(event).value, chosen: null }));
  byId("plane-example").addEventListener("change", (event) => {
    const found = EXAMPLES.find(([id]) => id === targetOf(event).value);
    if (found !== undefined) store.change({ text: found[1], chosen: null, start: null, view: null, step: 0, pivot: 0 });
    targetOf(event).value = "";
  });
  byId("plane-add").addEventListener("click", () => addHalfPlane(store, current));
  byId("plane-delete").addEventListener("click", () => withChosen(store, deleteHalfPlane));
  byId("plane-flip").addEventListener("click", () => withChosen(store, flipHalfPlane));
  byId("plane-draw").addEventListener("click", () => store.change({ drawing: !store.get().drawing }));
  for (const axis of [0, 1]) {
    byId(`objective-${axis + 1}`).addEventListener("input", (event) => {
      const typed = typedNumber(targetOf(event).value);
      targetOf(event).setAttribute("aria-invalid", `${typed === null}`);
      if (typed !== null) setObjective(store, store.get().objective.map((value, k) => (k === axis ? typed : value)));
    });
  }
  byId("objective-turn").addEventListener("click", () => {
    const [c1, c2] = store.get().objective;
    setObjective(store, [c1.negated(), c2.negated()]);
  });
}

/**
 * @param {PolytopeStore} store
 * @param {(store: PolytopeStore, index: number) => void} change
 */
function withChosen(store, change) {
  const { chosen } = store.get();
  if (chosen !== null) change(store, chosen);
}

/** The sets to begin with, in the language of the page. */
export function listPlaneExamples() {
  patch(byId("plane-example"), [
    element("option", { value: "" }, t("polytope.example")),
    ...EXAMPLES.map(([id]) => element("option", { value: id }, t(`polytope.example-${id}`))),
  ]);
}

/**
 * What stands beside a line: what is wrong, or whether it is redundant.
 * @param {PolytopeState} state
 * @param {number} line from 1
 */
function noteOf({ answer, errors }, line) {
  const error = errors.find((own) => own.line === line);
  if (error !== undefined) return { name: "!", note: `${t(`polytope.error-${error.kind}`)} ${t("polytope.at-character", { column: error.column })}`, wrong: true };
  const own = (answer?.half_planes ?? []).flatMap((halfPlane, index) => (halfPlane.line === line ? [{ halfPlane, index }] : []));
  if (answer === null || own.length === 0 || errors.length > 0) return { name: "", note: "", wrong: false };
  const idle = own.every(({ halfPlane }) => halfPlane.redundant !== null);
  const isEmpty = answer.set?.kind === "empty";
  return { name: `(${own[0].halfPlane.number})`, note: idle && !isEmpty ? t("polytope.redundant") : "", wrong: false };
}

/**
 * Draws the text with its notes, and the buttons of what is chosen.
 * @param {PolytopeState} state
 */
export function drawPlaneEditor(state) {
  const area = byId("plane-text");
  if (area.value !== state.text) area.value = state.text;
  const count = Math.max(6, state.text.split("\n").length + 1);
  area.setAttribute("rows", `${count}`);
  area.setAttribute("aria-invalid", `${state.errors.length > 0}`);
  const notes = state.text.split("\n").map((_, k) => noteOf(state, k + 1));
  patch(byId("plane-names"), notes.map(({ name, wrong }) => element("span", { class: wrong ? "wrong" : "" }, name || "\u00a0")));
  patch(byId("plane-notes"), notes.map(({ note, wrong }, k) => element("span", { class: wrong ? "wrong" : "", "data-note-line": k + 1, title: note }, note || "\u00a0")));
  const { chosen, answer } = state;
  const hasChosen = chosen !== null && answer !== null && answer.half_planes[chosen] !== undefined;
  byId("plane-delete").disabled = !hasChosen;
  byId("plane-flip").disabled = !hasChosen;
  byId("plane-draw").setAttribute("aria-pressed", `${state.drawing}`);
  byId("plane-chosen").textContent = hasChosen ? t("polytope.chosen", { name: planeName(answer, chosen), text: { formula: answer.half_planes[chosen].text } }) : t("polytope.none-chosen");
  byId("plane-refused").textContent = state.refused?.() ?? "";
  state.objective.forEach((value, axis) => {
    const field = byId(`objective-${axis + 1}`);
    const typed = typedNumber(field.value);
    if (typed === null ? document.activeElement !== field : !typed.equals(value)) {
      field.value = value.toString();
      field.setAttribute("aria-invalid", "false");
    }
  });
}

