import { film as english } from "../texts/en/film";
import { languageHere } from "../texts/language";
import { film as norwegian } from "../texts/nb/film";

/** Texts of films and pictures of any size, which are loaded when one is wanted. */
export const words = { en: english, nb: norwegian }[languageHere()];
