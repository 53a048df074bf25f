// @ts-check
// The editor's controls: buttons, cells, keys, the clipboard, files that are dropped.

import { byId, closest, targetOf } from "../dom.js";
import { addRow, applyImport, commitCell, deleteAt, fitAt, press, readAgain, readFile, startImport, takeExample } from "./actions.js";
import { isElsewhere } from "./address.js";
import { takeAway } from "./export.js";
import { withWay } from "./importing.js";
import { typedIn } from "./marks.js";
import { askedBy } from "./question-form.js";
import { refusalOf, sentenceOf } from "./refusals.js";
import { usedRows, withBlock } from "./sheet.js";
import { t } from "../texts.js";

// A number with an exponent or a unit begins with a digit; names such as U1 and CO2 have theirs after a letter.
const NAME = /^[^\p{L}\d.,]*\p{L}/u;

/**
 * Connects the controls.
 * @param {Workbench} bench
 */
export function connectControls(bench) {
  const editor = byId("editor");
  byId("edit-tools").addEventListener("click", (event) => {
    const what = closest(event, "[data-edit]")?.dataset.edit;
    if (what !== undefined) press(bench, what);
  });
  editor.addEventListener("click", (event) => {
    const button = closest(event, "button");
    if (button !== null) onButton(bench, button);
  });
  editor.addEventListener("input", (event) => {
    const { dataset, id, value } = targetOf(event);
    const place = dataset.cell ?? (["eps", "where"].includes(id) ? id : null);
    if (place !== null) bench.typing = { place, text: value };
  });
  editor.addEventListener("change", (event) => onInput(bench, targetOf(event)));
  // Whoever comes back to what stood there before has changed nothing.
  editor.addEventListener("focusout", (event) => {
    if (bench.typing === null || !targetOf(event).isConnected) return;
    bench.typing = null;
    bench.draw();
  });
  editor.addEventListener("focusin", (event) => onFocus(bench, event));
  editor.addEventListener("keydown", (event) => onCellKey(bench, event));
  editor.addEventListener("paste", (event) => onPaste(bench, event));
  addEventListener("keydown", (event) => onUndoKey(bench, event));
  connectDropping(bench);
}

/**
 * @param {Workbench} bench
 * @param {PageElement} button
 */
function onButton(bench, { id, dataset }) {
  if (dataset.edit !== undefined) return press(bench, dataset.edit);
  if (dataset.delete !== undefined) return deleteAt(bench, Number(dataset.delete));
  if (dataset.export !== undefined) return exported(bench, dataset.export);
  bench.notice = null;
  if (id !== "edit-toggle") bench.taken = null;
  if (id === "edit-toggle") bench.isOpen = !bench.isOpen;
  else if (id === "edit-back") bench.session.edit(bench.own, t("edit.did.back"));
  else if (id === "edit-example") takeExample(bench);
  else if (id === "paste-use") startImport(bench, byId("paste-text").value, null);
  else if (id === "import-apply") applyImport(bench);
  else if (id === "import-cancel") bench.pending = null;
  bench.draw();
}

/**
 * @param {Workbench} bench
 * @param {string} kind
 */
async function exported(bench, kind) {
  bench.notice = null;
  await takeAway(bench.engine, bench.session.right(), kind).catch((error) => {
    bench.notice = () => sentenceOf(refusalOf(error));
  });
  bench.draw();
}

/**
 * @param {Workbench} bench
 * @param {PageElement} input
 */
function onInput(bench, input) {
  const { dataset, id, value, checked } = input;
  const { session, store, pending } = bench;
  if (dataset.cell !== undefined) return commitCell(bench, input);
  if (dataset.fitted !== undefined) return fitAt(bench, Number(dataset.fitted), checked);
  if (dataset.purpose !== undefined && pending !== null) bench.pending = { ...pending, choice: { ...pending.choice, [dataset.purpose]: value } };
  if (dataset.way !== undefined && pending !== null) readAgain(bench, withWay(pending.how, dataset.way, input.type === "checkbox" ? checked : value));
  if (id === "import-skip" && pending !== null) bench.pending = { ...pending, skip: checked };
  const file = id === "open-file" ? input.files?.[0] : undefined;
  if (file !== undefined) {
    readFile(bench, file);
    // The same file may be opened once more.
    input.value = "";
  }
  const asked = askedBy(input, session.sheet(), store.lesson());
  if (asked !== null) {
    bench.typing = null;
    session.edit(asked, t("edit.did.question"));
  }
  bench.draw();
}

/**
 * The reading whose cells have the focus is the one that is chosen.
 * @param {Workbench} bench
 * @param {Event} event
 */
function onFocus({ session, store }, event) {
  if (targetOf(event).id === "link") targetOf(event).select();
  const at = closest(event, "[data-sheet-row]")?.dataset.sheetRow;
  if (at === undefined || session.problem() !== null) return;
  const row = usedRows(session.sheet()).indexOf(Number(at)) + 1;
  const { selection } = store.get();
  const isChosen = selection?.kind === "reading" && selection.row === row;
  if (!isChosen && store.lesson().rowIndex.has(row)) store.change({ selection: { kind: "reading", row } });
}

/**
 * Enter and the arrows go from cell to cell; Enter in the last row makes another one.
 * @param {Workbench} bench
 * @param {KeyboardEvent} event
 */
function onCellKey(bench, event) {
  const input = targetOf(event);
  const by = event.key === "Enter" || event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
  if (input.dataset.cell === undefined || by === 0) return;
  const [at, k] = input.dataset.cell.split(" ").map(Number);
  event.preventDefault();
  if (bench.typing !== null) commitCell(bench, input);
  if (event.key === "Enter" && at + 1 === bench.session.sheet().rows.length) return addRow(bench);
  /** @type {PageElement | null} */ (byId("editor").querySelector(`[data-cell="${at + by} ${k}"]`))?.focus();
}

/**
 * Several cells go into the cells from the one with the focus on; what has a header, or another form than cells, is a table.
 * @param {Workbench} bench
 * @param {ClipboardEvent} event
 */
function onPaste(bench, event) {
  const { session } = bench;
  const place = targetOf(event).dataset.cell;
  const text = event.clipboardData?.getData("text/plain") ?? "";
  const block = text.replace(/\r\n?/g, "\n").replace(/\n$/, "").split("\n").map((line) => line.split("\t").map((cell) => cell.trim()));
  if (place === undefined || (block.length === 1 && block[0].length === 1)) return;
  event.preventDefault();
  bench.typing = null;
  const [at, k] = place.split(" ").map(Number);
  const hasHeader = block.length > 1 && block[0].every((cell) => NAME.test(cell));
  const width = session.sheet().columns.length;
  const isOtherText = block.every((line) => line.length === 1) && /[;,|]|\S\s+\S/.test(block[0][0]) && width > 1;
  // What finds no column is asked about.
  const isTooWide = block.some((line) => line.slice(width - k).some((cell) => cell !== ""));
  if (hasHeader || isOtherText || isTooWide) return void startImport(bench, text, null);
  let sheet = session.sheet();
  const cells = block.map((line) => line.map((cell) => {
    const typed = typedIn(sheet, cell, block.flat());
    sheet = typed.sheet;
    return typed.text;
  }));
  session.edit(withBlock(sheet, at, k, cells), t("edit.did.block"));
}

/**
 * @param {Workbench} bench
 * @param {KeyboardEvent} event
 */
function onUndoKey(bench, event) {
  const key = event.key.toLowerCase();
  if (!(event.ctrlKey || event.metaKey) || event.altKey || !["z", "y"].includes(key) || isElsewhere()) return;
  // What is being typed has an undo of its own.
  if (bench.typing !== null || targetOf(event).localName === "textarea") return;
  event.preventDefault();
  press(bench, key === "y" || event.shiftKey ? "redo" : "undo");
}

/** @param {Workbench} bench */
function connectDropping(bench) {
  addEventListener("dragover", (event) => {
    const types = (event.dataTransfer?.types ?? []).map((type) => type.toLowerCase());
    // A browser shows a file that nobody takes in the place of the page.
    if (types.includes("files") || (!isElsewhere() && types.includes("text/plain"))) event.preventDefault();
  });
  addEventListener("drop", (event) => {
    const file = event.dataTransfer?.files[0];
    const text = event.dataTransfer?.getData("text/plain") ?? "";
    if (file !== undefined) event.preventDefault();
    if (isElsewhere() || (file === undefined && !text.includes("\n"))) return;
    event.preventDefault();
    if (file !== undefined) readFile(bench, file);
    else startImport(bench, text, null);
  });
}
