/** Fetches a file's text; null where there is none. */
export type FetchText = (url: string) => Promise<string | null>;

/**
 * The files that scenarios name, by the names that they give them: fetched from the gallery's
 * folder, each once. One that is not there is left out, for the engine says so best.
 */
export class ScenarioFiles {
  private readonly texts = new Map<string, Promise<string | null>>();

  constructor(
    /** Address of the gallery's folder, with the slash at its end. */
    private readonly folder: string,
    private readonly fetchText: FetchText,
  ) {}

  async take(names: readonly string[]): Promise<Record<string, string>> {
    const texts = await Promise.all(names.map((name) => this.text(name)));
    const there = names.map((name, i) => [name, texts[i]] as const).filter(([, text]) => text !== null);
    return Object.fromEntries(there) as Record<string, string>;
  }

  private async text(name: string): Promise<string | null> {
    const known = this.texts.get(name) ?? this.fetch(name);
    this.texts.set(name, known);
    const text = await known;
    if (text === null) this.texts.delete(name);
    return text;
  }

  /** A name leads nowhere but into the folder. */
  private async fetch(name: string): Promise<string | null> {
    try {
      const { href } = new URL(name, this.folder);
      return href.startsWith(this.folder) ? await this.fetchText(href) : null;
    } catch {
      return null;
    }
  }
}

export async function fetchText(url: string): Promise<string | null> {
  const response = await fetch(url);
  return response.ok ? response.text() : null;
}
