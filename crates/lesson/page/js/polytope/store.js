// @ts-check
// What the view of half-planes shows, in one place, and the engine's answer to it.

import { refusalOf, refusedWords } from "../editor/refusals.js";
import { engine } from "../engine.js";
import { ONE, Rational } from "../model/rational.js";
import { currentLanguage } from "../texts.js";
import { exercisesOf } from "./exercises.js";
import { halfPlaneText } from "./half-planes.js";
import { freshSeed } from "./random.js";

const FIRST_TEXT = "x >= 0\ny >= 0\nx + 2y <= 8\n3x + y <= 9\nx + y <= 7";

/** @returns {ExerciseWork[]} */
function untouched() {
  return Array.from({ length: 10 }, () => ({ typed: [], verdicts: null, hints: 0, explained: false }));
}

/**
 * The state at the start, and a way to change it. A change of what the engine is asked about asks it.
 * @returns {PolytopeStore}
 */
export function createPolytopeStore() {
  /** @type {PolytopeState} */
  let state = {
    text: FIRST_TEXT, tab: "set", objective: [new Rational(2n), ONE], start: null, step: 0, pivot: 0, chosen: null, drawing: false, view: null,
    answer: null, answered: null, errors: [], refused: null, seed: freshSeed(), exercise: 0, work: untouched(), language: currentLanguage(),
  };
  /** @type {((state: PolytopeState, before: PolytopeState) => void)[]} */
  const listeners = [];
  /** @param {Partial<PolytopeState>} changes */
  const change = (changes) => {
    const before = state;
    if (changes.seed !== undefined && changes.seed !== state.seed) changes = { work: untouched(), ...changes };
    state = { ...state, ...changes };
    listeners.forEach((listener) => listener(state, before));
  };
  return { get: () => state, change, subscribe: (listener) => listeners.push(listener) };
}

/** @type {Map<string, Exercise[]>} */
const madeExercises = new Map();

/**
 * The exercises of the seed that is shown.
 * @param {PolytopeState} state
 */
export function currentExercises({ seed }) {
  const found = madeExercises.get(seed) ?? exercisesOf(seed);
  madeExercises.clear();
  madeExercises.set(seed, found);
  return found;
}

/**
 * What the engine is asked: of the reader's half-planes, or of those of the exercise.
 * @param {PolytopeState} state
 */
function planeQuestion(state) {
  const exercise = state.tab === "exercises" ? currentExercises(state)[state.exercise] : null;
  const form = exercise === null ? state.objective : exercise.objective;
  return {
    // As it is typed here: a decimal comma, and a minus sign from a book.
    text: exercise === null ? typedText(state.text) : exercise.halfPlanes.map((own) => halfPlaneText(own, true)).join("\n"),
    options: {
      ...(form === null ? {} : { objective: form.map((value) => value.toString()) }),
      ...(exercise === null && state.start !== null ? { start: state.start } : {}),
    },
  };
}

/** @param {string} text */
function typedText(text) {
  return text.replace(/\u2212/g, "-").replace(/(\d),(?=\d)/g, "$1.");
}

/**
 * Asks the engine whenever its answer may be another one. Of several questions on their way only the last answer counts.
 * @param {PolytopeStore} store
 */
export function connectPolytopeEngine(store) {
  if (engine === null) return () => undefined;
  const { ask } = engine;
  let asked = "";
  let latest = 0;
  const update = () => {
    const state = store.get();
    const { text, options } = planeQuestion(state);
    const about = state.tab === "exercises" ? null : state.text;
    const question = JSON.stringify([text, options]);
    if (question === asked) return;
    asked = question;
    latest += 1;
    const own = latest;
    ask("polytope", text, options).then(
      (answer) => own === latest && store.change(afterAnswer(store.get(), JSON.parse(answer), about)),
      (error) => {
        if (own !== latest) return;
        // A vertex that is no longer there.
        if (store.get().start !== null) store.change({ start: null });
        else store.change({ refused: () => refusedWords(refusalOf(error)) });
      },
    );
  };
  store.subscribe(update);
  return update;
}

/**
 * @param {PolytopeState} state
 * @param {PolytopeData} answer
 * @param {string | null} answered the text that it is about, as it was typed
 * @returns {Partial<PolytopeState>}
 */
function afterAnswer(state, answer, answered) {
  if (answer.errors.length > 0) return { errors: answer.errors, refused: null };
  const count = answer.half_planes.length;
  const pivots = answer.simplex?.bases.length ?? 1;
  return {
    answer, answered, errors: [], refused: null,
    step: Math.min(state.step, count),
    pivot: Math.min(state.pivot, pivots - 1),
    chosen: state.chosen !== null && state.chosen < count ? state.chosen : null,
  };
}
