// @ts-check
// The editor of the readings: its controls, and what they do to the sheet. There where the page has the engine.
//
// Names that tests and bookmarks may rely on:
//   #edit-toggle                 shows the cells in place of the table;  #undo #redo #edit-back
//   [data-cell="0 1"]            row and column of the sheet, from 0;  [data-fitted="0"] [data-delete="0"] #add-reading
//   #bounds-kind #eps #where #through-origin;  #sheet-problem is the engine's message, beside what it is about
//   #paste-text #paste-use #open-file;  #import with #import-x …, #import-apply, #import-cancel
//   [data-export="csv|text|latex|json|data-svg|data-png|parameter-svg|parameter-png"]  #command  #link
//   #editor[data-busy]           "true" while the engine computes

import { byId, closest, element, patch, targetOf } from "../dom.js";
import { connectDragging, drawnAt, measuredAt } from "./drag.js";
import { download, inPixels, standalone } from "./export.js";
import { fragmentOf, sheetOfFragment } from "./fragment.js";
import { columnsOf, guessed, importForm, imported } from "./importing.js";
import { grid, problemNote } from "./grid.js";
import { movedSheet, newCells } from "./moving.js";
import { askedBy, questionForm } from "./question-form.js";
import { createSession } from "./session.js";
import { commandOf, csvOf, optionsOf, sheetOf, usedRows, withBlock, withCell, withFitted, withoutRowAt } from "./sheet.js";
import { cellText } from "../model/table.js";
import { readLesson } from "../model/lesson.js";
import { kindText } from "../model/format.js";
import { Rational } from "../model/rational.js";
import { t } from "../texts.js";

const FILE_NAME = "readings.csv";
const LARGEST_FILE = 16;
/** An address is not changed more often: browsers refuse that. */
const MILLISECONDS_PER_ADDRESS = 400;
const REPORTS = ["text", "latex", "json"];
const EXPORTS = ["csv", ...REPORTS, "data-svg", "data-png", "parameter-svg", "parameter-png"];
/** @type {Record<string, string>} */
const ENDINGS = { text: "txt", latex: "tex", json: "json" };

/**
 * Connects the editor.
 * @param {Engine} engine
 * @param {Store} store
 * @param {() => Drawn} current
 * @returns {Editor}
 */
export function connectEditor(engine, store, current) {
  const own = sheetOf(store.lesson().data);
  let isOpen = false;
  /** @type {{ place: string, text: string } | null} */
  let typing = null;
  /** @type {import("./importing.js").Import | null} */
  let pending = null;
  let notice = "";
  /** @type {string | null} */
  let link = null;
  let command = "";
  /** @type {ReturnType<typeof setTimeout> | null} */
  let timer = null;
  const session = createSession(engine, own, { onLesson: take, onChange: draw });

  /** @param {LessonData} data @param {Sheet} sheet @param {string} words */
  function take(data, sheet, words) {
    store.replace(readLesson(data));
    const { fps } = store.lesson();
    if (words !== "") byId("status").textContent = `${words} ${t("edit.set", { kind: kindText(fps.kind, fps.vertices.length) })}`;
    command = commandOf(sheet, FILE_NAME);
    if (timer === null) timer = setTimeout(writeAddress, MILLISECONDS_PER_ADDRESS);
  }

  async function writeAddress() {
    timer = null;
    const sheet = session.right();
    const fragment = isSameSheet(sheet, own) ? "" : await fragmentOf(sheet);
    if (sheet !== session.right()) return;
    const { pathname, search } = location;
    history.replaceState(null, "", fragment ? fragment : `${pathname}${search}`);
    link = fragment === null ? null : location.href;
    draw();
  }

  async function readAddress() {
    const found = await sheetOfFragment(location.hash);
    if (found === null) return;
    if (found instanceof Error) notice = t(found.message === "version" ? "edit.link-version" : "edit.link-damaged");
    else if (!isSameSheet(found, session.right())) session.edit(found, t("edit.did.link"));
    draw();
  }

  function draw() {
    const sheet = session.sheet();
    const isChanged = !isSameSheet(sheet, own);
    const { selection } = store.get();
    byId("editor").dataset.busy = `${session.isBusy()}`;
    const table = /** @type {HTMLElement} */ (byId("readings").parentElement);
    table.hidden = isOpen;
    patch(byId("edit-tools"), [
      element("button", { type: "button", "data-edit": "add", "aria-label": t("edit.add"), disabled: !store.lesson().isLine }, t("edit.add-short")),
      element("button", { type: "button", id: "undo", "data-edit": "undo", "aria-label": t("edit.undo"), title: t("edit.undo"), "aria-disabled": `${!session.canUndo()}` }, "↶"),
      element("button", { type: "button", id: "redo", "data-edit": "redo", "aria-label": t("edit.redo"), title: t("edit.redo"), "aria-disabled": `${!session.canRedo()}` }, "↷"),
    ]);
    byId("edit-tools").setAttribute("aria-label", t("edit.tools"));
    byId("edit-keys").textContent = t("edit.keys");
    const problem = session.problem();
    // Beside what it is about, where that is shown.
    const isApart = problem !== null && !(isOpen && (problem.row !== null || problem.key !== null));
    patch(byId("editor"), [
      element(
        "p",
        { class: "buttons" },
        element("button", { type: "button", id: "edit-toggle", "aria-pressed": `${isOpen}` }, t("edit.edit")),
        element("button", { type: "button", id: "edit-back", hidden: !isChanged }, t("edit.back")),
        element("small", { id: "edit-changed", hidden: !isChanged }, t("edit.changed")),
      ),
      element("p", { id: "edit-notice", class: "problem", role: "alert", hidden: notice === "" }, notice),
      element("p", { id: "edit-problem", hidden: !isApart }, isApart && problem !== null ? problemNote(problem) : ""),
      element("div", { id: "edit-import" }, pending === null ? null : importForm(pending)),
      element("div", { id: "edit-open", hidden: !isOpen }, isOpen ? openParts(sheet, problem, selection) : []),
      exportParts(),
    ]);
  }

  /** @param {Sheet} sheet @param {Problem | null} problem @param {Choice | null} selection */
  function openParts(sheet, problem, selection) {
    return [
      questionForm(sheet, problem, typing),
      element("div", { class: "scroll tall" }, grid(sheet, problem, typing, selection?.kind === "reading" ? selection.row : null)),
      element("p", { class: "buttons" }, element("button", { type: "button", id: "add-reading", "data-edit": "add-row" }, t("edit.add"))),
      element(
        "details",
        { id: "paste" },
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

  function exportParts() {
    return element(
      "details",
      { id: "export" },
      element("summary", {}, t("edit.export")),
      element("p", { class: "buttons" }, EXPORTS.map((kind) => element("button", { type: "button", "data-export": kind }, t(`edit.export.${kind}`)))),
      element("p", {}, t("edit.command"), " ", element("code", { id: "command" }, command)),
      element(
        "p",
        {},
        element("label", {}, t("edit.link"), " ", element("input", { type: "text", id: "link", readonly: true, value: link ?? "" })),
        " ",
        element("small", { id: "link-note" }, link === null ? t("edit.link-too-long") : t("edit.link-hint")),
      ),
    );
  }

  const edits = {
    /** @param {number} row @param {Rational | null} x @param {Rational} y @param {string} key */
    move(row, x, y, key) {
      const sheet = session.sheet();
      const at = usedRows(sheet)[row - 1];
      if (at === undefined) return;
      const next = movedSheet(sheet, at, x, y, store.lesson());
      if (isSameSheet(next, sheet)) return;
      const place = x === null ? cellText(y) : `${cellText(x)}, ${cellText(y)}`;
      session.edit(next, t("edit.did.move", { row, place }), key);
    },
    settle() {
      session.settle();
    },
    /** @param {number} row */
    remove(row) {
      const at = usedRows(session.sheet())[row - 1];
      if (at !== undefined) session.edit(withoutRowAt(session.sheet(), at), t("edit.did.delete", { row }));
    },
    /** @param {Rational} x @param {Rational} y */
    add(x, y) {
      const sheet = session.sheet();
      const at = sheet.rows.length;
      const template = { ...sheet, rows: [...sheet.rows, { cells: newCells(sheet), isFitted: true }] };
      session.edit(movedSheet(template, at, x, y, store.lesson()), t("edit.did.add"));
    },
  };

  /** @param {string} what */
  function press(what) {
    notice = "";
    typing = null;
    if (what === "undo") session.undo(t("edit.did.undo"));
    else if (what === "redo") session.redo(t("edit.did.redo"));
    else if (what === "add") addInView();
    else addRow();
  }

  // A reading in the middle of the picture, to be dragged to its place.
  function addInView() {
    const { dataMap } = current();
    const { view } = dataMap;
    const [x, y] = [Rational.fromNumber((view.x[0] + view.x[1]) / 2), Rational.fromNumber((view.y[0] + view.y[1]) / 2)];
    const place = measuredCentre(store, dataMap, x, y);
    edits.add(place.x, place.y);
    pendingFocus = usedRows(session.sheet()).length;
  }
  /** @type {number | null} */
  let pendingFocus = null;
  store.subscribe((state, before) => {
    if (state.selection !== before.selection || state.language !== before.language) draw();
    if (pendingFocus === null || !store.lesson().rowIndex.has(pendingFocus)) return;
    const row = pendingFocus;
    pendingFocus = null;
    store.change({ selection: { kind: "reading", row } });
    drawnAt(byId("data-plane"), row)?.focus();
  });

  function addRow() {
    const sheet = session.sheet();
    session.edit({ ...sheet, rows: [...sheet.rows, { cells: newCells(sheet), isFitted: true }] }, "");
    byId("editor").querySelector(`[data-cell="${sheet.rows.length} 0"]`)?.scrollIntoView({ block: "nearest" });
    /** @type {HTMLElement | null} */ (byId("editor").querySelector(`[data-cell="${sheet.rows.length} 0"]`))?.focus();
  }

  /** @param {PageElement} input */
  function commitCell(input) {
    const [at, k] = (input.dataset.cell ?? "").split(" ").map(Number);
    typing = null;
    const sheet = session.sheet();
    if (sheet.rows[at]?.cells[k] === input.value) return draw();
    const number = usedRows(sheet).indexOf(at);
    const row = number < 0 ? "–" : `${number + 1}`;
    session.edit(withCell(sheet, at, k, input.value.trim()), t("edit.did.cell", { column: sheet.columns[k].name, row, value: input.value }));
  }

  /** @param {string | Uint8Array} table @param {string} file */
  async function start(table, file) {
    notice = "";
    try {
      const columns = await columnsOf(engine, table, file);
      const { choice, isSure } = guessed(columns, session.sheet());
      pending = { table, file, columns, choice, skip: false, problem: null };
      if (isSure) return apply();
    } catch (error) {
      notice = error instanceof Error ? error.message : `${error}`;
    }
    draw();
  }

  async function apply() {
    const from = pending;
    if (from === null) return;
    try {
      const sheet = await imported(engine, from, session.sheet());
      if (pending !== from) return;
      pending = null;
      session.edit(sheet, t("edit.did.import", { file: from.file }));
      if (document.activeElement === document.body) byId("edit-toggle").focus();
    } catch (error) {
      pending = { ...from, problem: error instanceof Error ? error.message : `${error}` };
    }
    draw();
  }

  /** @param {File} file */
  async function read(file) {
    if (file.size > LARGEST_FILE * 1e6) {
      notice = t("edit.too-large", { file: file.name, count: LARGEST_FILE });
      return draw();
    }
    start(new Uint8Array(await file.arrayBuffer()), file.name);
  }

  /** @param {string} kind */
  async function exported(kind) {
    const sheet = session.right();
    notice = "";
    try {
      if (kind === "csv") return download(FILE_NAME, new Blob([csvOf(sheet)], { type: "text/csv" }));
      if (REPORTS.includes(kind)) {
        const report = await engine.ask("run", csvOf(sheet), { ...reportOptions(sheet), format: kind });
        return download(["report", ENDINGS[kind]].join("."), new Blob([report], { type: "text/plain" }));
      }
      const [plane, type] = kind.split("-");
      const svg = /** @type {SVGElement} */ (/** @type {unknown} */ (byId(`${plane}-plane`)));
      download(`${plane}-plane.${type}`, type === "svg" ? new Blob([standalone(svg).text], { type: "image/svg+xml" }) : await inPixels(svg));
    } catch (error) {
      notice = error instanceof Error ? error.message : `${error}`;
      draw();
    }
  }

  byId("edit-tools").addEventListener("click", (event) => {
    const what = closest(event, "[data-edit]")?.dataset.edit;
    if (what !== undefined) press(what);
  });
  const editor = byId("editor");
  editor.addEventListener("click", (event) => {
    const button = closest(event, "button");
    if (button === null) return;
    const { id, dataset } = button;
    if (dataset.edit !== undefined) press(dataset.edit);
    else if (dataset.delete !== undefined) {
      const at = Number(dataset.delete);
      const number = usedRows(session.sheet()).indexOf(at);
      session.edit(withoutRowAt(session.sheet(), at), number < 0 ? "" : t("edit.did.delete", { row: number + 1 }));
    } else if (dataset.export !== undefined) exported(dataset.export);
    else if (id === "edit-toggle") {
      isOpen = !isOpen;
      draw();
    } else if (id === "edit-back") {
      notice = "";
      session.edit(own, t("edit.did.back"));
    } else if (id === "paste-use") start(byId("paste-text").value, t("edit.pasted"));
    else if (id === "import-apply") apply();
    else if (id === "import-cancel") {
      pending = null;
      draw();
    }
  });
  editor.addEventListener("input", (event) => {
    const { dataset, id, value } = targetOf(event);
    const place = dataset.cell ?? (["eps", "where"].includes(id) ? id : null);
    if (place !== null) typing = { place, text: value };
  });
  editor.addEventListener("change", (event) => {
    const input = targetOf(event);
    const sheet = session.sheet();
    if (input.dataset.cell !== undefined) return commitCell(input);
    if (input.dataset.fitted !== undefined) {
      const at = Number(input.dataset.fitted);
      const row = usedRows(sheet).indexOf(at) + 1;
      return session.edit(withFitted(sheet, at, input.checked), t(input.checked ? "edit.did.fit" : "edit.did.unfit", { row: row === 0 ? "–" : row }));
    }
    if (input.dataset.purpose !== undefined && pending !== null) {
      pending = { ...pending, choice: { ...pending.choice, [input.dataset.purpose]: input.value } };
      return draw();
    }
    if (input.id === "import-skip" && pending !== null) pending = { ...pending, skip: input.checked };
    const file = input.id === "open-file" ? input.files?.[0] : undefined;
    if (file !== undefined) {
      read(file);
      // The same file may be opened once more.
      input.value = "";
    }
    const changed = askedBy(input, sheet, store.lesson());
    if (changed === null) return;
    typing = null;
    session.edit(changed, t("edit.did.question"));
  });
  editor.addEventListener("focusin", (event) => {
    const at = closest(event, "[data-sheet-row]")?.dataset.sheetRow;
    const row = at === undefined ? 0 : usedRows(session.sheet()).indexOf(Number(at)) + 1;
    const { selection } = store.get();
    const isChosen = selection?.kind === "reading" && selection.row === row;
    if (!isChosen && store.lesson().rowIndex.has(row) && session.problem() === null) store.change({ selection: { kind: "reading", row } });
    if (targetOf(event).id === "link") targetOf(event).select();
  });
  editor.addEventListener("keydown", (event) => {
    const place = targetOf(event).dataset.cell;
    const [at, k] = (place ?? "").split(" ").map(Number);
    const by = event.key === "Enter" || event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    if (place === undefined || by === 0) return;
    event.preventDefault();
    const input = targetOf(event);
    if (typing !== null) commitCell(input);
    if (event.key === "Enter" && at + 1 === session.sheet().rows.length) return addRow();
    /** @type {PageElement | null} */ (editor.querySelector(`[data-cell="${at + by} ${k}"]`))?.focus();
  });
  editor.addEventListener("paste", (event) => {
    const place = targetOf(event).dataset.cell;
    const text = event.clipboardData?.getData("text/plain") ?? "";
    const block = text.replace(/\r\n?/g, "\n").replace(/\n$/, "").split("\n").map((line) => line.split("\t"));
    if (place === undefined || (block.length === 1 && block[0].length === 1)) return;
    event.preventDefault();
    typing = null;
    const [at, k] = place.split(" ").map(Number);
    const isTable = at === 0 && k === 0 && block[0].every((cell) => /[a-zα-ω]{2}|^[a-z]$/i.test(cell.trim()) && !/^[-+]?[\d.,]+e[-+]?\d+$/i.test(cell.trim()));
    const isText = block.every((line) => line.length === 1) && /[;,]/.test(block[0][0]) && session.sheet().columns.length > 1;
    if (isTable || isText) start(text, t("edit.pasted"));
    else session.edit(withBlock(session.sheet(), at, k, block.map((line) => line.map((cell) => cell.trim()))), t("edit.did.block"));
  });
  addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || !["z", "y"].includes(key)) return;
    // What is being typed has an undo of its own.
    const isTyping = typing !== null || targetOf(event).localName === "textarea";
    if (isTyping) return;
    event.preventDefault();
    press(key === "y" || event.shiftKey ? "redo" : "undo");
  });
  addEventListener("dragover", (event) => {
    if (event.dataTransfer?.types.some((type) => ["files", "text/plain"].includes(type.toLowerCase()))) event.preventDefault();
  });
  addEventListener("drop", (event) => {
    const file = event.dataTransfer?.files[0];
    const text = event.dataTransfer?.getData("text/plain") ?? "";
    if (file === undefined && !text.includes("\n")) return;
    event.preventDefault();
    if (file !== undefined) read(file);
    else start(text, t("edit.pasted"));
  });
  addEventListener("hashchange", readAddress);
  connectDragging(byId("data-plane"), store, current, edits);
  byId("edit-tools").hidden = false;
  command = commandOf(own, FILE_NAME);
  link = location.href;
  draw();
  readAddress();
  return {
    sheet: session.sheet,
    problem: session.problem,
    settled: session.settled,
    edit: (sheet) => session.edit(sheet, ""),
    undo: () => session.undo(""),
    csvOf,
    csv: () => csvOf(session.right()),
    command: () => commandOf(session.right(), FILE_NAME),
    options: () => reportOptions(session.right()),
  };
}

/**
 * Whether two sheets say the same.
 * @param {Sheet} one
 * @param {Sheet} other
 */
function isSameSheet(one, other) {
  return one === other || JSON.stringify(one) === JSON.stringify(other);
}

/**
 * What the report is asked for: the page's title and units are not part of it.
 * @param {Sheet} sheet
 */
export function reportOptions(sheet) {
  const { title, x_unit, y_unit, max_readings, file, ...options } = optionsOf(sheet);
  return { ...options, file: FILE_NAME };
}

/**
 * The middle of the picture as a reading with short decimals.
 * @param {Store} store
 * @param {ScreenMap} map
 * @param {Rational} u
 * @param {Rational} v
 */
function measuredCentre(store, map, u, v) {
  const at = map.to([u.toNumber(), v.toNumber()]);
  const { x, y } = measuredAt(store.lesson(), store.get(), map, at, null);
  return { x: x ?? u, y };
}
