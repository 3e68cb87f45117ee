import type { Fault } from "../engine/engine";
import { faultOfNetwork } from "../engine/faults";
import { fetchText } from "../engine/network";
import { texts } from "../texts";
import type { Source } from "./run";

export interface GalleryEntry {
  name: string;
  title: string;
  file: string;
  description: string;
  /** Group of the scenario in the gallery; left out for a scenario that is not from the gallery. */
  group?: string;
  /** Whether the bare address opens this scenario. */
  opens?: boolean;
}

/** Scenarios that are shown together; those without a group have no title. */
export interface Group {
  title: string | null;
  entries: GalleryEntry[];
}

/** Address of the gallery's folder beside a page, with a slash at the end. */
export function galleryFolder(base: string): string {
  return new URL("scenarios/", base).href;
}

/** The gallery of scenarios, read from the folder beside the page. */
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
      throw faultOfNetwork(href, texts.engine.no_json);
    }
  }

  static empty(base: string): Gallery {
    return new Gallery(base, []);
  }

  /** The scenario that the server was started with. */
  get opening(): string | undefined {
    return this.entries.find(({ opens }) => opens)?.name;
  }

  /** Groups of scenarios, in the order of the list. */
  get groups(): Group[] {
    const groups: Group[] = [];
    for (const entry of this.entries) {
      const title = entry.group ?? null;
      const group = groups.find((one) => one.title === title);
      if (group) group.entries.push(entry);
      else groups.push({ title, entries: [entry] });
    }
    return groups;
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

/**
 * Returns the first sentence of a scenario's description. A full stop after a single letter, or before a number, does
 * not end it.
 */
export function firstSentence(description: string): string {
  const text = description.trim();
  return /^.*?[^\s(.]{2}[.!?](?=\s+[A-Z]|$)/s.exec(text)?.[0] ?? text;
}

async function textAt(url: string): Promise<string> {
  const text = await fetchText(url);
  if (text === null) throw faultOfNetwork(url, texts.engine.not_there);
  return text;
}
