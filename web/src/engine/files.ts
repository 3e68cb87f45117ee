/** Fetches a file's text; null where there is none, and a fault where that cannot be known. */
export type FetchText = (url: string) => Promise<string | null>;

/** Texts of files by their names. */
export type Texts = Record<string, string>;

/** How names of hydrodynamic databases and of tables end, which are no scenarios. */
const NO_SCENARIOS = [".hydro.json", ".csv"];
/** What every scenario has one of, in YAML or JSON: what names other files before what may be one of them. */
const OF_SCENARIOS = [/(^|[{,\s])"?parts"?\s*:/m, /(^|[{,\s])"?bodies"?\s*:/m];
/** What the names of the gallery's files begin with. */
const GALLERY = "gallery:";

export function isOfGallery(name: string): boolean {
  return name.startsWith(GALLERY);
}

/** Which of some files is the scenario that names the others; undefined where none can be. */
export function scenarioAmong(texts: Texts): string | undefined {
  const names = Object.keys(texts).filter((name) => !NO_SCENARIOS.some((ending) => name.endsWith(ending)));
  const found = OF_SCENARIOS.map((field) => names.find((name) => field.test(texts[name])));
  return found.find((name) => name !== undefined) ?? names[0];
}

/** The texts of all files behind a scenario: a part names files of its own once it is there. */
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
 * The files of these names: those of the gallery from its folder; others from those that a person opened with the
 * scenario, for a file of the same name in the gallery would be another, else from the gallery's folder too.
 */
export async function textsOf(names: readonly string[], opened: Texts | null, gallery: ScenarioFiles): Promise<Texts> {
  const own = names.filter((name) => !isOfGallery(name));
  const shared = names.filter(isOfGallery).map((name) => name.slice(GALLERY.length));
  const found = Object.entries(await gallery.take(shared)).map(([name, text]) => [GALLERY + name, text]);
  return { ...Object.fromEntries(found), ...(opened ? openedWith(own, opened) : await gallery.take(own)) };
}

/** Of the files that a scenario names those that a person opened with it, whatever folder it names them in. */
export function openedWith(names: readonly string[], opened: Texts): Texts {
  const found = names.map((name) => [name, opened[name.slice(name.lastIndexOf("/") + 1)]] as const);
  return Object.fromEntries(found.filter(([, text]) => text !== undefined));
}

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

  async take(names: readonly string[]): Promise<Texts> {
    const texts = await Promise.all(names.map((name) => this.text(name)));
    const there = names.map((name, i) => [name, texts[i]] as const).filter(([, text]) => text !== null);
    return Object.fromEntries(there) as Texts;
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

  /** A name leads nowhere but into the folder. */
  private async fetch(name: string): Promise<string | null> {
    const href = addressOf(name, this.folder);
    return href.startsWith(this.folder) ? this.fetchText(href) : null;
  }
}

/** Empty where the name is none that an address can have. */
function addressOf(name: string, folder: string): string {
  try {
    return new URL(name, folder).href;
  } catch {
    return "";
  }
}
