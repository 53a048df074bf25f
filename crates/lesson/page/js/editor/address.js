// @ts-check
// The address of the page: it follows the readings and what is looked at, and is followed.

import { fragmentOf, linkOf } from "./fragment.js";
import { isOtherLook, lookOf, stateOfLook } from "./look.js";
import { refusalOf, refusedWords, sentenceOf } from "./refusals.js";
import { readingsPart, withReadings } from "../fragment-parts.js";
import { csvOf, isSameSheet, pageOf, requestOf, sheetOf } from "./sheet.js";
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
  const look = lookOf(store.lesson(), store.get());
  const link = isSameSheet(sheet, own)
    ? { request: {}, table: null, page: look }
    : { request: requestOf(sheet), table: csvOf(sheet), page: { ...sheet.page, ...look } };
  const words = await fragmentOf(link);
  if (sheet !== session.right()) return;
  // What is looked at means nothing without the readings.
  const fragment = words ? `#${words}` : "";
  const { href, pathname, search } = location;
  bench.link = words === null ? null : href.split("#")[0] + fragment;
  if (isElsewhere()) history.replaceState(null, "", `#${withReadings(location.hash.slice(1), words ?? "")}`);
  else history.replaceState(null, "", fragment || `${pathname}${search}`);
  bench.draw();
}

/** Half-planes that stand in the place of the readings have keys and files of their own, and a part of the address. */
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
  addEventListener("hashchange", () => followAddress(bench));
  followAddress(bench);
}

/** @param {Workbench} bench */
function followAddress(bench) {
  const words = readingsPart(location.hash.slice(1));
  // The link past the header names a part of the page.
  if (words === "" || document.getElementById(words) !== null) return;
  bench.notice = null;
  const following = readAddress(bench, words).catch((error) => {
    bench.notice = () => sentenceOf(refusalOf(error));
  }).finally(() => {
    if (bench.following === following) bench.following = null;
    bench.draw();
  });
  bench.following = following;
  bench.draw();
}

/**
 * @param {Workbench} bench
 * @param {string} words
 */
async function readAddress(bench, words) {
  // Links are followed in their order.
  await bench.following;
  const { session, store } = bench;
  const link = await linkOf(words);
  if (link instanceof Error) {
    bench.notice = () => t(`edit.link-${link.message}`);
    return;
  }
  const sheet = await sheetOfLink(bench, link);
  if (sheet instanceof Error) {
    bench.notice = () => t("edit.link-refused", { problem: refusedWords(refusalOf(sheet)) });
    return;
  }
  if (sheet !== null && !isSameSheet(sheet, session.right())) session.edit(sheet, t("edit.did.link"));
  await session.settled();
  store.change(stateOfLook(link.page, store.lesson()));
}

/**
 * The sheet that a link asks for, as the engine reads it: about the page's own readings where it has none. Null for a link that is not
 * about readings, an Error where the engine refuses it.
 * @param {Workbench} bench
 * @param {Link} link
 * @returns {Promise<Sheet | Error | null>}
 */
async function sheetOfLink({ engine, own }, { request, table, page }) {
  if (Object.keys(request).length === 0 && table === null) return null;
  const words = { ...(table === null ? own.page : {}), ...pageOf(page) };
  try {
    const data = JSON.parse(await engine.ask("lesson", table ?? csvOf(own), { ...words, ...request }));
    return sheetOf(data, request);
  } catch (error) {
    return error instanceof Error ? error : new Error(`${error}`);
  }
}
