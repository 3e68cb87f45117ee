import * as en from "./en";
import { languageHere } from "./language";
import type { Language } from "./language";
import * as nb from "./nb";

/** Texts that a language must have. */
export type Texts = typeof en;

const ALL: Record<Language, Texts> = { en, nb };

/** The language of the page's texts. */
export const language: Language = languageHere();

/** The texts of the page. */
export const texts: Texts = ALL[language];
