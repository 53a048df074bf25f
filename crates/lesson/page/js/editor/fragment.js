// @ts-check
// A sheet as a part of the page's address: packed JSON, in the letters that an address takes. It begins with the version.

import { distinct, questionOf } from "./sheet.js";

const NAME = "readings-";
const VERSION = `${NAME}1.`;
/** Many a program cuts addresses that are longer. */
const LONGEST = 8000;
const LONGEST_UNPACKED = 1_000_000;
const MOST_SHEET_ROWS = 2000;
const ROLES = ["x", "y", "eps", "lower", "upper"];

/**
 * @param {Uint8Array} bytes
 * @param {CompressionStream | DecompressionStream} packing
 */
async function through(bytes, packing) {
  const reader = new Blob([/** @type {BlobPart} */ (bytes)]).stream().pipeThrough(packing).getReader();
  const parts = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return new Uint8Array(await new Blob(parts).arrayBuffer());
    length += value.length;
    // A few bytes may unpack to gigabytes.
    if (length > LONGEST_UNPACKED) throw new RangeError("too long");
    parts.push(value);
  }
}

/**
 * The words that stand for a sheet; null for one that is too long for an address.
 * @param {Sheet} sheet
 */
export async function wordsOfSheet({ columns, rows, question: asked }) {
  const compact = [
    columns.map(({ name, role }) => [name, role]),
    rows.map(({ cells }) => cells.join("\t")).join("\n"),
    rows.map(({ isFitted }) => (isFitted ? "1" : "0")).join(""),
    asked,
  ];
  const packed = await through(new TextEncoder().encode(JSON.stringify(compact)), new CompressionStream("deflate-raw"));
  if (packed.length > LONGEST) return null;
  const text = btoa(String.fromCharCode(...packed)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return VERSION.length + text.length > LONGEST ? null : VERSION + text;
}

/**
 * The sheet that words stand for; null for words of another kind, an Error for damaged ones.
 * @param {string} words
 * @returns {Promise<Sheet | Error | null>}
 */
export async function sheetOfWords(words) {
  if (!words.startsWith(NAME)) return null;
  if (!words.startsWith(VERSION)) return new Error("version");
  try {
    const letters = words.slice(VERSION.length).replaceAll("-", "+").replaceAll("_", "/");
    const packed = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
    const text = new TextDecoder().decode(await through(packed, new DecompressionStream("deflate-raw")));
    return checked(JSON.parse(text));
  } catch {
    return new Error("damaged");
  }
}

/** @param {unknown} value */
const isListOfTexts = (value) => Array.isArray(value) && value.every((own) => typeof own === "string");

/**
 * What anyone may have written into an address, as a sheet.
 * @param {any} compact
 * @returns {Sheet}
 */
function checked([names, cells, fitted, asked]) {
  /** @param {boolean} holds */
  const demand = (holds) => {
    if (!holds) throw new TypeError("sheet");
  };
  demand(Array.isArray(names) && names.length > 0 && names.length <= 6 && typeof cells === "string" && typeof fitted === "string");
  const columns = names.map((/** @type {any} */ own) => {
    demand(Array.isArray(own) && typeof own[0] === "string" && ROLES.includes(own[1]));
    return { name: own[0], role: own[1] };
  });
  const lines = fitted.length === 0 ? [] : cells.split("\n");
  demand(lines.length === fitted.length && lines.length <= MOST_SHEET_ROWS);
  demand(typeof asked === "object" && asked !== null && !Array.isArray(asked));
  const rows = lines.map((/** @type {string} */ line, /** @type {number} */ k) => {
    const own = line.split("\t");
    demand(own.length === columns.length);
    return { cells: own, isFitted: fitted[k] === "1" };
  });
  const question = questionOf(asked);
  demand(Object.entries(question).every(([key, value]) => (key === "where" ? isListOfTexts(value) : ["string", "number", "boolean"].includes(typeof value))));
  return { columns: distinct(columns), rows, question };
}
