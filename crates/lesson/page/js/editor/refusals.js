// @ts-check
// What the engine refuses, in the language of the page and with what can be done here.

import { isText, t, wordsOfError } from "../texts.js";

/**
 * What an error of the engine is about; an error of another kind has its own words.
 * @param {unknown} error
 * @returns {Refusal}
 */
export function refusalOf(error) {
  const refusal = error instanceof Error && "refusal" in error ? /** @type {Refusal | null} */ (error.refusal) : null;
  return refusal ?? { kind: "", words: wordsOfError(error) };
}

/** @param {string} sentence */
const capital = (sentence) => sentence.slice(0, 1).toUpperCase() + sentence.slice(1);

/**
 * What is wrong, as a sentence.
 * @param {Refusal} refusal
 */
export const sentenceOf = (refusal) => capital(refusedWords(refusal));

/**
 * What is wrong; English where the page has no words of its own for it.
 * @param {Refusal} refusal
 */
export function refusedWords({ kind, words, text, position, values = {} }) {
  const said = isText(`problem.${kind}`) ? t(`problem.${kind}`, values) : words;
  const placed = position === undefined ? said : t("problem-at.character", { problem: said, position });
  return text === undefined || text === "" ? placed : t("problem-at.text", { problem: placed, text });
}

/**
 * What is wrong with a table that is being taken in: where in it, and what can be done in the form.
 * @param {Refusal} refusal
 */
export function sentenceOfTable(refusal) {
  const { line, column, name, kind } = refusal;
  const sentence = refusedWords(refusal);
  const place = { problem: sentence, line: line ?? "", column: name ?? `${column ?? ""}` };
  const placed = line === undefined ? capital(sentence) : t(column === undefined ? "problem-at.line" : "problem-at.cell", place);
  return isText(`problem-way.${kind}`) ? `${placed}. ${t(`problem-way.${kind}`)}` : placed;
}
