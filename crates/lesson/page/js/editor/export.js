// @ts-check
// What can be taken away from the page: the readings, the report, the pictures.

import { download, takePicture } from "../picture.js";
import { csvOf, requestOf } from "./sheet.js";

export const FILE_NAME = "readings.csv";
const REPORTS = ["text", "latex", "json"];
/** What can be taken away, in the order of the buttons. */
export const EXPORTS = ["csv", ...REPORTS, "data-svg", "data-png", "parameter-svg", "parameter-png"];
/** @type {Record<string, string>} */
const ENDINGS = { text: "txt", latex: "tex", json: "json" };

/**
 * Hands over what a button names.
 * @param {Engine} engine
 * @param {Sheet} sheet
 * @param {string} kind
 */
export async function takeAway(engine, sheet, kind) {
  if (kind === "csv") return download(FILE_NAME, new Blob([csvOf(sheet)], { type: "text/csv" }));
  if (REPORTS.includes(kind)) {
    const report = await engine.ask("run", csvOf(sheet), { ...requestOf(sheet), file: FILE_NAME, format: kind });
    return download(["report", ENDINGS[kind]].join("."), new Blob([report], { type: "text/plain" }));
  }
  const [plane, type] = kind.split("-");
  await takePicture(`${plane}-plane`, `${plane}-plane`, type);
}
