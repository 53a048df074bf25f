// @ts-check
// Starts the page: reads the engine's data, connects the controls, and draws everything again after each change.
//
// Names that tests and bookmarks may rely on:
//   body[data-mode]              explore | clip | epsilon | leave-one-out | worst-line;  [data-mode-tab="clip"] switches it
//   #data-plane #parameter-plane the two pictures; #parameter-plane[data-kind] is the kind of the set shown
//   [data-vertex="0"]            vertices, counter-clockwise, with exact data-theta1, data-theta2
//   [data-reading="14"]          readings by row;  [data-half-plane="3"] boundaries by index
//   #place-point #theta-point    the free point (exact data-theta1, data-theta2); #violations[data-count]
//   #step-first #step-back #step-play #step-forward #step-last #step-slider #step-number #clip-order
//   #step-story #step-effect[data-redundant] #step-born #step-lost   (li with exact data-theta1, data-theta2)
//   #epsilon-slider #epsilon-previous #epsilon-next #epsilon-least #epsilon-given
//   #epsilon-value               data-s exact, data-breakpoint index or empty; #epsilon-story
//   #pui-theta1-lower …          exact value in data-exact (empty: infinite); likewise #area; #kind[data-kind]; #active
//   #layer-<id>                  pui-box eui-box least-squares central minimax centroid inner-hull outer-polygon lp
//   [data-layer-shown="<id>"]    what a layer draws; #verdicts rows have data-verdict
//   #leave-out #leave-out-<row>  switches; #leave-one-out-verdict[data-matters]; [data-moved="theta1-lower"][data-by]
//   [data-handle="steepest"][data-side="0"]  handles of the lines by hand, exact data-height; #worst-lines-table rows have
//                                data-by-hand, data-passes, data-theta1 …, or data-exact;  #worst-exact #worst-reset
//   #question-<id>, its button   [data-show];  #residual #straighten #theme-toggle #inspector
//   #conflict                    why the set is empty;  #language  the language of the page
//   the names of the editor are in editor/panel.js
//   the second view, of half-planes without readings, has names of its own: polytope/view.js
//   #status                      the live region;  button[data-zoom="in|out|set|fit"][data-plane="parameter|data"]

import { byId, rove, targetOf } from "./dom.js";
import { readLesson, violations } from "./model/lesson.js";
import { createStore, sceneOf } from "./state.js";
import { drawLayerList, layersOf } from "./panels/layers.js";
import { drawParameterPlane, withActive } from "./planes/parameter-plane.js";
import { drawDataPlane } from "./planes/data-plane.js";
import { drawSummary } from "./panels/summary.js";
import { drawInspector } from "./panels/inspector.js";
import { connectClipping, drawClipping, listOrders, stepSentence } from "./panels/clipping.js";
import { connectEpsilon, drawEpsilon, drawStops, epsilonSentence, epsilonText } from "./panels/epsilon.js";
import { connectLeaveOneOut, drawLeaveOneOut, drawReadings, listSwitches } from "./panels/leave-one-out.js";
import { connectWorstLine, drawWorstLine, worstSentence } from "./panels/worst-line.js";
import { connectQuestions, drawQuestions } from "./panels/questions.js";
import { connectDataPlane, connectParameterPlane, connectZoom } from "./planes/interaction.js";
import { connectWorstLines } from "./planes/worst-lines.js";
import { drawTeacher } from "./panels/teacher.js";
import { fillIntroduction } from "./panels/introduction.js";
import { connectEditor } from "./editor/panel.js";
import { engine } from "./engine.js";
import { kindText, switchedOff } from "./model/format.js";
import { drawStart } from "./panels/start.js";
import { connectLanguage } from "./panels/language.js";
import { connectHalfPlanes } from "./polytope/view.js";
import { tableOf } from "./model/table.js";
import { t } from "./texts.js";

/** @type {Mode[]} */
const MODES = ["explore", "clip", "epsilon", "leave-one-out", "worst-line"];

/** @param {Store} store */
function connectModes(store) {
  const tabs = MODES.map((mode) => byId(`tab-${mode}`));
  tabs.forEach((tab, k) => {
    tab.addEventListener("click", () => store.change({ mode: MODES[k], playing: false, without: [] }));
    tab.addEventListener("keydown", (event) => {
      const next = rove(event.key, k, tabs.length);
      if (next === null) return;
      event.preventDefault();
      tabs[next].focus();
      tabs[next].click();
    });
  });
}

/** @param {State} state */
function drawModes(state) {
  document.body.dataset.mode = state.mode;
  // What is to be found by hand is not shown before it is asked for.
  document.body.toggleAttribute("data-withheld", state.mode === "worst-line" && !state.exactLines);
  for (const mode of MODES) {
    const chosen = mode === state.mode;
    byId(`tab-${mode}`).setAttribute("aria-selected", `${chosen}`);
    byId(`tab-${mode}`).tabIndex = chosen ? 0 : -1;
    byId(`panel-${mode}`).hidden = !chosen;
  }
}

function connectTheme() {
  const button = byId("theme-toggle");
  const preference = matchMedia("(prefers-color-scheme: dark)");
  /** @type {boolean | null} */
  let chosen = null;
  const apply = () => {
    const dark = chosen ?? preference.matches;
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    button.setAttribute("aria-pressed", `${dark}`);
  };
  button.addEventListener("click", () => {
    chosen = !(chosen ?? preference.matches);
    apply();
  });
  preference.addEventListener("change", apply);
  // Paper is white.
  addEventListener("beforeprint", () => {
    document.documentElement.dataset.theme = "light";
  });
  addEventListener("afterprint", apply);
  apply();
}

// On paper the explanation is there to read; answers that nobody opened stay closed, so that it can be handed out.
function connectPrinting() {
  const details = /** @type {HTMLDetailsElement} */ (document.querySelector("#introduction details"));
  let wasOpen = details.open;
  addEventListener("beforeprint", () => {
    wasOpen = details.open;
    details.open = true;
  });
  addEventListener("afterprint", () => {
    details.open = wasOpen;
  });
}

/**
 * What a change of state is worth saying aloud, or null.
 * @param {Lesson} lesson
 * @param {State} state
 * @param {State} before
 * @param {Scene} scene
 */
function announcement(lesson, state, before, scene) {
  /** @param {(keyof State)[]} keys */
  const changed = (...keys) => keys.some((key) => state[key] !== before[key]);
  if (state.mode === "clip" && changed("mode", "step", "order")) return stepSentence(lesson, state, scene);
  if (state.mode === "epsilon" && lesson.stops.length > 0 && changed("mode", "stop")) {
    const stop = lesson.stops[state.stop];
    return `${epsilonText(lesson, stop)}. ${epsilonSentence(lesson, stop)}`;
  }
  if (state.mode === "worst-line" && changed("mode", "hand", "exactLines")) return worstSentence(lesson, state);
  if (changed("mode", "without")) {
    const shown = kindText(scene.region.kind, scene.region.vertices.length);
    if (state.without.length === 0) return t("switch.announced-all", { set: shown });
    const matters = state.without.length > 1 || lesson.matters.get(state.without[0]);
    return t("switch.sentence", { off: switchedOff(state.without), now: matters ? t("switch.now", { set: shown }) : t("switch.announced-idle") });
  }
  if (changed("selection") && state.selection?.kind === "point")
    return byId("violations")?.textContent ?? null;
  if (changed("selection") && state.selection !== null) {
    return [...byId("inspector").querySelectorAll("h3,dt,dd,p")].map((part) => part.textContent).join(" ");
  }
  if (changed("layers")) return t("layers.shown", { count: state.layers.size });
  return null;
}

/**
 * What follows from the lesson alone, whatever the state.
 * @param {Lesson} lesson
 */
function drawLesson(lesson) {
  fillIntroduction(lesson);
  drawStart(lesson);
  listOrders(lesson);
  drawStops(lesson);
  listSwitches(lesson);
  drawQuestions(lesson);
  drawTeacher(lesson);
  byId("residual").disabled = lesson.reference === null;
}

function start() {
  const store = createStore(readLesson(JSON.parse(byId("lesson-data").textContent)));
  const roving = { vertex: 0, reading: 0 };
  const drawn = /** @type {Drawn} */ ({});
  /** @param {PageElement} svg */
  const sizeOf = (svg) => ({
    width: Math.max(200, svg.clientWidth),
    height: Math.max(200, svg.clientHeight),
  });

  function draw() {
    const [lesson, state] = [store.lesson(), store.get()];
    if (drawn.lesson !== lesson || drawn.state?.language !== state.language) {
      Object.assign(drawn, { lesson, layers: layersOf(lesson), state: undefined });
      drawLesson(lesson);
    }
    const { layers } = drawn;
    const scene = sceneOf(lesson, state);
    const choice = explained(lesson, state.hover ?? state.selection, scene);
    const shown = { ...state, hover: choice };
    drawModes(state);
    drawn.scene = scene;
    drawn.dataMap = drawDataPlane(
      lesson,
      { ...shown, selection: state.selection },
      scene,
      layers,
      sizeOf(byId("data-plane")),
      roving.reading,
    );
    drawn.parameterMap = drawParameterPlane(
      lesson,
      shown,
      scene,
      layers,
      sizeOf(byId("parameter-plane")),
      roving.vertex,
    );
    drawInspector(lesson, state, scene, choice);
    // What the pointer is on changes the pictures and the explanation only.
    const last = drawn.state;
    const keys = /** @type {(keyof State)[]} */ (Object.keys(state));
    if (last !== undefined && keys.every((key) => key === "hover" || state[key] === last[key])) return;
    drawn.state = state;
    drawSummary(lesson, state, scene);
    drawClipping(lesson, state, scene);
    drawEpsilon(lesson, state);
    drawLeaveOneOut(lesson, state, scene);
    drawWorstLine(lesson, state);
    drawReadings(lesson, state);
    drawLayerList(lesson, layers, state);
    byId("residual").checked = state.residual;
    byId("straighten").checked = state.straighten;
  }

  /**
   * @param {Lesson} lesson
   * @param {Choice | null} choice
   * @param {Scene} scene
   */
  function explained(lesson, choice, scene) {
    if (choice?.kind !== "point") return withActive(lesson, scene, choice);
    return {
      ...choice,
      violated: new Set(violations(lesson, choice.theta, scene.region).map(({ reading }) => reading.row)),
    };
  }

  connectTheme();
  connectLanguage(store);
  connectPrinting();
  connectModes(store);
  connectClipping(store);
  connectEpsilon(store);
  connectLeaveOneOut(store);
  connectDataPlane(byId("data-plane"), store, () => drawn, roving);
  connectParameterPlane(byId("parameter-plane"), store, () => drawn, roving);
  connectWorstLine(store);
  connectWorstLines(byId("data-plane"), store, () => drawn);
  connectZoom(store, () => drawn);
  connectQuestions(store, () => drawn);
  byId("residual").addEventListener("change", (event) =>
    store.change({ residual: targetOf(event).checked, dataView: null }),
  );
  byId("straighten").addEventListener("change", (event) =>
    store.change({ straighten: targetOf(event).checked, parameterView: null }),
  );
  byId("layer-list").addEventListener("change", (event) => {
    const next = new Set(store.get().layers);
    const { checked, dataset } = targetOf(event);
    if (checked) next.add(dataset.layer ?? "");
    else next.delete(dataset.layer ?? "");
    store.change({ layers: next, parameterView: null });
  });
  addEventListener("keydown", (event) => {
    if (event.key === "Escape") store.change({ selection: null, hover: null });
  });
  store.subscribe((state, before) => {
    draw();
    const words = announcement(store.lesson(), state, before, drawn.scene);
    if (words !== null) byId("status").textContent = words;
  });
  draw();
  const editor = engine === null ? null : connectEditor(engine, store, () => drawn);
  for (const touch of ["pointerdown", "keydown"]) addEventListener(touch, () => engine?.wake(), { capture: true, once: true });
  connectHalfPlanes(store, () => editor?.address());
  // For the console of the browser, and for tests: `await boundfit.engine.ask("run", "x,y\n1,2\n", { x: "x", y: "y", eps: "1" })`.
  Object.assign(globalThis, { boundfit: { engine, tableOf, store, editor } });
  // Sizes are known only now, and change with the window.
  new ResizeObserver(draw).observe(byId("parameter-plane"));
}

start();
