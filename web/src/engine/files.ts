/** Fetches a file's text; null if it does not exist, and a fault if that is unknown. */
export type FetchText = (url: string) => Promise<string | null>;

/** Texts of files by their names. */
export type Texts = Record<string, string>;

/** Endings of hydrodynamic databases and tables, which are not scenarios. */
const NO_SCENARIOS = [".hydro.json", ".csv"];
/** Fields of which every scenario has one, in YAML or JSON: first those that name other files. */
const OF_SCENARIOS = [/(^|[{,\s])"?parts"?\s*:/m, /(^|[{,\s])"?bodies"?\s*:/m];
/** Prefix of the names of files in the gallery. */
const GALLERY = "gallery:";

export function isOfGallery(name: string): boolean {
  return name.startsWith(GALLERY);
}

/** The scenario among some files, which names the others; undefined if there is none. */
export function scenarioAmong(texts: Texts): string | undefined {
  const names = Object.keys(texts).filter((name) => !NO_SCENARIOS.some((ending) => name.endsWith(ending)));
  const found = OF_SCENARIOS.map((field) => names.find((name) => field.test(texts[name])));
  return found.find((name) => name !== undefined) ?? names[0];
}

/** The texts of all files of a scenario: parts may name further files. */
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
 * The files of these names. Names with the gallery's prefix come from its folder. Others come from the files that were opened with the
 * scenario; if the scenario is one of the gallery, they also come from the gallery's folder.
 */
export async function textsOf(names: readonly string[], opened: Texts | null, gallery: ScenarioFiles): Promise<Texts> {
  const own = names.filter((name) => !isOfGallery(name));
  const shared = names.filter(isOfGallery).map((name) => name.slice(GALLERY.length));
  const found = Object.entries(await gallery.take(shared)).map(([name, text]) => [GALLERY + name, text]);
  return { ...Object.fromEntries(found), ...(opened ? openedWith(own, opened) : await gallery.take(own)) };
}

/** The files of a scenario that were opened with it; the folders in their names are ignored. */
export function openedWith(names: readonly string[], opened: Texts): Texts {
  const found = names.map((name) => [name, opened[name.slice(name.lastIndexOf("/") + 1)]] as const);
  return Object.fromEntries(found.filter(([, text]) => text !== undefined));
}

/**
 * The files that scenarios name, by name: fetched once from the gallery's folder. A missing file is left out; the engine then reports it.
 */
export class ScenarioFiles {
  private readonly texts = new Map<string, Promise<string | null>>();

  constructor(
    /** Address of the gallery's folder, with the slash at its end. */
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

  /** A name cannot lead outside the folder. */
  private async fetch(name: string): Promise<string | null> {
    const href = addressOf(name, this.folder);
    return href.startsWith(this.folder) ? this.fetchText(href) : null;
  }
}

/** Empty if the name is not possible in an address. */
function addressOf(name: string, folder: string): string {
  try {
    return new URL(name, folder).href;
  } catch {
    return "";
  }
}
