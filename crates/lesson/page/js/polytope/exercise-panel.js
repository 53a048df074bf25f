// @ts-check
// The ten exercises: question, fields, hints one after the other, and why; and the sheets to be printed.

import { all, byId, closest, element, patch, targetOf } from "../dom.js";
import { rich, t } from "../texts.js";
import { HINTS, judged, rightAnswer } from "./exercises.js";
import { formText, fractionText, halfPlaneText } from "./half-planes.js";
import { freshSeed } from "./random.js";
import { currentExercises } from "./store.js";

const LONGEST_SEED = 20;

/**
 * @param {PolytopeStore} store
 */
export function connectExercises(store) {
  byId("exercise-list").addEventListener("click", (event) => {
    const button = closest(event, "[data-exercise]");
    if (button !== null) store.change({ exercise: Number(button.dataset.exercise), view: null });
  });
  byId("exercise-seed").addEventListener("change", (event) => {
    const seed = targetOf(event).value.trim().slice(0, LONGEST_SEED);
    store.change({ seed: seed === "" ? freshSeed() : seed, exercise: 0, view: null });
  });
  byId("exercise-new").addEventListener("click", () => store.change({ seed: freshSeed(), exercise: 0, view: null }));
  byId("exercise").addEventListener("input", (event) => {
    const field = closest(event, "[data-field]");
    if (field === null) return;
    const typed = [...all("[data-field]", byId("exercise"))].map((own) => own.value);
    changeWork(store, { typed, verdicts: null });
  });
  byId("exercise").addEventListener("submit", (event) => {
    event.preventDefault();
    const state = store.get();
    const typed = [...all("[data-field]", byId("exercise"))].map((own) => own.value);
    changeWork(store, { typed, verdicts: judged(currentExercises(state)[state.exercise], typed) });
  });
  byId("exercise").addEventListener("click", (event) => {
    const work = store.get().work[store.get().exercise];
    if (closest(event, "#exercise-hint") !== null) changeWork(store, { hints: Math.min(HINTS, work.hints + 1) });
    if (closest(event, "#exercise-explain") !== null) changeWork(store, { explained: true });
  });
  byId("print-questions").addEventListener("click", () => printSheet(store, false));
  byId("print-answers").addEventListener("click", () => printSheet(store, true));
  addEventListener("afterprint", () => delete document.body.dataset.sheet);
}

/**
 * @param {PolytopeStore} store
 * @param {Partial<ExerciseWork>} changes
 */
function changeWork(store, changes) {
  const { work, exercise } = store.get();
  store.change({ work: work.map((own, k) => (k === exercise ? { ...own, ...changes } : own)) });
}

/**
 * The half-planes of an exercise, numbered; with ≤ throughout where multiples of them are asked for.
 * @param {Exercise} exercise
 */
function planeList({ id, halfPlanes }) {
  const atMost = ["multipliers", "contradiction", "pivot", "degenerate"].includes(id);
  return element("ol", { class: "plane-list" }, halfPlanes.map((own) => element("li", {}, halfPlaneText(own, false, atMost))));
}

/**
 * @param {Exercise} exercise
 */
function questionText(exercise) {
  return rich(`polytope.ask-${exercise.id}`, exercise.values);
}

/**
 * @param {Exercise} exercise
 * @param {ExerciseWork} work
 */
function answerFields({ answer, number }, { typed, verdicts }) {
  /** @param {number} k */
  const state = (k) => (verdicts === null ? "" : verdicts[k] === null ? "unreadable" : verdicts[k] ? "right" : "wrong");
  if ("choice" in answer) {
    const options = answer.choices.map((kind) => element("option", { value: kind }, t(`polytope.name-${kind}`)));
    return element("label", { "data-state": state(0) }, t("polytope.field-kind"), " ",
      element("select", { "data-field": 0, id: `answer-${number}-0`, value: typed[0] ?? "" }, element("option", { value: "" }, "…"), options));
  }
  return answer.fields.map((label, k) => element("label", { "data-state": state(k) }, t("polytope.field", { name: label }), " ",
    element("input", { "data-field": k, id: `answer-${number}-${k}`, value: typed[k] ?? "", type: "text", inputmode: "text", size: 8, autocomplete: "off", maxlength: 40, "aria-invalid": `${state(k) === "wrong" || state(k) === "unreadable"}` })));
}

/** @param {ExerciseWork} work */
function verdictText({ verdicts, typed }) {
  if (verdicts === null) return "";
  if (verdicts.some((verdict) => verdict === null)) return t(typed.some((text) => text.trim() !== "") ? "polytope.unreadable" : "polytope.nothing-typed");
  const wrong = verdicts.filter((verdict) => !verdict).length;
  if (wrong === 0) return t("polytope.right");
  return wrong === verdicts.length ? t("polytope.wrong") : t("polytope.partly-right", { count: verdicts.length - wrong, all: verdicts.length });
}

/**
 * Draws the exercise that is shown.
 * @param {PolytopeState} state
 */
export function drawExercises(state) {
  if (state.tab !== "exercises") return;
  const exercises = currentExercises(state);
  const exercise = exercises[state.exercise];
  const work = state.work[state.exercise];
  if (document.activeElement !== byId("exercise-seed")) byId("exercise-seed").value = state.seed;
  patch(byId("exercise-list"), exercises.map(({ number }, k) => {
    const { verdicts, explained } = state.work[k];
    const isRight = verdicts?.every((verdict) => verdict === true) ?? false;
    const label = t(isRight ? "polytope.exercise-right" : "polytope.exercise-name", { number });
    return element("button", { type: "button", "data-exercise": k, "aria-pressed": `${k === state.exercise}`, "aria-label": label, class: isRight ? "right" : explained ? "told" : "" }, `${number}${isRight ? " ✓" : ""}`);
  }));
  const hints = Array.from({ length: work.hints }, (_, k) => element("li", { "data-hint": k + 1 }, rich(`polytope.hint-${exercise.id}-${k + 1}`, exercise.values)));
  patch(byId("exercise"), [
    element("h3", { id: "exercise-title", "data-exercise-id": exercise.id }, t("polytope.exercise-name", { number: exercise.number })),
    planeList(exercise),
    exercise.objective === null ? null : element("p", {}, t("polytope.objective-is", { form: formText(exercise.objective) })),
    element("p", { class: "question" }, questionText(exercise)),
    element("div", { class: "fields" }, answerFields(exercise, work), element("button", { type: "submit", id: "exercise-check" }, t("polytope.check"))),
    element("p", { id: "exercise-verdict", "data-right": work.verdicts === null ? "" : `${work.verdicts.every((verdict) => verdict === true)}` }, verdictText(work)),
    element("ol", { id: "exercise-hints", hidden: work.hints === 0 }, hints),
    element("div", { class: "buttons" },
      element("button", { type: "button", id: "exercise-hint", disabled: work.hints >= HINTS }, t("polytope.hint", { number: Math.min(HINTS, work.hints + 1), all: HINTS })),
      element("button", { type: "button", id: "exercise-explain", disabled: work.explained }, t("polytope.explain"))),
    element("p", { id: "exercise-why", hidden: !work.explained }, work.explained ? [t("polytope.answer-is", { answer: answerText(exercise) }), " ", rich(`polytope.why-${exercise.id}`, exercise.values)] : ""),
  ].filter((part) => part !== null));
}

/**
 * The right answer in words.
 * @param {Exercise} exercise
 */
function answerText(exercise) {
  const { answer } = exercise;
  if ("choice" in answer) return t(`polytope.name-${answer.choice}`);
  return answer.values.map((value, k) => `${t("polytope.field", { name: answer.fields[k] })} ${fractionText(value)}`).join("; ");
}

/**
 * Shows the sheet alone, for printing.
 * @param {PolytopeStore} store
 * @param {boolean} withAnswers
 */
function printSheet(store, withAnswers) {
  drawSheet(store.get(), withAnswers);
  document.body.dataset.sheet = withAnswers ? "answers" : "questions";
  print();
}

/**
 * @param {PolytopeState} state
 * @param {boolean} withAnswers
 */
function drawSheet(state, withAnswers) {
  patch(byId("exercise-sheet"), [
    element("h2", {}, t(withAnswers ? "polytope.sheet-answers" : "polytope.sheet")),
    element("p", {}, t("polytope.sheet-seed", { seed: state.seed }), withAnswers ? "" : ` ${t("polytope.sheet-name")} ____________________`),
    element("ol", { class: "sheet" }, currentExercises(state).map((exercise) => element("li", { "data-sheet-exercise": exercise.id },
      planeList(exercise),
      exercise.objective === null ? null : element("p", {}, t("polytope.objective-is", { form: formText(exercise.objective) })),
      element("p", {}, questionText(exercise)),
      withAnswers
        ? element("p", { class: "sheet-answer", "data-answer": rightAnswer(exercise).join("; ") }, element("b", {}, t("polytope.answer-is", { answer: answerText(exercise) })), " ", rich(`polytope.why-${exercise.id}`, exercise.values))
        : element("p", { class: "sheet-room" }, t("polytope.sheet-answer"))))),
  ]);
}
