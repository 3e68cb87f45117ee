import type { Values } from "./engine";
import { gathered, ScenarioFiles, textsOf } from "./files";
import type { Texts } from "./files";
import type { OpenRequest } from "./messages";
import { fetchText } from "./network";
import { file_names } from "./pkg/kingpost_wasm.js";

/** Names of the files that a scenario needs, as far as the known texts tell. */
export function fileNames(text: string, file = "", overrides: Values = {}, texts: Texts = {}): string[] {
  return JSON.parse(file_names(text, file, JSON.stringify(overrides), JSON.stringify(texts)));
}

/** The files that scenarios name: for a user's scenario the files opened with it, for one of the gallery the files of its folder. */
export class FilesOfScenarios {
  private readonly folders = new Map<string, ScenarioFiles>();

  of({ text, file, overrides, opened, folder }: Omit<OpenRequest, "kind" | "changes">): Promise<Record<string, string>> {
    const known = this.folders.get(folder) ?? new ScenarioFiles(folder, fetchText);
    this.folders.set(folder, known);
    return gathered(
      (texts) => fileNames(text, file, overrides, texts),
      (names) => textsOf(names, opened, known),
    );
  }
}
