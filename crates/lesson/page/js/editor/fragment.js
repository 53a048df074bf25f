// @ts-check
// The fragment of the page's address: the request, each key with its value, as every surface takes it; then `table`, the readings as
// text; then what only the page has, under keys that begin with `page.`.
//
// A value that is no text is JSON, and so is a text that would look like it: #ask=fit&x=V&y=z&eps=1/2&where=["theta1+>=+0"]

/** Many a program cuts addresses that are longer. */
const LONGEST = 8000;
/** A table that is no longer than this stays readable. */
const READABLE = 300;
const LONGEST_UNPACKED = 1_000_000;
const PAGE = "page.";
/** The key whose value is a whole number. Digits elsewhere are texts, which keep their decimals. */
const WHOLE = "skip_lines";
/** How links of older versions begin, which had keys of their own. */
const OLDER = /^(?:readings-|(?:tab|layers|residual|straighten)=)/;
const LOOKS_LIKE_JSON = /^(?:[[{"]|(?:true|false)$)/;

/**
 * @param {Uint8Array} bytes
 * @param {CompressionStream | DecompressionStream} packing
 */
async function through(bytes, packing) {
  const reader = new Blob([/** @type {BlobPart} */ (bytes)]).stream().pipeThrough(packing).getReader();
  const parts = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return new Uint8Array(await new Blob(parts).arrayBuffer());
    length += value.length;
    // A few bytes may unpack to gigabytes.
    if (length > LONGEST_UNPACKED) throw new RangeError("too long");
    parts.push(value);
  }
}

/**
 * A table in the letters that an address takes; null for one that is too long.
 * @param {string} table
 */
async function packed(table) {
  const bytes = await through(new TextEncoder().encode(table), new CompressionStream("deflate-raw"));
  return bytes.length > LONGEST ? null : btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** @param {string} letters */
async function unpacked(letters) {
  const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
  return new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw")));
}

/** @param {string} key @param {string} text */
function valueOf(key, text) {
  if (key === WHOLE) return /^\d+$/.test(text) ? Number(text) : text;
  if (!LOOKS_LIKE_JSON.test(text)) return text;
  try {
    return JSON.parse(text);
  } catch {
    return text;
  }
}

/** @param {unknown} value */
const wordOf = (value) => (typeof value === "string" && !LOOKS_LIKE_JSON.test(value) ? value : JSON.stringify(value));

/**
 * Words as a web form, in which commas, slashes, colons and brackets stay readable.
 * @param {[string, string][]} words
 */
const joined = (words) => `${new URLSearchParams(words)}`.replace(/%(?:2[89CF]|3A|5[BD])/g, decodeURIComponent);

/**
 * The fragment of a link; null for readings that are too many for an address.
 * @param {Link} link
 */
export async function fragmentOf({ request, table, page }) {
  /** @type {[string, string][]} */
  const words = Object.entries(request).map(([key, value]) => [key, wordOf(value)]);
  if (table !== null) {
    const short = await packed(table);
    if (short === null) return null;
    words.push(["table", joined([["", table]]).length <= Math.max(READABLE, short.length) ? table : short]);
    if (joined(words).length > LONGEST) return null;
  }
  return joined([...words, ...Object.entries(page).map(([key, value]) => /** @type {[string, string]} */ ([PAGE + key, `${value}`]))]);
}

/**
 * What a fragment says, for the engine to judge; an Error for one of an older version, or one that was cut or changed.
 * @param {string} fragment
 * @returns {Promise<Link | Error>}
 */
export async function linkOf(fragment) {
  if (OLDER.test(fragment)) return new Error("old");
  const words = [...new URLSearchParams(fragment)];
  if (new Set(words.map(([key]) => key)).size < words.length) return new Error("damaged");
  const { table, ...said } = Object.fromEntries(words);
  /** @param {boolean} isOfPage */
  const part = (isOfPage) => Object.entries(said).filter(([key]) => key.startsWith(PAGE) === isOfPage);
  try {
    return {
      request: Object.fromEntries(part(false).map(([key, text]) => [key, valueOf(key, text)])),
      // What is packed is one line.
      table: table === undefined ? null : table.includes("\n") ? table : await unpacked(table),
      page: Object.fromEntries(part(true).map(([key, text]) => [key.slice(PAGE.length), text])),
    };
  } catch {
    return new Error("damaged");
  }
}
