// @ts-check
// Questions about this data set, with answers to reveal and, where there is something to see, a way to see it.

import { byId, closest, element, patch } from "../dom.js";
import { said, t } from "../texts.js";

// A question may point to a group of layers.
/** @type {Record<string, string[]>} */
const GROUPS = {
  pui: ["pui-box"],
  eui: ["eui-box"],
  directions: ["inner-hull", "outer-polygon"],
};

/**
 * Connects the buttons of the questions.
 * @param {Store} store
 * @param {() => Drawn} current
 */
export function connectQuestions(store, current) {
  byId("question-list").addEventListener("click", (event) => {
    const button = closest(event, "button[data-show]");
    const what = store.lesson().data.questions[Number(button?.dataset.show)]?.show ?? null;
    if (what !== null) show(what, current().layers, store);
  });
}

/**
 * Draws the questions.
 * @param {Lesson} lesson
 */
export function drawQuestions(lesson) {
  const { questions } = lesson.data;
  /**
   * @param {QuestionData} question
   * @param {number} index
   */
  const item = (question, index) =>
    element(
      "li",
      {},
      element(
        "details",
        { id: `question-${question.id}` },
        element("summary", {}, said(question.question)),
        element("p", {}, said(question.answer)),
        question.show === null
          ? null
          : element("button", { type: "button", class: "show-me", "data-show": index }, t("questions.show")),
      ),
    );
  patch(byId("question-list"), questions.map(item));
}

/**
 * @param {ShowData} what
 * @param {Layer[]} layers
 * @param {Store} store
 */
function show(what, layers, store) {
  /** @type {Partial<State>} */
  const changes = { mode: "explore", without: [], hover: null, parameterView: null };
  if (what.kind === "vertex") changes.selection = { kind: "vertex", index: what.index };
  else if (what.kind === "row") changes.selection = { kind: "reading", row: what.row };
  else {
    const wanted = GROUPS[what.layer] ?? [what.layer];
    const there = wanted.filter((id) => layers.some((layer) => layer.id === id && layer.why === null));
    changes.layers = new Set([...store.get().layers, ...there]);
  }
  store.change(changes);
  byId("planes").scrollIntoView({ block: "start" });
  byId("planes").focus({ preventScroll: true });
}
