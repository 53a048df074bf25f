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

/**
 * Unpacks the engine and starts it.
 * @param {BlobPart} packed the bytes of `boundfit_wasm.wasm.gz`
 */
export const start = async (packed) => {
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return initSync({ module: await new Response(unpacked).arrayBuffer() });
};

/**
 * @typedef {import("./request.d.mts").Request} Request
 * @typedef {Request | (Omit<Extract<Request, { ask: "fit" }>, "ask"> & { ask?: undefined })} Options
 */

/**
 * Answers a question about readings, the fit unless `options.ask` names another one, as JSON unless `options.format` says otherwise.
 *
 * Throws an Error in the words of the program where options or table are wrong. A trap, such as for lack of memory, is thrown too; the
 * engine is started anew then, so that the next call finds it whole.
 * @param {string | Uint8Array} table
 * @param {Options} options the options of the program, with `_` in the place of `-` (docs/wasm.md)
 * @returns {string}
 */
export const run = (table, options) => ask(runOnce, table, options);

/**
 * Returns the data of the page of `boundfit lesson`: the document of schema `boundfit/lesson/3`. The exact simplex alone answers its
 * linear programs. Throws as {@link run} does.
 * @param {string | Uint8Array} table
 * @param {object} options those of {@link run}, and of a lesson (docs/wasm.md)
 * @returns {string}
 */
export const lesson = (table, options) => ask(lessonOnce, table, options);

/**
 * The columns of a table of which nothing is known yet, as JSON: `{"columns": ["x", "y"], "header": true}`. Throws as {@link run} does.
 * @param {string | Uint8Array} table
 * @param {object} options how the table is written, as for {@link run}
 * @returns {string}
 */
export const columns = (table, options) => ask(columnsOnce, table, options);

/**
 * What there is to say about half-planes, one a line: the document of schema `boundfit/polytope/1`. Throws as {@link run} does.
 * @param {string | Uint8Array} text
 * @param {object} options `objective`, two numbers as text, and `start`, the number of a vertex from 0
 * @returns {string}
 */
export const polytope = (text, options) => ask(polytopeOnce, text, options);

/**
 * @param {(table: Uint8Array, options: string) => string} answer
 * @param {string | Uint8Array} table
 * @param {object} options
 */
const ask = (answer, table, options) => {
  const bytes = typeof table === "string" ? new TextEncoder().encode(table) : table;
  try {
    return answer(bytes, JSON.stringify(options));
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) startAnew();
    throw error;
  }
};
