// @ts-check
// What the controls of the editor do to the sheet.

import { byId } from "../dom.js";
import { measuredAt } from "./drag.js";
import { columnsOf, guessed, imported } from "./importing.js";
import { typedIn } from "./marks.js";
import { movedSheet, newCells } from "./moving.js";
import { refusalOf, sentenceOfTable } from "./refusals.js";
import { isSameSheet, usedRows, withCell, withFitted, withRequest, withoutRowAt } from "./sheet.js";
import { cellText, withMark } from "../model/table.js";
import { hasDecimalComma, numberText, t } from "../texts.js";

/** In megabytes. */
const LARGEST_FILE = 16;
/** A spring: what is hung on it, and how far it stretches. */
const EXAMPLE_CELLS = [["0", "0.1"], ["1", "1.9"], ["2", "3.8"], ["3", "6.3"], ["4", "7.9"], ["5", "10.2"]];
const EXAMPLE_BOUND = "0.3";

/**
 * Where in the sheet a reading of the picture is; -1 where it is no longer there. The sheet may be ahead of the picture, and while the
 * engine refuses it, it stays so.
 * @param {Session} session
 * @param {number} row the number of the reading
 */
function placeOfReading(session, row) {
  const [sheet, shown] = [session.sheet(), session.right()];
  const at = usedRows(shown)[row - 1];
  if (at === undefined) return -1;
  // Rows that nobody has changed are the same objects.
  const same = sheet.rows.indexOf(shown.rows[at]);
  return same < 0 && sheet.rows.length >= shown.rows.length ? at : same;
}

/**
 * What can be done to readings in the picture; rows are numbers of readings.
 * @param {Workbench} bench
 * @returns {ReadingEdits}
 */
export function readingEdits({ session, store }) {
  return {
    move(row, x, y, key) {
      const sheet = session.sheet();
      const at = placeOfReading(session, row);
      if (at < 0) return;
      const next = movedSheet(sheet, at, x, y, store.lesson(), row);
      if (isSameSheet(next, sheet)) return;
      const place = [x, y].flatMap((value) => (value === null ? [] : [numberText(cellText(value))])).join("; ");
      session.edit(next, t("edit.did.move", { row, place }), key);
    },
    settle: session.settle,
    remove(row) {
      const at = placeOfReading(session, row);
      if (at >= 0) session.edit(withoutRowAt(session.sheet(), at), t("edit.did.delete", { row }));
    },
    add(x, y) {
      const sheet = session.sheet();
      const longer = { ...sheet, rows: [...sheet.rows, { cells: newCells(sheet), isFitted: true }] };
      session.edit(movedSheet(longer, sheet.rows.length, x, y, store.lesson(), null), t("edit.did.add"));
    },
  };
}

/**
 * The buttons that are there at any time.
 * @param {Workbench} bench
 * @param {string} what
 */
export function press(bench, what) {
  const { session } = bench;
  [bench.notice, bench.taken] = [null, null];
  bench.typing = null;
  if (what === "undo") session.undo(t("edit.did.undo"));
  else if (what === "redo") session.redo(t("edit.did.redo"));
  else if (what === "add") addInView(bench);
  else addRow(bench);
}

/**
 * A reading in the middle of the picture, to be moved to its place.
 * @param {Workbench} bench
 */
function addInView(bench) {
  const { session, store, current } = bench;
  const { dataMap } = current();
  const { view } = dataMap;
  const middle = dataMap.to([(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2]);
  const { x, y } = measuredAt(store.lesson(), store.get(), dataMap, middle, null);
  if (x === null) return;
  bench.focusOn = usedRows(session.sheet()).length + 1;
  readingEdits(bench).add(x, y);
}

/**
 * A row to type into.
 * @param {Workbench} bench
 */
export function addRow({ session }) {
  const sheet = session.sheet();
  session.edit({ ...sheet, rows: [...sheet.rows, { cells: newCells(sheet), isFitted: true }] }, "");
  /** @type {HTMLElement | null} */ (byId("editor").querySelector(`[data-cell="${sheet.rows.length} 0"]`))?.focus();
}

/** @param {Workbench} bench */
export function takeExample({ session, own }) {
  /** @type {DecimalMark} */
  const mark = hasDecimalComma() ? "comma" : "point";
  const rows = EXAMPLE_CELLS.map((cells) => ({ cells: cells.map((cell) => withMark(cell, mark)), isFitted: true }));
  session.edit(withRequest({ ...own, rows }, { eps: EXAMPLE_BOUND }), t("edit.did.example"));
}

/**
 * Takes what was typed into a cell.
 * @param {Workbench} bench
 * @param {PageElement} input
 */
export function commitCell(bench, input) {
  const [at, k] = (input.dataset.cell ?? "").split(" ").map(Number);
  const before = bench.session.sheet();
  const typed = input.value.trim();
  bench.typing = null;
  if (before.rows[at]?.cells[k] === typed) return bench.draw();
  const { sheet, text: value } = typedIn(before, typed);
  const next = withCell(sheet, at, k, value);
  bench.session.edit(next, t("edit.did.cell", { column: sheet.columns[k], row: numberAt(next, at), value }));
}

/**
 * @param {Workbench} bench
 * @param {number} at
 */
export function deleteAt({ session }, at) {
  session.edit(withoutRowAt(session.sheet(), at), t("edit.did.delete", { row: numberAt(session.sheet(), at) }));
}

/**
 * @param {Workbench} bench
 * @param {number} at
 * @param {boolean} isFitted
 */
export function fitAt({ session }, at, isFitted) {
  session.edit(withFitted(session.sheet(), at, isFitted), t(isFitted ? "edit.did.fit" : "edit.did.unfit", { row: numberAt(session.sheet(), at) }));
}

/**
 * The number of the reading in a row of the sheet; a dash for a row that is none yet.
 * @param {Sheet} sheet
 * @param {number} at
 */
function numberAt(sheet, at) {
  const number = usedRows(sheet).indexOf(at);
  return number < 0 ? "–" : `${number + 1}`;
}

/**
 * Begins to take a table; at once where it is clear which column is which.
 * @param {Workbench} bench
 * @param {string | Uint8Array} table
 * @param {string | null} file null for a table that was pasted
 */
export async function startImport(bench, table, file) {
  [bench.notice, bench.taken] = [null, null];
  try {
    const { columns, header, numeric, table: notes } = await columnsOf(bench.engine, table, file, {});
    const { choice, isSure } = guessed(columns, numeric, bench.session.sheet());
    bench.pending = { table, file, columns, hasHeader: header, notes, choice, how: {}, skip: false, problem: null };
    if (isSure) return await applyImport(bench);
  } catch (error) {
    bench.notice = () => t("problem-at.file", { file: file ?? t("edit.pasted"), problem: sentenceOfTable(refusalOf(error)) });
  }
  bench.draw();
  showImport();
}

/**
 * Looks at the table once more, since the reader has said how it is written.
 * @param {Workbench} bench
 * @param {Record<string, any>} how
 */
export async function readAgain(bench, how) {
  const from = bench.pending;
  if (from === null) return;
  bench.pending = { ...from, how };
  const asked = bench.pending;
  try {
    const { columns, header, numeric, table: notes } = await columnsOf(bench.engine, from.table, from.file, how);
    const isSame = `${columns}` === `${from.columns}`;
    const choice = isSame ? asked.choice : guessed(columns, numeric, bench.session.sheet()).choice;
    if (bench.pending === asked) bench.pending = { ...asked, columns, hasHeader: header, notes, choice, problem: null };
  } catch (error) {
    if (bench.pending === asked) bench.pending = { ...asked, problem: refusalOf(error) };
  }
  bench.draw();
}

/** Brings the form, or why there is none, into sight: it stands above what it was asked for with. */
function showImport() {
  const form = document.getElementById("import");
  (document.getElementById("import-problem") ?? form ?? byId("edit-notice")).scrollIntoView({ block: "nearest" });
  if (form === null || form.contains(document.activeElement)) return;
  form.scrollIntoView({ block: "nearest" });
  form.querySelector("select")?.focus({ preventScroll: true });
}

/**
 * Takes the table with the columns that are chosen.
 * @param {Workbench} bench
 */
export async function applyImport(bench) {
  const from = bench.pending;
  if (from === null) return;
  try {
    const { sheet, notes } = await imported(bench.engine, from, bench.session.sheet());
    if (bench.pending !== from) return;
    // The engine makes a lesson of names alone, for the empty page; here they would take the place of readings.
    if (sheet.rows.length === 0) throw Object.assign(new Error(), { refusal: { kind: "no-rows", words: "" } });
    bench.pending = null;
    bench.taken = notes;
    bench.session.edit(sheet, from.file === null ? t("edit.did.import-pasted") : t("edit.did.import", { file: from.file }));
  } catch (error) {
    if (bench.pending === from) bench.pending = { ...from, problem: refusalOf(error) };
  }
  bench.draw();
  if (bench.pending !== null) showImport();
}

/**
 * @param {Workbench} bench
 * @param {File} file
 */
export async function readFile(bench, file) {
  const isSmall = file.size <= LARGEST_FILE * 1e6;
  // A folder that is dropped looks like a file, but has no content.
  const content = isSmall ? await file.arrayBuffer().catch(() => null) : null;
  if (content !== null) return startImport(bench, new Uint8Array(content), file.name);
  bench.notice = () => t(isSmall ? "edit.unreadable" : "edit.too-large", { file: file.name, count: LARGEST_FILE });
  bench.draw();
}
