// @ts-check
// The page without readings: what to do, with the table that is typed or pasted into before the pictures.

import { byId } from "../dom.js";
import { t } from "../texts.js";

/**
 * Says what to do where there are no readings; after the titles are filled in.
 * @param {Lesson} lesson
 */
export function drawStart({ readings, data }) {
  const isEmpty = readings.length === 0;
  document.body.toggleAttribute("data-empty", isEmpty);
  byId("start").hidden = !isEmpty;
  byId("start").textContent = isEmpty ? t("start.how") : "";
  document.title = isEmpty ? t("start.title") : data.title;
  if (!isEmpty) return;
  byId("title").textContent = t("start.title");
  byId("provenance").textContent = t("start.provenance");
}
