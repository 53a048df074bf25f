// @ts-check
// The words of the page, in the language that was chosen. The table stands in the page; crates/lesson/src/texts has its rules,
// and says the same texts in the same way.

import { all, byId, element, patch } from "./dom.js";

/** @type {Record<string, Record<string, string>> | null} */
let table = null;
let language = "";
/** The languages with a decimal comma. */
const COMMA = new Set(["it", "de"]);
/** @type {Map<string, TextPart[]>} */
const known = new Map();

/** @returns {Record<string, Record<string, string>>} */
function texts() {
  table ??= JSON.parse(byId("texts").textContent);
  return /** @type {Record<string, Record<string, string>>} */ (table);
}

/** The code of the language that the page speaks. */
export function currentLanguage() {
  if (language === "" && typeof document !== "undefined") language = document.documentElement.lang;
  return language;
}

/**
 * Makes the page speak another language; what is not drawn again has to be, afterwards.
 * @param {string} code
 */
export function setLanguage(code) {
  language = code;
  known.clear();
  document.documentElement.lang = code;
  for (const place of all("[data-text-label]")) place.setAttribute("aria-label", t(place.dataset.textLabel ?? ""));
}

/**
 * Fills the elements that have a text of the table: all of them may use the same values.
 * @param {TextValues} values
 */
export function fillTexts(values) {
  for (const place of all("[data-text]")) patch(place, rich(place.dataset.text ?? "", values));
}

/**
 * A text of the table with its values, as a sentence.
 * @param {string} key
 * @param {TextValues} [values]
 */
export function t(key, values = {}) {
  return rich(key, values).map(plainText).join("");
}

/**
 * A text of the table with its mark-up; a value may be the description of an element.
 * @param {string} key
 * @param {TextValues} [values]
 * @returns {(Description | string)[]}
 */
export function rich(key, values = {}) {
  return saidParts(partsOf(key), values);
}

/**
 * A message of the engine's document as a sentence.
 * @param {TextValue} message
 */
export function said(message) {
  return saidValue(message).map(plainText).join("");
}

/** Whether numbers have a decimal comma in the language of the page. */
export const hasDecimalComma = () => COMMA.has(currentLanguage());

/**
 * A number with the minus sign and the decimal mark of the language; fractions have no mark.
 * @param {string} text
 */
export function numberText(text) {
  return text.replace(/-/g, "\u2212").replace(".", hasDecimalComma() ? "," : ".");
}

/**
 * A formula such as `theta1 <= 5.5`, with the decimal mark of the language unless another one is asked for.
 * @param {string} text
 * @param {boolean} [comma]
 */
export const formulaText = (text, comma = hasDecimalComma()) => (comma ? text.replace(/\.(?=\d)/g, ",") : text);

/**
 * A reason that the engine's reports have in English, in the language of the page where the table knows it.
 * @param {string} english
 */
export function reasonText(english) {
  const key = Object.keys(texts()).find((name) => name.startsWith("reason.") && texts()[name].en === english);
  return key === undefined ? english : t(key);
}

/**
 * Whether the table has a text.
 * @param {string} key
 */
export const isText = (key) => Object.hasOwn(texts(), key);

/** @param {string} key */
function wordsOf(key) {
  return texts()[key]?.[currentLanguage()] ?? key;
}

/** @param {string} key */
function partsOf(key) {
  const found = known.get(key) ?? textParts(wordsOf(key));
  known.set(key, found);
  return found;
}

/** @param {Description | string} part @returns {string} */
function plainText(part) {
  return typeof part === "string" ? part : part.children.map(plainText).join("");
}

/**
 * A text of the table, taken apart: words, values in braces with their forms, and mark-up.
 * @param {string} text
 * @returns {TextPart[]}
 */
export function textParts(text) {
  let rest = text;
  /** @param {number} length */
  const take = (length) => {
    const taken = rest.slice(0, length);
    rest = rest.slice(length);
    return taken;
  };
  /** @param {string} mark */
  const skip = (mark) => rest.startsWith(mark) && take(mark.length) !== "";
  /** @param {boolean} inForm @returns {TextPart[]} */
  const sequence = (inForm) => {
    const parts = [];
    for (;;) {
      const end = rest.search(inForm ? /[{<|}]/ : /[{<]/);
      const plain = take(end < 0 ? rest.length : end);
      if (plain !== "") parts.push(plain);
      if (skip("{")) parts.push(value());
      else if (rest.startsWith("</") || !rest.startsWith("<")) return parts;
      else parts.push(tagged(inForm));
    }
  };
  /** @returns {TextPart} */
  const value = () => {
    const [name, ...written] = take(Math.max(0, rest.search(/[|}]/))).split(":");
    /** @type {TextPart[][]} */
    const forms = [];
    while (skip("|")) forms.push(sequence(true));
    skip("}");
    return { name, written, forms };
  };
  /** @param {boolean} inForm @returns {TextPart} */
  const tagged = (inForm) => {
    const [tag, ...attributes] = take(rest.indexOf(">") + 1).slice(1, -1).split(/ (?=[a-z]+=)/);
    const parts = sequence(inForm);
    take(rest.indexOf(">") + 1);
    return { tag, attributes: Object.fromEntries(attributes.map((text) => text.slice(0, -1).split("=\""))), parts };
  };
  return sequence(false);
}

/**
 * @param {TextPart[]} parts
 * @param {TextValues} values
 * @returns {(Description | string)[]}
 */
function saidParts(parts, values) {
  return parts.flatMap((part) => {
    if (typeof part === "string") return [part];
    if ("tag" in part) return [element(part.tag, part.attributes, saidParts(part.parts, values))];
    return saidPlace(part, values[part.name]).flatMap((said) => (Array.isArray(said) ? saidParts(said, values) : [said]));
  });
}

/**
 * A value as it is written, or the form that it asks for.
 * @param {TextPlace} place
 * @param {TextValue | undefined} value
 * @returns {(Description | string | TextPart[])[]}
 */
function saidPlace({ written, forms }, value) {
  if (value === undefined) return [];
  if (forms.length > 0) {
    const count = countOf(value);
    const fromEnd = count === 0 && forms.length > 2 ? 3 : count === 1 ? 2 : 1;
    return [forms[forms.length - fromEnd] ?? []];
  }
  const inWords = typeof value === "number" && written.includes("words");
  const said = inWords ? [wordsOf("number.words").split(" ")[value] ?? `${value}`] : saidValue(value);
  if (written.includes("capital") && typeof said[0] === "string") said[0] = said[0].slice(0, 1).toUpperCase() + said[0].slice(1);
  return said;
}

/**
 * @param {TextValue} value
 * @returns {(Description | string)[]}
 */
function saidValue(value) {
  if (typeof value !== "object") return [`${value}`];
  if (Array.isArray(value)) return [...value];
  if ("tag" in value) return [value];
  if ("text" in value) return rich(value.text, value.values);
  if ("number" in value) return [numberText(value.number)];
  if ("formula" in value) return [formulaText(value.formula)];
  const items = value.list.map(saidValue);
  if (value.more) items.push(rich("list.more", { count: value.more }));
  const [between, last] = [value.by ?? "list.comma", value.by ?? "list.and"].map(wordsOf);
  return items.flatMap((item, k) => (k === 0 ? item : [k === items.length - 1 ? last : between, ...item]));
}

/**
 * How many things a value is.
 * @param {TextValue} value
 */
function countOf(value) {
  if (typeof value === "number") return value;
  return typeof value === "object" && !Array.isArray(value) && "list" in value ? value.list.length + (value.more ?? 0) : 1;
}

/** @param {unknown} error */
export function wordsOfError(error) {
  return error instanceof Error ? error.message : `${error}`;
}
