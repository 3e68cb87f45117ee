import type { Fault } from "../engine/engine";
import { faultOfNetwork } from "../engine/faults";
import { fetchText } from "../engine/network";
import type { Source } from "./run";

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
    const { href } = new URL("scenarios/index.json", base);
    const text = await textAt(href);
    try {
      return new Gallery(base, JSON.parse(text) as GalleryEntry[]);
    } catch {
      throw faultOfNetwork(href, "it is no JSON");
    }
  }

  static empty(base: string): Gallery {
    return new Gallery(base, []);
  }

  /** The scenario that the server was started with. */
  get opening(): string | undefined {
    return this.entries.find(({ opens }) => opens)?.name;
  }

  async read(name: string): Promise<Source> {
    const entry = this.entries.find((known) => known.name === name);
    if (!entry) throw this.unknown(name);
    return { text: await textAt(new URL(`scenarios/${entry.file}`, this.base).href), file: entry.file, gallery: name };
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

async function textAt(url: string): Promise<string> {
  const text = await fetchText(url);
  if (text === null) throw faultOfNetwork(url, "it is not there");
  return text;
}
