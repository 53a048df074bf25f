// @ts-check
// The second view of the page: half-planes without readings. Names that tests and bookmarks may rely on:
//   body[data-view]              readings | half-planes;  [data-view-choice="half-planes"] switches it, where the engine is in the page
//   body[data-plane-tab]         set | clip | objective | simplex | exercises;  [data-plane-tab-choice="clip"] switches it
//   [data-plane-picture="svg"]   takes the picture away, as SVG or PNG
//   #half-plane-picture          data-kind; [data-plane-line="0"], [data-corner="0"] with exact data-theta1, data-theta2
//   #plane-text                  one half-plane a line; [data-note-line="1"] what is wrong with it
//   #plane-sentence              what is shown, in words; #plane-story its tables; #plane-status the live region
//   #objective-arrow             exact data-c1, data-c2; #objective-1 #objective-2; #objective-proof #objective-ways
//   #plane-first #plane-back #plane-forward #plane-last #plane-step   steps of clipping, or pivots; #simplex-table
//   #exercise-list [data-exercise="0"], #exercise [data-field="0"], #exercise-check, #exercise-verdict[data-right]
// The fragment of the page's address says what is shown: #view=half-planes&planes=…&c=…&seed=…, then what it says of the readings

import { all, byId, element, patch, rove } from "../dom.js";
import { engine } from "../engine.js";
import { readingsPart, withReadings } from "../fragment-parts.js";
import { takePicture } from "../picture.js";
import { t, wordsOfError } from "../texts.js";
import { drawHalfPlanes } from "./drawing.js";
import { connectPlaneEditor, drawPlaneEditor, listPlaneExamples } from "./editor.js";
import { connectExercises, drawExercises } from "./exercise-panel.js";
import { typedNumber } from "./exercises.js";
import { connectHalfPlanePicture } from "./gestures.js";
import { connectPolytopeEngine, createPolytopeStore } from "./store.js";
import { clipSentence, objectiveSentence, pivotSentence, proofStory, setSentence, setStory, simplexTable } from "./story.js";

/** @type {PolytopeTab[]} */
const PLANE_TABS = ["set", "clip", "objective", "simplex", "exercises"];

/**
 * Connects the view, where the engine is in the page.
 * @param {Store} page
 * @param {() => void} onReadings what is to be done when the readings are shown again: the address of the page is theirs
 */
export function connectHalfPlanes(page, onReadings) {
  if (engine === null) return;
  byId("view-choice").hidden = false;
  const store = createPolytopeStore();
  const drawn = /** @type {PolytopeDrawn} */ ({});
  const svg = byId("half-plane-picture");
  const draw = () => {
    if (document.body.dataset.view !== "half-planes") return;
    const state = store.get();
    drawPlaneTabs(state);
    Object.assign(drawn, drawHalfPlanes(state, { width: Math.max(200, svg.clientWidth), height: Math.max(200, svg.clientHeight) }));
    drawPlaneEditor(state);
    drawPlaneWords(state);
    drawExercises(state);
  };
  const ask = connectPolytopeEngine(store);
  connectHalfPlanePicture(store, () => drawn);
  connectPlaneEditor(store, () => drawn);
  connectExercises(store);
  connectPlaneTabs(store);
  connectPlaneSteps(store);
  for (const button of all("[data-plane-picture]")) {
    button.addEventListener("click", () => {
      takePicture(svg.id, "half-planes", button.dataset.planePicture ?? "svg").catch((error) => store.change({ refused: () => wordsOfError(error) }));
    });
  }
  store.subscribe((state, before) => {
    draw();
    const words = spokenChange(state, before);
    if (words !== "") byId("plane-status").textContent = words;
    rememberPlanes(state);
  });
  page.subscribe((state, before) => {
    if (state.language === before.language) return;
    listPlaneExamples();
    store.change({ language: state.language });
  });
  /** @param {string} view */
  const show = (view) => {
    document.body.dataset.view = view;
    for (const button of all("[data-view-choice]")) button.setAttribute("aria-pressed", `${button.dataset.viewChoice === view}`);
    if (view !== "half-planes") return;
    ask();
    draw();
  };
  for (const button of all("[data-view-choice]")) {
    button.addEventListener("click", () => {
      show(button.dataset.viewChoice ?? "readings");
      rememberPlanes(store.get());
      if (button.dataset.viewChoice === "readings") onReadings();
    });
  }
  listPlaneExamples();
  const first = recalledPlanes();
  if (first !== null) store.change(first);
  show(first === null ? "readings" : "half-planes");
  addEventListener("hashchange", () => {
    const next = recalledPlanes();
    // What else an address says is about the readings.
    if (next === null && location.hash.length > 1) show("readings");
    if (next === null) return;
    store.change(next);
    show("half-planes");
  });
  // Its size is known only when it is shown, and changes with the window.
  new ResizeObserver(draw).observe(svg);
}

/** @param {PolytopeState} state */
function drawPlaneTabs(state) {
  document.body.dataset.planeTab = state.tab;
  for (const tab of PLANE_TABS) {
    const button = byId(`plane-tab-${tab}`);
    button.setAttribute("aria-selected", `${tab === state.tab}`);
    button.tabIndex = tab === state.tab ? 0 : -1;
  }
  byId("plane-panel").setAttribute("aria-labelledby", `plane-tab-${state.tab}`);
  const { at, last } = stepsOf(state);
  byId("plane-step").setAttribute("max", `${last}`);
  byId("plane-step").value = `${at}`;
  byId("plane-step-number").textContent = `${at} / ${last}`;
  for (const id of ["plane-first", "plane-back"]) byId(id).disabled = at === 0;
  for (const id of ["plane-forward", "plane-last"]) byId(id).disabled = at >= last;
}

/** @param {PolytopeStore} store */
function connectPlaneTabs(store) {
  const tabs = PLANE_TABS.map((tab) => byId(`plane-tab-${tab}`));
  tabs.forEach((button, k) => {
    button.addEventListener("click", () => store.change({ tab: PLANE_TABS[k], drawing: false, ...(PLANE_TABS[k] === "exercises" ? { view: null } : {}) }));
    button.addEventListener("keydown", (event) => {
      const next = rove(event.key, k, tabs.length);
      if (next === null) return;
      event.preventDefault();
      tabs[next].focus();
      tabs[next].click();
    });
  });
}

/**
 * Steps of clipping, or pivots: where we are and how many there are.
 * @param {PolytopeState} state
 */
function stepsOf({ tab, answer, step, pivot }) {
  if (tab === "simplex") return { at: pivot, last: Math.max(0, (answer?.simplex?.bases.length ?? 1) - 1) };
  return { at: step, last: answer?.steps.length ?? 0 };
}

/** @param {PolytopeStore} store */
function connectPlaneSteps(store) {
  /** @param {(at: number, last: number) => number} next */
  const go = (next) => () => {
    const state = store.get();
    const { at, last } = stepsOf(state);
    const to = Math.max(0, Math.min(last, next(at, last)));
    store.change(state.tab === "simplex" ? { pivot: to } : { step: to });
  };
  byId("plane-first").addEventListener("click", go(() => 0));
  byId("plane-back").addEventListener("click", go((at) => at - 1));
  byId("plane-forward").addEventListener("click", go((at) => at + 1));
  byId("plane-last").addEventListener("click", go((_, last) => last));
  byId("plane-step").addEventListener("input", () => go(() => Number(byId("plane-step").value))());
}

/**
 * Which lines cannot be read, and why.
 * @param {PolytopeState} state
 */
function errorSentence({ errors }) {
  return errors.map(({ line, kind }) => t("polytope.error-in-line", { line, problem: { text: `polytope.error-${kind}` } })).join(" ");
}

/**
 * What is shown in one sentence.
 * @param {PolytopeState} state
 */
function planeSentence(state) {
  const { answer, tab } = state;
  if (tab !== "exercises" && state.errors.length > 0) return errorSentence(state);
  if (answer === null || tab === "exercises") return "";
  if (tab === "clip") return clipSentence(state, answer);
  if (tab === "objective") return objectiveSentence(answer);
  return tab === "simplex" ? pivotSentence(state, answer) : setSentence(answer);
}

/** @param {PolytopeState} state */
function drawPlaneWords(state) {
  const { answer, tab } = state;
  byId("plane-sentence").textContent = planeSentence(state);
  const told = answer === null ? [] : tab === "objective" ? proofStory(answer) : tab === "simplex" ? simplexTable(state, answer) : tab === "set" ? setStory(answer) : [];
  patch(byId("half-plane-keys"), [element("details", { class: "hint" }, element("summary", {}, t("polytope.keys-title")), element("p", { id: "half-plane-keys-help" }, t("polytope.keys")))]);
  patch(byId("plane-story"), told.filter((part) => part !== null));
}

/**
 * What a change is worth saying aloud.
 * @param {PolytopeState} state
 * @param {PolytopeState} before
 */
function spokenChange(state, before) {
  if (state.errors !== before.errors && state.errors.length > 0) return errorSentence(state);
  const isOther = state.answer !== before.answer || state.tab !== before.tab || state.step !== before.step || state.pivot !== before.pivot;
  if (isOther && state.tab !== "exercises") return planeSentence(state);
  const work = state.work[state.exercise];
  if (state.work !== before.work && work.verdicts !== before.work[state.exercise].verdicts) return byId("exercise-verdict").textContent ?? "";
  return "";
}

/** @type {ReturnType<typeof setTimeout> | undefined} */
let remembering;

/**
 * Writes what is shown into the address of the page, when it has come to rest.
 * @param {PolytopeState} state
 */
function rememberPlanes(state) {
  clearTimeout(remembering);
  remembering = setTimeout(() => {
    if (document.body.dataset.view !== "half-planes") return;
    const words = new URLSearchParams({ view: "half-planes", tab: state.tab, planes: state.text, c: state.objective.join(" "), seed: state.seed });
    history.replaceState(null, "", `#${withReadings(`${words}`, readingsPart(location.hash.slice(1)))}`);
  }, 300);
}

/**
 * What the address of the page says, or null.
 * @returns {Partial<PolytopeState> | null}
 */
function recalledPlanes() {
  const words = new URLSearchParams(location.hash.slice(1));
  if (words.get("view") !== "half-planes") return null;
  const objective = (words.get("c") ?? "").split(" ").map(typedNumber);
  const [c1, c2] = objective;
  const tab = PLANE_TABS.find((own) => own === words.get("tab"));
  const [text, seed] = [words.get("planes"), words.get("seed")];
  return {
    ...(text === null ? {} : { text }),
    ...(seed === null || seed.trim() === "" ? {} : { seed: seed.trim().slice(0, 20) }),
    ...(objective.length === 2 && c1 !== null && c2 !== null ? { objective: [c1, c2] } : {}),
    ...(tab === undefined ? {} : { tab }),
    view: null, start: null, chosen: null,
  };
}
