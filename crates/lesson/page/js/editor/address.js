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

/** @param {Workbench} bench */
async function writeAddress(bench) {
  addressTimer = null;
  const { session, store, own } = bench;
  const sheet = session.right();
  const readings = isSameSheet(sheet, own) ? "" : await wordsOfSheet(sheet);
  // The view of half-planes has the address for itself.
  if (sheet !== session.right() || document.body.dataset.view === "half-planes") return;
  // What is looked at means nothing without the readings.
  const words = readings === null ? [] : [readings, lookOf(store.lesson(), store.get())].filter((part) => part !== "");
  const { pathname, search } = location;
  history.replaceState(null, "", words.length > 0 ? `#${words.join("&")}` : `${pathname}${search}`);
  bench.link = readings === null ? null : location.href;
  bench.draw();
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
