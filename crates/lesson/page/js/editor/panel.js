// @ts-check
// The editor of the readings: what it shows. There where the page has the engine.
//
// Names that tests and bookmarks may rely on:
//   #edit-toggle                 shows the cells in place of the table;  #undo #redo #edit-back #edit-example
//   [data-cell="0 1"]            row and column of the sheet, from 0;  [data-fitted="0"] [data-delete="0"] #add-reading
//   #bounds-kind #eps #where #through-origin;  #sheet-problem is the engine's message, beside what it is about
//   #paste-text #paste-use #open-file;  #import with #import-x …, #import-apply, #import-cancel
//   [data-export="csv|text|latex|json|data-svg|data-png|parameter-svg|parameter-png"]  #command  #link
//   #editor[data-busy]           "true" while the engine computes

import { byId, element, patch } from "../dom.js";
import { readingEdits } from "./actions.js";
import { connectAddress, writeAddress, writeAddressSoon } from "./address.js";
import { connectControls } from "./controls.js";
import { connectDragging, drawnAt } from "./drag.js";
import { EXPORTS, FILE_NAME } from "./export.js";
import { grid, problemNote } from "./grid.js";
import { importForm } from "./importing.js";
import { questionForm } from "./question-form.js";
import { createSession } from "./session.js";
import { commandOf, csvOf, isSameSheet, requestOf, sheetOf, usedRows, withRequest } from "./sheet.js";
import { notesOf } from "./table-notes.js";
import { kindText } from "../model/format.js";
import { readLesson } from "../model/lesson.js";
import { t } from "../texts.js";

const MILLISECONDS_UNTIL_SLOW = 700;
/** The rows to type into where there are no readings yet. */
const FIRST_ROWS = 4;

/**
 * Connects the editor.
 * @param {Engine} engine
 * @param {Store} store
 * @param {() => Drawn} current
 * @returns {Editor}
 */
export function connectEditor(engine, store, current) {
  const data = store.lesson().data;
  const isBlank = data.readings.length === 0;
  const own = isBlank ? withRoom(sheetOf(data)) : sheetOf(data);
  const bench = /** @type {Workbench} */ ({
    engine, store, current, own, isBlank,
    isOpen: isBlank, isSlow: false, typing: null, pending: null, notice: null, taken: null, link: location.href, following: null, focusOn: null,
  });
  bench.draw = () => drawEditor(bench);
  bench.session = createSession(engine, own, data, {
    onLesson: (next, _, words) => showLesson(bench, next, words),
    onChange: bench.draw,
  });
  store.subscribe((state, before) => {
    if (state.selection !== before.selection || state.language !== before.language) bench.draw();
    focusNew(bench);
  });
  connectControls(bench);
  connectDragging(byId("data-plane"), store, current, readingEdits(bench));
  byId("edit-tools").hidden = false;
  bench.draw();
  connectAddress(bench);
  return forOthers(bench);
}

/** @param {Workbench} bench @returns {Editor} */
function forOthers(bench) {
  const { session } = bench;
  return {
    address: () => writeAddress(bench),
    sheet: session.sheet,
    problem: session.problem,
    settled: async () => {
      await bench.following;
      await session.settled();
    },
    edit: (sheet) => session.edit(sheet, ""),
    undo: () => session.undo(""),
    csvOf,
    csv: () => csvOf(session.right()),
    command: () => commandOf(session.right(), FILE_NAME),
    request: () => requestOf(session.right()),
  };
}

/**
 * A sheet without readings, with some room to type them and a bound that is right for any.
 * @param {Sheet} sheet
 * @returns {Sheet}
 */
function withRoom(sheet) {
  const rows = Array.from({ length: FIRST_ROWS }, () => ({ cells: sheet.columns.map(() => ""), isFitted: true }));
  return withRequest({ ...sheet, rows }, { eps: "2*min" });
}

/**
 * Shows what the engine has made of a sheet.
 * @param {Workbench} bench
 * @param {LessonData} data
 * @param {string} words what was done
 */
function showLesson(bench, data, words) {
  const { store } = bench;
  const wasEmpty = store.lesson().readings.length === 0;
  store.replace(readLesson(data));
  const { fps } = store.lesson();
  // Without readings the cells come first, with some the pictures do: the cell that is typed into stays in sight.
  if (wasEmpty && byId("editor").contains(document.activeElement)) document.activeElement?.scrollIntoView({ block: "center" });
  if (words !== "") byId("status").textContent = `${words} ${t("edit.set", { kind: kindText(fps.kind, fps.vertices.length) })}`;
  writeAddressSoon(bench);
}

/**
 * A reading that was added in the picture has the focus there as soon as it is drawn.
 * @param {Workbench} bench
 */
function focusNew(bench) {
  const row = bench.focusOn;
  if (row === null || !bench.store.lesson().rowIndex.has(row)) return;
  bench.focusOn = null;
  bench.store.change({ selection: { kind: "reading", row } });
  drawnAt(byId("data-plane"), row)?.focus();
}

/** @param {Workbench} bench */
function drawEditor(bench) {
  const { session, isOpen, isBlank, pending } = bench;
  const sheet = session.sheet();
  const problem = session.problem();
  // A reading that the engine refused is not waited for.
  if (problem !== null) bench.focusOn = null;
  const editor = byId("editor");
  editor.dataset.busy = `${session.isBusy() || bench.following !== null}`;
  watchTime(bench, sheet);
  /** @type {HTMLElement} */ (byId("readings").parentElement).hidden = isOpen;
  drawTools(bench);
  const isChanged = !isSameSheet(sheet, bench.own);
  // Beside what it is about, where that is shown.
  const isApart = problem !== null && !(isOpen && (problem.row !== null || problem.key !== null));
  const wasRight = document.getElementById("sheet-problem") === null;
  patch(editor, [
    element(
      "p",
      { class: "buttons" },
      element("button", { type: "button", id: "edit-toggle", "aria-pressed": `${isOpen}`, hidden: isBlank && usedRows(sheet).length === 0 }, t("edit.edit")),
      element("button", { type: "button", id: "edit-back", hidden: !isChanged }, t(isBlank ? "edit.back-blank" : "edit.back")),
      element("button", { type: "button", id: "edit-example", hidden: !isBlank || usedRows(sheet).length > 0 }, t("edit.example")),
      element("small", { id: "edit-changed", hidden: !isChanged || isBlank }, t("edit.changed")),
      element("small", { id: "edit-busy", hidden: !bench.isSlow }, t("edit.busy")),
    ),
    element("p", { id: "edit-notice", class: "problem", role: "alert", hidden: bench.notice === null }, bench.notice?.() ?? ""),
    element("p", { id: "edit-problem", hidden: !isApart }, isApart && problem !== null ? problemNote(problem) : ""),
    element("p", { id: "edit-taken", hidden: bench.taken === null }, element("small", {}, bench.taken === null ? "" : notesOf(bench.taken))),
    element("div", { id: "edit-import" }, pending === null ? null : importForm(pending)),
    element("div", { id: "edit-open", hidden: !isOpen }, isOpen ? openParts(bench) : []),
    exportParts(bench),
  ]);
  if (wasRight) document.getElementById("sheet-problem")?.scrollIntoView({ block: "nearest" });
}

/**
 * Says that the engine is at work where it takes long.
 * @param {Workbench} bench
 * @param {Sheet} sheet
 */
function watchTime(bench, sheet) {
  const { session } = bench;
  if (!session.isBusy()) bench.isSlow = false;
  if (!session.isBusy() || bench.isSlow) return;
  setTimeout(() => {
    if (!session.isBusy() || sheet !== session.sheet() || bench.isSlow) return;
    bench.isSlow = true;
    bench.draw();
  }, MILLISECONDS_UNTIL_SLOW);
}

/** @param {Workbench} bench */
function drawTools({ session, store }) {
  /** @param {string} id @param {boolean} can @param {string} sign */
  const step = (id, can, sign) =>
    element("button", { type: "button", id, "data-edit": id, "aria-label": t(`edit.${id}`), title: t(`edit.${id}`), "aria-disabled": `${!can}` }, sign);
  const { isLine, readings } = store.lesson();
  patch(byId("edit-tools"), [
    element("button", { type: "button", "data-edit": "add", "aria-label": t("edit.add"), disabled: !isLine || readings.length === 0 }, t("edit.add-short")),
    step("undo", session.canUndo(), "↶"),
    step("redo", session.canRedo(), "↷"),
  ]);
  byId("edit-tools").setAttribute("aria-label", t("edit.tools"));
  byId("edit-keys").textContent = t("edit.keys");
}

/** @param {Workbench} bench */
function openParts({ session, store, typing, isBlank }) {
  const [sheet, problem, { selection }] = [session.sheet(), session.problem(), store.get()];
  return [
    questionForm(sheet, problem, typing),
    element("div", { class: "scroll tall" }, grid(sheet, problem, typing, selection?.kind === "reading" ? selection.row : null)),
    element("p", { class: "buttons" }, element("button", { type: "button", id: "add-reading", "data-edit": "add-row" }, t("edit.add"))),
    element(
      "details",
      { id: "paste", open: isBlank },
      element("summary", {}, t("edit.paste-open")),
      element("p", {}, element("small", {}, t("edit.paste-hint"))),
      element("textarea", { id: "paste-text", rows: 5, "aria-label": t("edit.paste-label"), spellcheck: "false" }),
      element(
        "p",
        { class: "buttons" },
        element("button", { type: "button", id: "paste-use" }, t("edit.paste-use")),
        element("label", { class: "file" }, t("edit.open"), " ", element("input", { type: "file", id: "open-file" })),
      ),
    ),
  ];
}

/** @param {Workbench} bench */
function exportParts({ link, session, isBlank, store }) {
  const isEmpty = isBlank && store.lesson().readings.length === 0;
  const command = commandOf(session.right(), FILE_NAME);
  return element(
    "details",
    { id: "export", hidden: isEmpty },
    element("summary", {}, t("edit.export")),
    element("p", { class: "buttons" }, EXPORTS.map((kind) => element("button", { type: "button", "data-export": kind }, t(`edit.export.${kind}`)))),
    element("p", { hidden: command === null }, t("edit.command"), " ", element("code", { id: "command" }, command ?? "")),
    element(
      "p",
      {},
      element("label", {}, t("edit.link"), " ", element("input", { type: "text", id: "link", readonly: true, value: link ?? "" })),
      " ",
      element("small", { id: "link-note" }, link === null ? t("edit.link-too-long") : t("edit.link-hint")),
    ),
  );
}
