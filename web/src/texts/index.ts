import * as en from "./en";
import { languageHere } from "./language";
import type { Language } from "./language";
import * as nb from "./nb";

/** Type of the texts that each language must have. */
export type Texts = typeof en;

const ALL: Record<Language, Texts> = { en, nb };

/** Language of the page. */
export const language: Language = languageHere();

/** Texts of the page, in its language. */
export const texts: Texts = ALL[language];
