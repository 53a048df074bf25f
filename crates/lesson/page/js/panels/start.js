// @ts-check
// The page without readings: what to do, with the table that is typed or pasted into before the pictures.

import { byId } from "../dom.js";
import { t } from "../texts.js";

/**
 * Puts the table first where there are no readings, so that the Tab key goes the way of the eye. The pictures move, not the table: a
 * cell that is typed into keeps the focus.
 * @param {boolean} isFirst
 */
function placeTables(isFirst) {
  const tables = /** @type {HTMLElement} */ (document.querySelector(".tables"));
  const pictures = [byId("introduction"), byId("planes")];
  const wasFirst = (tables.compareDocumentPosition(pictures[0]) & Node.DOCUMENT_POSITION_FOLLOWING) !== 0;
  if (wasFirst === isFirst) return;
  const focused = /** @type {HTMLElement | null} */ (document.activeElement);
  if (isFirst) tables.after(...pictures);
  else tables.before(...pictures);
  if (focused !== document.activeElement) focused?.focus({ preventScroll: true });
}

/**
 * Says what to do where there are no readings; after the titles are filled in.
 * @param {Lesson} lesson
 */
export function drawStart({ readings }) {
  const isEmpty = readings.length === 0;
  document.body.toggleAttribute("data-empty", isEmpty);
  placeTables(isEmpty);
  byId("start").hidden = !isEmpty;
  byId("start").textContent = isEmpty ? t("start.how") : "";
  document.title = isEmpty ? t("start.title") : byId("title").textContent;
  if (!isEmpty) return;
  byId("title").textContent = t("start.title");
  byId("provenance").textContent = t("start.provenance");
}
