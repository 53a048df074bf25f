// @ts-check
// What the Worker of a lesson runs: it is handed the packed module in base64 once, then answers one question after the other.
// The page ends it, and starts another one, when the module traps.

import { columns, initSync, lesson, polytope, run } from "./boundfit_wasm.mjs";

/** @type {Record<string, (table: Uint8Array, options: string) => string>} */
const answers = { columns, lesson, polytope, run };

/** @param {string} packed */
const unpacked = async (packed) => {
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
};

/** @type {Promise<unknown>} */
let started = Promise.reject(new Error("the engine has not been started"));
started.catch(() => undefined);

/** @param {{ what: string, table: string | Uint8Array, options: object }} question */
const answer = async ({ what, table, options }) => {
  await started;
  if (!Object.hasOwn(answers, what)) throw new Error(`the engine has no answer about "${what}"`);
  return answers[what](typeof table === "string" ? new TextEncoder().encode(table) : table, JSON.stringify(options));
};

// Questions wait for each other, so that answers come in their order.
let last = Promise.resolve();
self.onmessage = ({ data }) => {
  if (typeof data === "string") {
    started = unpacked(data).then((module) => initSync({ module }));
    started.catch(() => undefined);
    return;
  }
  last = last.then(async () => {
    try {
      self.postMessage({ answer: await answer(data) });
    } catch (error) {
      const trapped = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
      const refusal = error instanceof Error && "refusal" in error ? error.refusal : undefined;
      self.postMessage({ error: error instanceof Error ? error.message : String(error), refusal, trapped });
    }
  });
};
