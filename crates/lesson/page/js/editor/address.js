// @ts-check
// The address of the page: it follows the readings, and is followed.

import { fragmentOf, sheetOfFragment } from "./fragment.js";
import { isSameSheet } from "./sheet.js";
import { t } from "../texts.js";

/** An address is not changed more often: browsers refuse that. */
const MILLISECONDS_PER_ADDRESS = 400;

/** @type {ReturnType<typeof setTimeout> | null} */
let addressTimer = null;

/**
 * Writes the readings into the address when they have been still for a moment.
 * @param {Workbench} bench
 */
export function writeAddressSoon(bench) {
  if (addressTimer === null) addressTimer = setTimeout(writeAddress, MILLISECONDS_PER_ADDRESS, bench);
}

/** @param {Workbench} bench */
async function writeAddress(bench) {
  addressTimer = null;
  const { session, own } = bench;
  const sheet = session.right();
  const fragment = isSameSheet(sheet, own) ? "" : await fragmentOf(sheet);
  if (sheet !== session.right()) return;
  const { pathname, search } = location;
  history.replaceState(null, "", fragment ? fragment : `${pathname}${search}`);
  bench.link = fragment === null ? null : location.href;
  bench.draw();
}

/**
 * Takes the readings of the address, now and whenever it changes.
 * @param {Workbench} bench
 */
export function connectAddress(bench) {
  addEventListener("hashchange", () => readAddress(bench));
  readAddress(bench);
}

/** @param {Workbench} bench */
async function readAddress(bench) {
  const { session } = bench;
  const found = await sheetOfFragment(location.hash);
  if (found === null) return;
  if (found instanceof Error) bench.notice = t(found.message === "version" ? "edit.link-version" : "edit.link-damaged");
  else if (!isSameSheet(found, session.right())) session.edit(found, t("edit.did.link"));
  bench.draw();
}
