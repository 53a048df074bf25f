// What programs in TypeScript may write with the engine, and what is refused before they run: `npm run types`.

import { columns, lesson, polytope, run, start } from "../../crates/lesson/engine/boundfit.mjs";
import type { Options, Table } from "../../crates/lesson/engine/boundfit.mjs";
import type { Request } from "../../crates/lesson/engine/request.d.mts";

const table: Table = "V;z\n0;0\n1;1,5\n";
const request: Request = { ask: "range", by: "row", x: "V", y: "z", eps: "1/4" };
const fit: Options = { x: "V", y: "z", eps: "1/2" };

export const started: Promise<object> = start(new Uint8Array());
export const answers: string[] = [
  run(table, fit),
  run(new Uint8Array(), request),
  run(new ArrayBuffer(), { ask: "window", window: 3, x: "V", y: "z", eps: { exact: "1/2" } }),
  lesson(table, { ...fit, title: "lesson" }),
  columns(table),
  polytope("1 0 1\n", { start: 0 }),
];

// @ts-expect-error a number is no table
run(5, fit);
// @ts-expect-error a table alone is no question
run(table);
// @ts-expect-error there is no such key
run(table, { x: "V", y: "z", epsilon: "1/2" });
// @ts-expect-error an answer is text
export const document: object = run(table, fit);
