import type { Fault } from "../engine/engine";

export interface GalleryEntry {
  name: string;
  title: string;
  file: string;
  /** Whether the page opens with it. */
  opens?: boolean;
}

/** Address of the gallery's folder beside a page, with the slash at its end. */
export function galleryFolder(base: string): string {
  return new URL("scenarios/", base).href;
}

/** The gallery beside the page, from wherever the folder is served. */
export class Gallery {
  private constructor(
    private readonly base: string,
    readonly entries: GalleryEntry[],
  ) {}

  static async load(base: string): Promise<Gallery> {
    const text = await fetchText(new URL("scenarios/index.json", base));
    return new Gallery(base, JSON.parse(text) as GalleryEntry[]);
  }

  /** The scenario that the server was started with. */
  get opening(): string | undefined {
    return this.entries.find(({ opens }) => opens)?.name;
  }

  async read(name: string): Promise<{ text: string; file: string }> {
    const entry = this.entries.find((known) => known.name === name);
    if (!entry) throw this.unknown(name);
    return { text: await fetchText(new URL(`scenarios/${entry.file}`, this.base)), file: entry.file };
  }

  private unknown(name: string): Fault {
    const known = this.entries.map((entry) => entry.name).join(", ");
    return {
      kind: "scenario",
      message: `scenario: found ${name}, allowed: ${known}`,
      field: "scenario",
      found: name,
      allowed: known,
    };
  }
}

async function fetchText(url: URL): Promise<string> {
  const response = await fetch(url);
  if (!response.ok) throw { kind: "internal", message: `${url.pathname}: ${response.status} ${response.statusText}` };
  return response.text();
}
