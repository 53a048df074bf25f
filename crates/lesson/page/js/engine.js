// @ts-check
// The engine inside the page: a WebAssembly module that runs in a Worker, started with the first question. Answers come in the order
// of the questions, and after a trap the Worker is started anew. Without the build feature `engine` there is none.

import { byId } from "./dom.js";
import { t } from "./texts.js";

// The engine is compiled part by part, where a question leads: this one leads to most of what a lesson needs.
const SMALL_TABLE = "x,y\n0,0\n1,2\n2,3\n3,3\n";
const SMALL_QUESTION = { x: "x", y: "y", eps: "1" };

/**
 * @param {string} packed the module, packed by gzip, in base64
 * @param {string} script what the Worker runs
 * @returns {Engine}
 */
function startEngine(packed, script) {
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  /** @type {Worker | null} */
  let worker = null;
  /** @type {{ question: object, resolve: (answer: string) => void, reject: (error: Error) => void }[]} */
  const waiting = [];

  // The questions behind the one that was trapped are asked once more.
  function startAnew() {
    worker?.terminate();
    worker = null;
    if (waiting.length > 0) waiting.forEach(({ question }) => started().postMessage(question));
  }

  /** @param {string} problem */
  function failed(problem) {
    waiting.shift()?.reject(new Error(problem));
    startAnew();
  }

  /** @returns {Worker} */
  function started() {
    if (worker !== null) return worker;
    const fresh = new Worker(address);
    fresh.onmessage = ({ data }) => {
      if (fresh !== worker) return;
      if (data.trapped) failed(t("engine.stopped", { problem: data.error }));
      else if (data.error !== undefined) waiting.shift()?.reject(Object.assign(new Error(data.error), { refusal: JSON.parse(data.refusal ?? "null") }));
      else waiting.shift()?.resolve(data.answer);
    };
    fresh.onerror = (event) => {
      event.preventDefault();
      if (fresh === worker) failed(t("engine.not-started", { problem: event.message || t("engine.no-worker") }));
    };
    fresh.postMessage(packed);
    worker = fresh;
    return fresh;
  }

  /** @type {Engine["ask"]} */
  const ask = (what, table, options) =>
    new Promise((resolve, reject) => {
      const question = { what, table, options };
      waiting.push({ question, resolve, reject });
      started().postMessage(question);
    });

  return {
    ask,
    wake() {
      if (worker === null) ask("lesson", SMALL_TABLE, SMALL_QUESTION).catch(() => undefined);
    },
  };
}

const packedEngine = byId("engine-module")?.textContent ?? null;

/** The engine; null in a page that was made without it. @type {Engine | null} */
export const engine = packedEngine === null ? null : startEngine(packedEngine, byId("engine-worker").textContent ?? "");
