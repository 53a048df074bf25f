/**
 * Unpacks the engine and starts it.
 * @param {BlobPart} packed the bytes of `boundfit_wasm.wasm.gz`
 */
export declare const start: (packed: BlobPart) => Promise<import("./boundfit_wasm.mjs").InitOutput>;
export type Table = string | ArrayBuffer | ArrayBufferView;
export type Request = import("./request.d.mts").Request;
export type Options = Request | (Omit<Extract<Request, {
    ask: "fit";
}>, "ask"> & {
    ask?: undefined;
});
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
export declare const run: (table: Table, options: Options) => string;
/**
 * Returns the data of the page of `boundfit lesson`: the document of schema `boundfit/lesson/3`. The exact simplex alone answers its
 * linear programs. Throws as {@link run} does.
 * @param {Table} table
 * @param {object} options those of {@link run}, and of a lesson (docs/wasm.md)
 * @returns {string}
 */
export declare const lesson: (table: Table, options: object) => string;
/**
 * The columns of a table of which nothing is known yet, as JSON: `{"columns": ["x", "y"], "header": true}`. Throws as {@link run} does.
 * @param {Table} table
 * @param {object} [options] how the table is written, as for {@link run}
 * @returns {string}
 */
export declare const columns: (table: Table, options?: object) => string;
/**
 * What there is to say about half-planes, one a line: the document of schema `boundfit/polytope/1`. Throws as {@link run} does.
 * @param {Table} text
 * @param {object} [options] `objective`, two numbers as text, and `start`, the number of a vertex from 0
 * @returns {string}
 */
export declare const polytope: (text: Table, options?: object) => string;
