/* tslint:disable */
/* eslint-disable */

export function __wbg_reset_state(): void;

/**
 * The columns of a table of which nothing is known yet, as JSON: `{"columns": ["x", "y"], "header": true,
 * "numeric": [true, true], "table": {…}}`.
 *
 * `options` may have the keys that say how the table is written: `file`, `encoding`, `header`, `delimiter`, `decimal`, `thousands`,
 * `comment`, `skip_lines`, `units_row`, `block`, `missing_as`, `reading` and `limits`.
 *
 * # Errors
 * Throws an `Error` that says what is wrong with the options or the table, and where; its `refusal` has the same as JSON.
 */
export function columns(table: Uint8Array | number[], options: string): string;

/**
 * Returns the data of the page of `boundfit lesson`: the document of schema `boundfit/lesson/3`. The exact simplex alone answers its
 * linear programs.
 *
 * `table` and `options` are as in [`run`](fn@run).
 *
 * # Errors
 * Throws an `Error` that says what is wrong with the options or the table, and where; its `refusal` has the same as JSON.
 */
export function lesson(table: Uint8Array | number[], options: string): string;

/**
 * Returns the answer about half-planes: the document of schema `boundfit/polytope/1`.
 *
 * `text` has one half-plane a line, such as `2x + 3y <= 6`, in UTF-8, and `options` is a JSON object whose keys may be `objective`, two
 * numbers as text, and `start`, the number of a vertex from 0.
 *
 * # Errors
 * Throws an `Error` that says what is wrong with the options, or that there are too many half-planes; its `refusal` has the same as
 * JSON. What is wrong with a line is part of the answer.
 */
export function polytope(text: Uint8Array | number[], options: string): string;

/**
 * Answers a question about readings as the program does: with the JSON document of its schema, or in the `format` that is asked for.
 *
 * `table` has the bytes of a table of any kind that the program reads from text, and `options` is a JSON object whose keys are the
 * program's options, with `_` in the place of `-`; `ask` names the question, which is `fit` when it is left out.
 *
 * # Errors
 * Throws an `Error` that says what is wrong with the options or the table, and where; its `refusal` has the same as JSON.
 */
export function run(table: Uint8Array | number[], options: string): string;

export type InitInput = RequestInfo | URL | Response | BufferSource | WebAssembly.Module;

export interface InitOutput {
    readonly memory: WebAssembly.Memory;
    readonly columns: (a: number, b: number, c: number, d: number) => [number, number, number, number];
    readonly lesson: (a: number, b: number, c: number, d: number) => [number, number, number, number];
    readonly polytope: (a: number, b: number, c: number, d: number) => [number, number, number, number];
    readonly run: (a: number, b: number, c: number, d: number) => [number, number, number, number];
    readonly __wbindgen_externrefs: WebAssembly.Table;
    readonly __wbindgen_malloc: (a: number, b: number) => number;
    readonly __wbindgen_free: (a: number, b: number, c: number) => void;
    readonly __wbindgen_realloc: (a: number, b: number, c: number, d: number) => number;
    readonly __externref_table_dealloc: (a: number) => void;
    readonly __wbindgen_start: () => void;
}

export type SyncInitInput = BufferSource | WebAssembly.Module;

/**
 * Instantiates the given `module`, which can either be bytes or
 * a precompiled `WebAssembly.Module`.
 *
 * @param {{ module: SyncInitInput }} module - Passing `SyncInitInput` directly is deprecated.
 *
 * @returns {InitOutput}
 */
export function initSync(module: { module: SyncInitInput } | SyncInitInput): InitOutput;

