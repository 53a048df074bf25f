// @ts-check
// What can be taken away from the page: the readings, the report, the pictures.

import { download, takePicture } from "../picture.js";
import { csvOf, optionsOf } from "./sheet.js";

export const FILE_NAME = "readings.csv";
const REPORTS = ["text", "latex", "json"];
/** What can be taken away, in the order of the buttons. */
export const EXPORTS = ["csv", ...REPORTS, "data-svg", "data-png", "parameter-svg", "parameter-png"];
/** @type {Record<string, string>} */
const ENDINGS = { text: "txt", latex: "tex", json: "json" };

/**
 * What the report is asked for: the page's title and units are not part of it.
 * @param {Sheet} sheet
 */
export function reportOptions(sheet) {
  const { title, x_unit, y_unit, max_readings, file, ...options } = optionsOf(sheet);
  return { ...options, file: FILE_NAME };
}

/**
 * Hands over what a button names.
 * @param {Engine} engine
 * @param {Sheet} sheet
 * @param {string} kind
 */
export async function takeAway(engine, sheet, kind) {
  if (kind === "csv") return download(FILE_NAME, new Blob([csvOf(sheet)], { type: "text/csv" }));
  if (REPORTS.includes(kind)) {
    const report = await engine.ask("run", csvOf(sheet), { ...reportOptions(sheet), format: kind });
    return download(["report", ENDINGS[kind]].join("."), new Blob([report], { type: "text/plain" }));
  }
  const [plane, type] = kind.split("-");
  await takePicture(`${plane}-plane`, `${plane}-plane`, type);
}
