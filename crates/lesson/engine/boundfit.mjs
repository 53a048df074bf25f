// @ts-check
// The engine for JavaScript, in a browser, a Worker or Node: start it with the bytes of boundfit_wasm.wasm.gz, then
// ask.

import {
  __wbg_reset_state as startAnew,
  columns as columnsOnce,
  initSync,
  lesson as lessonOnce,
  polytope as polytopeOnce,
  run as runOnce,
} from "./boundfit_wasm.mjs";

let isStarted = false;

/**
 * Unpacks the engine and starts it.
 * @param {BlobPart} packed the bytes of `boundfit_wasm.wasm.gz`
 */
export const start = async (packed) => {
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const exports = initSync({ module: await new Response(unpacked).arrayBuffer() });
  isStarted = true;
  return exports;
};

/**
 * @typedef {string | ArrayBuffer | ArrayBufferView} Table text, or the bytes of a file
 * @typedef {import("./request.d.mts").Request} Request
 * @typedef {Request | (Omit<Extract<Request, { ask: "fit" }>, "ask"> & { ask?: undefined })} Options
 */

/**
 * Answers a question about readings, the fit unless `options.ask` names another one, as JSON unless `options.format` says otherwise.
 *
 * Throws an Error in the words of the program where options or table are wrong, before {@link start} has ended too, and a TypeError where
 * the table is neither text nor bytes, or an option is nothing that JSON has. A trap, such as for lack of memory, is thrown too; the
 * engine is started anew then, so that the next call finds it whole.
 * @param {Table} table
 * @param {Options} options the options of the program, with `_` in the place of `-` (docs/wasm.md)
 * @returns {string}
 */
export const run = (table, options) => {
  // A page may have no readings yet. Elsewhere no rows would mean all of them.
  if (typeof options === "object" && options !== null && "rows" in options && Array.isArray(options.rows) && options.rows.length === 0) {
    throw new TypeError("rows: none is chosen (expected at least one row; without this key all rows are fitted)");
  }
  return ask(runOnce, table, options);
};

/**
 * Returns the data of the page of `boundfit lesson`: the document of schema `boundfit/lesson/3`. The exact simplex alone answers its
 * linear programs. Throws as {@link run} does.
 * @param {Table} table
 * @param {object} options those of {@link run}, and of a lesson (docs/wasm.md)
 * @returns {string}
 */
export const lesson = (table, options) => ask(lessonOnce, table, options);

/**
 * The columns of a table of which nothing is known yet, as JSON: `{"columns": ["x", "y"], "header": true}`. Throws as {@link run} does.
 * @param {Table} table
 * @param {object} [options] how the table is written, as for {@link run}
 * @returns {string}
 */
export const columns = (table, options) => ask(columnsOnce, table, options);

/**
 * What there is to say about half-planes, one a line: the document of schema `boundfit/polytope/1`. Throws as {@link run} does.
 * @param {Table} text
 * @param {object} [options] `objective`, two numbers as text, and `start`, the number of a vertex from 0
 * @returns {string}
 */
export const polytope = (text, options) => ask(polytopeOnce, text, options);

/**
 * The bytes of a table. A buffer without a view has no length that the engine could read.
 * @param {Table} table
 */
const bytesOf = (table) => {
  if (typeof table === "string") return new TextEncoder().encode(table);
  if (ArrayBuffer.isView(table)) return new Uint8Array(table.buffer, table.byteOffset, table.byteLength);
  // Buffers of another window or context are no instances of this one's ArrayBuffer.
  if (Object.prototype.toString.call(table) === "[object ArrayBuffer]") return new Uint8Array(table);
  throw new TypeError("the table is neither text nor bytes (expected a string, an ArrayBuffer, or a view of one such as a Uint8Array)");
};

/**
 * Options as JSON. What JSON has no word for would be left out, or be null, and nobody would hear of it.
 * @param {object} options
 */
const jsonOf = (options) => {
  if (typeof options !== "object" || options === null || Array.isArray(options)) {
    throw new TypeError('the options are no object (expected one such as {x: "V", y: "z", eps: "1/2"})');
  }
  return JSON.stringify(options, (key, value) => {
    const isNumber = typeof value === "number" && Number.isFinite(value);
    if (isNumber || ["string", "boolean", "undefined", "object"].includes(typeof value)) return value;
    const expected = typeof value === "bigint" ? `text, such as "${value}", or a number` : "text, a number, true or false, an array or an object";
    throw new TypeError(`${key}: ${String(value)} is of type ${typeof value}, which JSON does not have (expected ${expected})`);
  });
};

/**
 * @param {(table: Uint8Array, options: string) => string} answer
 * @param {Table} table
 * @param {object} [options] none where the engine is to say which are missing
 */
const ask = (answer, table, options = {}) => {
  if (!isStarted) throw new Error("the engine has not been started: wait for start(bytes) with the bytes of boundfit_wasm.wasm.gz");
  const bytes = bytesOf(table);
  try {
    return answer(bytes, jsonOf(options));
  } catch (error) {
    if (!(error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) throw error;
    startAnew();
    const why = "the engine stopped, for lack of memory or through a fault of its own, and was started anew";
    throw new WebAssembly.RuntimeError(`${why}: ${error.message}`, { cause: error });
  }
};
