import { en } from "./en";

/** What the texts of a language must have. */
export type Texts = typeof en;

/** The texts of the page. */
export const texts: Texts = en;
