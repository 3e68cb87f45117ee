/** Languages of the app by their codes, each under its name in that language. */
export const LANGUAGES = { en: "English", nb: "Norsk (bokmål)" } as const;
export type Language = keyof typeof LANGUAGES;

/** Whether the app has texts for a code. */
export function isLanguage(code: string): code is Language {
  return code in LANGUAGES;
}

const KEY = "kingpost.language";
/** Browsers' codes for Norwegian; the app offers bokmål for all of them. */
const NORWEGIAN = ["nb", "no", "nn"];

/** Returns the chosen language; otherwise the first of the browser's languages that the app has; otherwise English. */
export function languageOf(chosen: string | null, preferred: readonly string[]): Language {
  const known = [chosen ?? "", ...preferred].map((tag) => tag.toLowerCase().split("-")[0]);
  return known.map((code) => (NORWEGIAN.includes(code) ? "nb" : code)).find(isLanguage) ?? "en";
}

/** Returns the language of the page; in a worker, the name of the worker gives it. */
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

/** Stores the choice and reloads the page at the same address, because its texts are written only once. */
export function chooseLanguage(language: Language): void {
  try {
    localStorage.setItem(KEY, language);
  } catch {
    // Without storage, the page keeps the browser's language.
  }
  location.reload();
}
