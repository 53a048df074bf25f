// @ts-check
// The choice of the language.

import { byId, targetOf } from "../dom.js";
import { currentLanguage, setLanguage } from "../texts.js";

/**
 * Connects the choice; before anything else is drawn, the page speaks the language of the state.
 * @param {Store} store
 */
export function connectLanguage(store) {
  byId("language").value = currentLanguage();
  byId("language").addEventListener("change", (event) => store.change({ language: targetOf(event).value }));
  store.subscribe((state, before) => {
    if (state.language === before.language) return;
    setLanguage(state.language);
    byId("language").value = state.language;
  });
}
