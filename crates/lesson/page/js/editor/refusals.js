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

/** Digits in groups of three with blanks of any width between them. */
const GROUPED_BY_BLANKS = /^[+-]?\d{1,3}(?:\s\d{3})+(?:[.,]\d+)?$/;

/**
 * A text of the table with its blanks as they are: the engine escapes those of another width.
 * @param {string} text
 */
const withBlanks = (text) =>
  text.replace(/\\u\{([0-9a-f]{2,4})\}/g, (escaped, code) => {
    const character = String.fromCharCode(parseInt(code, 16));
    return /\p{Zs}/u.test(character) ? character : escaped;
  });

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
  const own = kind === "number-groups" && text?.includes("_") ? "number-underscore" : kind;
  const said = isText(`problem.${own}`) ? t(`problem.${own}`, values) : words;
  const placed = position === undefined ? said : t("problem-at.character", { problem: said, position });
  return text === undefined || text === "" ? placed : t("problem-at.text", { problem: placed, text: withBlanks(text) });
}

/**
 * What is wrong with a table that is being taken in: where in it, and what can be done in the form.
 * @param {Refusal} refusal
 */
export function sentenceOfTable(refusal) {
  const { line, column, name, kind, text } = refusal;
  const sentence = refusedWords(refusal);
  const place = { problem: sentence, line: line ?? "", column: name ?? `${column ?? ""}` };
  const placed = line === undefined ? capital(sentence) : t(column === undefined ? "problem-at.line" : "problem-at.cell", place);
  const way = kind === "number" && GROUPED_BY_BLANKS.test(withBlanks(text ?? "").trim()) ? "number-blanks" : kind;
  return isText(`problem-way.${way}`) ? `${placed}. ${t(`problem-way.${way}`)}` : placed;
}
