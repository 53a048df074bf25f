// @ts-check
// One reader's work on a sheet: what was done and can be undone, and the questions to the engine. Of these one is under way at most,
// and one waits: while readings are dragged, what is overtaken is never asked.

import { refusalOf } from "./refusals.js";
import { csvOf, problemOf, requestOf } from "./sheet.js";

// So many steps can be undone.
const MOST_STEPS = 200;

/**
 * @param {Engine} engine
 * @param {Sheet} first
 * @param {LessonData} firstData the page's own lesson, which has what the engine in the page cannot make: answers of LP solvers
 * @param {{ onLesson: (data: LessonData, sheet: Sheet, words: string) => void, onChange: () => void }} listeners
 * @returns {Session}
 */
export function createSession(engine, first, firstData, { onLesson, onChange }) {
  /** @type {{ past: Sheet[], future: Sheet[] }} */
  const steps = { past: [], future: [] };
  let sheet = first;
  /** The sheet whose lesson is shown. */
  let right = first;
  /** @type {Problem | null} */
  let problem = null;
  /** @type {string | null} */
  let key = null;
  let words = "";
  let isBusy = false;
  let isWaiting = false;
  /** @type {(() => void)[]} */
  const settling = [];

  async function ask() {
    if (isBusy) {
      isWaiting = true;
      // What the reader has done is shown at once; of a movement there will soon be more.
      if (key === null) onChange();
      return;
    }
    isBusy = true;
    const [asked, about] = [sheet, words];
    onChange();
    /** @type {LessonData | Error} */
    const answer = asked === first ? firstData : await engine.ask("lesson", csvOf(asked), { ...asked.page, ...requestOf(asked) }).then(JSON.parse).catch((error) => error);
    isBusy = false;
    if (!(answer instanceof Error)) {
      right = asked;
      if (asked === sheet) problem = null;
      onLesson(answer, asked, about);
    } else if (asked === sheet) problem = problemOf(refusalOf(answer), asked);
    if (isWaiting) {
      isWaiting = false;
      ask();
    } else settling.splice(0).forEach((resolve) => resolve());
    onChange();
  }

  /** @param {Sheet} next @param {string} about */
  function go(next, about) {
    [sheet, words] = [next, about];
    ask();
  }

  /** @param {Sheet[]} from @param {Sheet[]} to @param {string} about */
  function step(from, to, about) {
    const next = from.pop();
    if (next === undefined) return;
    // What the engine refused is no state to come back to.
    if (problem === null) to.push(sheet);
    [key, problem] = [null, null];
    go(next, about);
  }

  return {
    sheet: () => sheet,
    right: () => right,
    problem: () => problem,
    isBusy: () => isBusy,
    canUndo: () => steps.past.length > 0,
    canRedo: () => steps.future.length > 0,
    edit(next, about, own = null) {
      // Steps of one movement are undone together.
      if (problem === null && (own === null || own !== key)) steps.past.push(sheet);
      if (steps.past.length > MOST_STEPS) steps.past.shift();
      steps.future = [];
      key = own;
      go(next, about);
    },
    settle() {
      key = null;
    },
    settled: () => new Promise((resolve) => (isBusy ? settling.push(resolve) : resolve())),
    undo: (about) => step(steps.past, steps.future, about),
    redo: (about) => step(steps.future, steps.past, about),
  };
}
