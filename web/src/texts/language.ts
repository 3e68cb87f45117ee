/** The languages of the app by their codes, each with its own name for itself. */
export const LANGUAGES = { en: "English", nb: "Norsk (bokmål)" } as const;
export type Language = keyof typeof LANGUAGES;

const KEY = "kingpost.language";
/** What browsers say for Norwegian, of which bokmål is the one that is here. */
const NORWEGIAN = ["nb", "no", "nn"];

/** The language that was chosen; else the first of the browser's that is here; else English. */
export function languageOf(chosen: string | null, preferred: readonly string[]): Language {
  const known = [chosen ?? "", ...preferred].map((tag) => tag.toLowerCase().split("-")[0]);
  const here = known.map((code) => (NORWEGIAN.includes(code) ? "nb" : code)).find((code) => code in LANGUAGES);
  return (here as Language | undefined) ?? "en";
}

/** Of the page; a worker is started in the language of its page, which is its name. */
export function languageHere(): Language {
  if (typeof document === "undefined") return languageOf(typeof name === "undefined" ? null : name, []);
  return languageOf(chosenLanguage(), navigator.languages);
}

function chosenLanguage(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

/** The page loads anew at the same address: all its texts are written once. */
export function chooseLanguage(language: Language): void {
  try {
    localStorage.setItem(KEY, language);
  } catch {
    // Where nothing can be kept, the browser's language stays.
  }
  location.reload();
}
