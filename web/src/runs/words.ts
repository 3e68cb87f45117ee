import { runs as english } from "../texts/en/runs";
import { languageHere } from "../texts/language";
import { runs as norwegian } from "../texts/nb/runs";

/** Texts about kept runs in the language of the page; the start page, which shows none, does not load them. */
export const words = { en: english, nb: norwegian }[languageHere()];
