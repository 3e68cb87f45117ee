/** Fetches a file's text; null if the file does not exist. Throws a fault if this is unknown. */
export type FetchText = (url: string) => Promise<string | null>;

/** Texts of files by their names. */
export type Texts = Record<string, string>;

/** Endings of the names of hydrodynamic databases and tables, which are not scenarios. */
const NO_SCENARIOS = [".hydro.json", ".csv"];
/** Fields of which every scenario has at least one, in YAML or JSON: first the field that names other files. */
const OF_SCENARIOS = [/(^|[{,\s])"?parts"?\s*:/m, /(^|[{,\s])"?bodies"?\s*:/m];
/** Prefix of names of files that are in the gallery. */
const GALLERY = "gallery:";

export function isOfGallery(name: string): boolean {
  return name.startsWith(GALLERY);
}

/** Returns the name of the scenario among files that were opened together; undefined if there is none. */
export function scenarioAmong(texts: Texts): string | undefined {
  const names = Object.keys(texts).filter((name) => !NO_SCENARIOS.some((ending) => name.endsWith(ending)));
  const found = OF_SCENARIOS.map((field) => names.find((name) => field.test(texts[name])));
  return found.find((name) => name !== undefined) ?? names[0];
}

/** Fetches the texts of all files of a scenario: its parts may name further files. */
export async function gathered(
  namesBy: (texts: Texts) => readonly string[],
  take: (names: readonly string[]) => Promise<Texts>,
): Promise<Texts> {
  const asked = new Set<string>();
  let texts: Texts = {};
  for (;;) {
    const names = namesBy(texts).filter((name) => !asked.has(name));
    if (names.length === 0) return texts;
    names.forEach((name) => asked.add(name));
    texts = { ...texts, ...(await take(names)) };
  }
}

/**
 * Returns the texts of the named files. A name with the gallery's prefix is read from the gallery's folder. Any other
 * is one of the files that were opened with the scenario, or otherwise a file in the scenario's folder `own`.
 */
export async function textsOf(names: readonly string[], opened: Texts | null, gallery: ScenarioFiles, own = gallery): Promise<Texts> {
  const beside = names.filter((name) => !isOfGallery(name));
  const shared = names.filter(isOfGallery).map((name) => name.slice(GALLERY.length));
  const found = Object.entries(await gallery.take(shared)).map(([name, text]) => [GALLERY + name, text]);
  return { ...Object.fromEntries(found), ...(opened ? openedWith(beside, opened) : await own.take(beside)) };
}

/** Returns those of the named files that were opened with the scenario; folders in the names are ignored. */
export function openedWith(names: readonly string[], opened: Texts): Texts {
  const found = names.map((name) => [name, opened[name.slice(name.lastIndexOf("/") + 1)]] as const);
  return Object.fromEntries(found.filter(([, text]) => text !== undefined));
}

/**
 * Files that scenarios name, each fetched once from the gallery's folder. A missing file is left out, and the engine
 * reports it.
 */
export class ScenarioFiles {
  private readonly texts = new Map<string, Promise<string | null>>();

  constructor(
    /** Address of the gallery's folder, with a slash at the end. */
    private readonly folder: string,
    private readonly fetchText: FetchText,
  ) {}

  async take(names: readonly string[]): Promise<Texts> {
    const texts = await Promise.all(names.map((name) => this.text(name)));
    return Object.fromEntries(names.flatMap((name, i) => (texts[i] === null ? [] : [[name, texts[i]] as const])));
  }

  private async text(name: string): Promise<string | null> {
    const known = this.texts.get(name) ?? this.fetch(name);
    this.texts.set(name, known);
    const text = await known.catch((fault: unknown) => {
      this.texts.delete(name);
      throw fault;
    });
    if (text === null) this.texts.delete(name);
    return text;
  }

  /** Fetches a file; its name cannot lead outside the folder. */
  private async fetch(name: string): Promise<string | null> {
    const href = addressOf(name, this.folder);
    return href.startsWith(this.folder) ? this.fetchText(href) : null;
  }
}

/** Address of a file in the folder; empty if the name is not possible in an address. */
function addressOf(name: string, folder: string): string {
  try {
    return new URL(name, folder).href;
  } catch {
    return "";
  }
}
