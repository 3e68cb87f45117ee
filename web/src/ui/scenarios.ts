import { faultOfDatabase } from "../app/faults";
import type { Gallery } from "../app/gallery";
import type { Fault } from "../engine/engine";
import { openingOverrides } from "../app/opening";
import type { Session } from "../app/session";
import { scenarioAmong } from "../engine/files";
import { byId, make } from "./dom";

const FILE_OPTION = "a file of yours";

/** Choosing a scenario: from the gallery, from a file, or dropped on the page. */
export class Scenarios {
  private readonly select = byId<HTMLSelectElement>("gallery");
  private shown = "";

  constructor(
    private readonly session: Session,
    private readonly gallery: Gallery,
  ) {
    this.fill();
    this.select.addEventListener("change", () => void this.choose(this.select.value));
    const input = byId<HTMLInputElement>("file");
    byId("open-file").addEventListener("click", () => input.click());
    input.addEventListener("change", () => {
      const files = [...(input.files ?? [])];
      input.value = "";
      void this.openFiles(files);
    });
    this.acceptDrops();
  }

  async openNamed(name: string): Promise<boolean> {
    try {
      const source = await this.gallery.read(name);
      if (await this.session.open(source, openingOverrides(name))) {
        this.shown = name;
        this.fill();
        return true;
      }
    } catch (fault) {
      this.session.report(fault as Fault);
    }
    this.select.value = this.shown;
    return false;
  }

  /** What is chosen by hand stands in the address, so that a link to it can be sent. */
  private async choose(name: string): Promise<void> {
    if (await this.openNamed(name)) history.replaceState(null, "", `?scenario=${encodeURIComponent(name)}`);
  }

  /** A scenario, and with it the files that it names. */
  private async openFiles(files: File[]): Promise<void> {
    if (files.length === 0) return;
    const texts = Object.fromEntries(await Promise.all(files.map(async (file) => [file.name, await file.text()] as const)));
    const file = scenarioAmong(texts);
    if (!file) return this.session.report(faultOfDatabase(files[0].name));
    const { [file]: text, ...opened } = texts;
    if (await this.session.open({ text, file, opened }, {})) {
      this.shown = FILE_OPTION;
      this.fill(file);
    }
  }

  private fill(fileName?: string): void {
    const options = this.gallery.entries.map((entry) => make("option", { value: entry.name }, entry.title || entry.name));
    if (fileName) options.push(make("option", { value: FILE_OPTION, disabled: true }, fileName));
    this.select.replaceChildren(...options);
    this.select.value = this.shown;
  }

  private acceptDrops(): void {
    const veil = byId("drop");
    let depth = 0;
    const carriesFile = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
    const show = (change: number) => {
      depth = Math.max(0, depth + change);
      veil.hidden = depth === 0;
    };
    addEventListener("dragenter", (event) => carriesFile(event) && show(1));
    addEventListener("dragleave", (event) => carriesFile(event) && show(-1));
    addEventListener("dragover", (event) => event.preventDefault());
    addEventListener("drop", (event) => {
      event.preventDefault();
      show(-depth);
      void this.openFiles([...(event.dataTransfer?.files ?? [])]);
    });
  }
}
