// @ts-check
// Numbers that follow from a seed: the same on every machine, so that a class has the same exercises.

/** @param {string} text */
function hashOf(text) {
  // FNV-1a on 32 bits.
  let hash = 0x811c9dc5;
  for (const byte of new TextEncoder().encode(text)) hash = Math.imul(hash ^ byte, 0x01000193);
  return hash >>> 0;
}

/**
 * Whole numbers from a seed, by the generator mulberry32.
 * @param {string} seed
 */
export function randomFrom(seed) {
  let state = hashOf(seed);
  const next = () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return (mixed ^ (mixed >>> 14)) >>> 0;
  };
  return {
    /**
     * From low to high, both included.
     * @param {number} low
     * @param {number} high
     */
    between: (low, high) => low + (next() % (high - low + 1)),
    /**
     * @template T
     * @param {T[]} list
     * @returns {T}
     */
    one: (list) => list[next() % list.length],
    /**
     * @template T
     * @param {T[]} list
     * @returns {T[]}
     */
    shuffled(list) {
      const left = [...list];
      /** @type {T[]} */
      const drawn = [];
      while (left.length > 0) drawn.push(...left.splice(next() % left.length, 1));
      return drawn;
    },
  };
}

const LETTERS = "abcdefghjkmnpqrstuvwxyz23456789";

/** A seed that nobody chose, short enough to be written on a board. */
export function freshSeed() {
  return Array.from({ length: 6 }, () => LETTERS[Math.floor(Math.random() * LETTERS.length)]).join("");
}
