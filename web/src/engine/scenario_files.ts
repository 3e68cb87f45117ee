import { gathered, ScenarioFiles, textsOf } from "./files";
import type { OpenRequest } from "./messages";
import { fetchText } from "./network";
import { file_names } from "./pkg/kingpost_wasm.js";

/** The files that scenarios name: for a user's scenario the files opened with it, for one of the gallery the files of its folder. */
export class FilesOfScenarios {
  private readonly folders = new Map<string, ScenarioFiles>();

  of({ text, file, overrides, opened, folder }: Omit<OpenRequest, "kind" | "changes">): Promise<Record<string, string>> {
    const known = this.folders.get(folder) ?? new ScenarioFiles(folder, fetchText);
    this.folders.set(folder, known);
    const set = JSON.stringify(overrides);
    return gathered(
      (texts) => JSON.parse(file_names(text, file, set, JSON.stringify(texts))) as string[],
      (names) => textsOf(names, opened, known),
    );
  }
}
