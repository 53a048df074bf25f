// @ts-check
// The address of the page: it follows the readings and what is looked at, and is followed.

import { sheetOfWords, wordsOfSheet } from "./fragment.js";
import { isOtherLook, lookOf, stateOfLook } from "./look.js";
import { isSameSheet } from "./sheet.js";
import { t } from "../texts.js";

/** An address is not changed more often: browsers refuse that. */
const MILLISECONDS_PER_ADDRESS = 400;

/** @type {ReturnType<typeof setTimeout> | null} */
let addressTimer = null;

/**
 * Writes the address when the page has been still for a moment.
 * @param {Workbench} bench
 */
export function writeAddressSoon(bench) {
  if (addressTimer === null) addressTimer = setTimeout(writeAddress, MILLISECONDS_PER_ADDRESS, bench);
}

/**
 * Writes the readings into the address.
 * @param {Workbench} bench
 */
export async function writeAddress(bench) {
  addressTimer = null;
  const { session, store, own } = bench;
  const sheet = session.right();
  const readings = isSameSheet(sheet, own) ? "" : await wordsOfSheet(sheet);
  if (sheet !== session.right()) return;
  // What is looked at means nothing without the readings.
  const words = readings === null ? [] : [readings, lookOf(store.lesson(), store.get())].filter((part) => part !== "");
  const fragment = words.length > 0 ? `#${words.join("&")}` : "";
  const { href, pathname, search } = location;
  bench.link = readings === null ? null : href.split("#")[0] + fragment;
  if (!isElsewhere()) history.replaceState(null, "", fragment || `${pathname}${search}`);
  bench.draw();
}

/** Half-planes that stand in the place of the readings have the address, keys and files of their own. */
export function isElsewhere() {
  return document.body.dataset.view === "half-planes";
}

/**
 * Takes the readings of the address and what is looked at, now and whenever it changes.
 * @param {Workbench} bench
 */
export function connectAddress(bench) {
  bench.store.subscribe((state, before) => {
    if (isOtherLook(state, before)) writeAddressSoon(bench);
  });
  addEventListener("hashchange", () => readAddress(bench));
  readAddress(bench);
}

/** @param {Workbench} bench */
async function readAddress(bench) {
  const { session, store } = bench;
  const words = location.hash.slice(1);
  if (words === "" || words.startsWith("view=")) return;
  const found = await sheetOfWords(words.split("&")[0]);
  if (found instanceof Error) bench.notice = t(found.message === "version" ? "edit.link-version" : "edit.link-damaged");
  else if (found !== null && !isSameSheet(found, session.right())) session.edit(found, t("edit.did.link"));
  await session.settled();
  if (!(found instanceof Error)) store.change(stateOfLook(words, store.lesson()));
  bench.draw();
}
