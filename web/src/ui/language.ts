import { language, texts } from "../texts";
import { chooseLanguage, isLanguage, LANGUAGES } from "../texts/language";
import { make } from "./dom";

/** Returns the choice of the language; each language has its own name for itself. */
export function languageChoice(testId: string): HTMLElement {
  const options = Object.entries(LANGUAGES).map(([code, name]) => make("option", { value: code, lang: code, selected: code === language }, name));
  const select = make("select", { title: texts.page.language_help, "data-testid": testId }, ...options);
  select.addEventListener("change", () => isLanguage(select.value) && chooseLanguage(select.value));
  return make("label", { class: "setting" }, texts.page.language, select);
}
