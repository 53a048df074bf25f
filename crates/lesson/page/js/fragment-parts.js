// @ts-check
// The two parts of the page's address: what the view of half-planes shows, and the readings with what is looked at. Each view writes
// its own part and keeps the other one, so that readings outlive a look at half-planes.

const PLANE_KEYS = ["view", "tab", "planes", "c", "seed"];

/**
 * The part of a fragment about readings; "" where it has none.
 * @param {string} fragment
 */
export function readingsPart(fragment) {
  if (!fragment.startsWith("view=")) return fragment;
  const rest = fragment.split("&").filter((word) => !PLANE_KEYS.includes(word.split("=")[0]));
  // Links of half-planes may have words that nobody knows.
  return rest.some((word) => /^(ask=|page\.)/.test(word)) ? rest.join("&") : "";
}

/**
 * A fragment with another part about readings.
 * @param {string} fragment
 * @param {string} readings
 */
export function withReadings(fragment, readings) {
  const planes = fragment.startsWith("view=") ? fragment.split("&").filter((word) => PLANE_KEYS.includes(word.split("=")[0])) : [];
  return [...planes, readings].filter(Boolean).join("&");
}
