import { figure as english } from "../texts/en/figure";
import { languageHere } from "../texts/language";
import { figure as norwegian } from "../texts/nb/figure";

/** Texts of the figure in the language of the page, without all other texts of the app. */
export const words = { en: english, nb: norwegian }[languageHere()];
