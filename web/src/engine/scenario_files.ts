import type { Values } from "./engine";
import { gathered, ScenarioFiles, textsOf } from "./files";
import type { Texts } from "./files";
import type { OpenRequest } from "./messages";
import { fetchText } from "./network";
import { file_names } from "./pkg/kingpost_wasm.js";

/** Names of the files that a scenario needs, as far as they follow from the known texts. */
export function fileNames(text: string, file = "", overrides: Values = {}, texts: Texts = {}): string[] {
  return JSON.parse(file_names(text, file, JSON.stringify(overrides), JSON.stringify(texts)));
}

/**
 * Files that scenarios name: those opened together with a user's scenario, those in the gallery's folder for a scenario
 * of the gallery.
 */
export class FilesOfScenarios {
  private readonly folders = new Map<string, ScenarioFiles>();

  of({ text, file, overrides, opened, folder, beside }: Omit<OpenRequest, "kind" | "changes">): Promise<Record<string, string>> {
    const [shared, own] = [this.in(folder), this.in(beside ?? folder)];
    return gathered(
      (texts) => fileNames(text, file, overrides, texts),
      (names) => textsOf(names, opened, shared, own),
    );
  }

  private in(folder: string): ScenarioFiles {
    const known = this.folders.get(folder) ?? new ScenarioFiles(folder, fetchText);
    this.folders.set(folder, known);
    return known;
  }
}
