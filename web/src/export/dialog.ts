import { fixed } from "../app/format";
import type { Session } from "../app/session";
import type { Plot } from "../plots/plot";
import { tool } from "../plots/tool";
import { fileOf, fileOfAll } from "../runs/files";
import type { Runs } from "../runs/runs";
import { words } from "../runs/words";
import { texts } from "../texts";
import { make, setText } from "../ui/dom";
import { download } from "../ui/download";
import { saveScenario } from "../ui/saving";
import type { Scene } from "../view/scene";
import { pictureOfPlot, pictureOfShip } from "./pictures";
import { RunFiles } from "./run_files";
import type { MadeFile } from "./run_files";

/** A file that can be saved. */
interface Choice {
  name: string;
  help: string;
  testId: string;
  make(): Promise<MadeFile | string | null>;
}

/** Dialog with all files of a run that can be saved: the recording, pictures and the scenario. */
export class ExportDialog {
  private readonly dialog = make("dialog", { class: "picker picker-small", "aria-label": texts.exports.title, "data-testid": "export-dialog" });
  private readonly body = make("div", { class: "export-choices" });
  private readonly said = make("p", { class: "muted", role: "status", "data-testid": "export-said" });
  private readonly files: RunFiles;

  constructor(
    private readonly session: Session,
    private readonly scene: Scene,
    private readonly plots: () => readonly Plot[],
    private readonly runs: Runs,
    /** Opens the dialog for films and pictures of any size. */
    private readonly openFilm: () => Promise<void>,
  ) {
    this.files = new RunFiles(session);
    const close = make("button", { class: "button button-primary", "data-testid": "export-close" }, texts.exports.close);
    this.dialog.append(make("form", { method: "dialog" }, make("h2", {}, texts.exports.title), this.body, this.said, make("div", { class: "picker-buttons" }, close)));
    this.dialog.addEventListener("click", (event) => event.target === this.dialog && this.dialog.close());
    document.body.append(this.dialog);
  }

  /** Opens the dialog, if a scenario is open. */
  open(): void {
    if (!this.session.run) return;
    setText(this.said, "");
    this.body.replaceChildren(
      this.group(texts.exports.recording, this.recording(), this.rows()),
      ...(this.runs.all.length > 0 ? [this.group(words.files, this.kept())] : []),
      this.group(texts.exports.pictures, this.pictures()),
      this.group(texts.exports.film, [], "", this.filmButton()),
      this.group(texts.exports.scenario, [{ name: texts.exports.save, help: texts.exports.save_help, testId: "export-scenario", make: () => saveScenario(this.session) }]),
    );
    this.dialog.showModal();
  }

  /** Describes the number of rows, and whether the recording is complete. */
  private rows(): string {
    const { recorded, rows, thinnedUntil_s, last_s } = this.files.kept;
    if (thinnedUntil_s === null) return texts.exports.rows(rows.length, fixed(last_s, 2));
    return texts.exports.thinned(rows.length, recorded, fixed(thinnedUntil_s, 2));
  }

  private recording(): Choice[] {
    const { files } = this;
    const say = texts.exports;
    const events = { name: say.events, help: "", testId: "export-events", make: () => files.events() };
    return [
      { name: say.csv, help: say.csv_help, testId: "export-csv", make: () => files.csv() },
      { name: say.parquet, help: say.parquet_help, testId: "export-parquet", make: () => files.parquet() },
      ...(files.hasEvents ? [events] : []),
    ];
  }

  private kept(): Choice[] {
    const { all } = this.runs;
    const each = all.map((run) => ({ name: words.file(run.mark, run.name), help: "", testId: `export-run-${run.mark}`, make: () => fileOf(run) }));
    return [{ name: words.together, help: words.together_help, testId: "export-runs", make: () => fileOfAll(this.session, all) }, ...each];
  }

  private pictures(): Choice[] {
    const ship = { name: texts.exports.picture, help: "", testId: "export-ship", make: () => this.ship() };
    const plots = this.plots().map((plot) => ({
      name: texts.exports.plot(plot.heading),
      help: "",
      testId: `export-plot-${plot.place}`,
      make: () => this.file(plot.heading, pictureOfPlot(plot, this.heading)),
    }));
    return [ship, ...plots];
  }

  private get heading(): string {
    const { run, shown } = this.session;
    return `${run!.model.title}, ${fixed(shown.time_s, 2)} s`;
  }

  private async ship(): Promise<MadeFile | null> {
    const canvas = this.scene.picture();
    return this.file("ship", canvas && pictureOfShip(canvas, this.session.run!.model.title, `${fixed(this.session.shown.time_s, 2)} s`));
  }

  private async file(title: string, picture: Promise<Blob | null> | null): Promise<MadeFile | null> {
    const content = await picture;
    const words = title.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "").slice(0, 40);
    return content && { name: `${this.files.stem}-${words}.png`, content };
  }

  private filmButton(): HTMLElement {
    const button = make("button", { type: "button", class: "button export-choice", "aria-haspopup": "dialog", "data-testid": "export-film" }, make("span", {}, texts.exports.open_film), make("span", { class: "muted" }, texts.exports.film_help));
    button.addEventListener("click", () => {
      this.dialog.close();
      this.openFilm().catch((thrown: unknown) => this.session.report({ kind: "file", message: `${texts.exports.failed}: ${String(thrown)}` }));
    });
    return button;
  }

  private group(title: string, choices: readonly Choice[], about = "", ...more: HTMLElement[]): HTMLElement {
    const notes = about ? [make("p", { class: "muted", "data-testid": "export-rows" }, about)] : [];
    return make("section", {}, make("h3", {}, title), ...notes, ...choices.map((choice) => this.button(choice)), ...more);
  }

  private button(choice: Choice): HTMLElement {
    const help = choice.help ? [make("span", { class: "muted" }, choice.help)] : [];
    const button = make("button", { type: "button", class: "button export-choice", "data-testid": choice.testId }, make("span", {}, choice.name), ...help);
    button.addEventListener("click", () => void this.keep(choice, button));
    return button;
  }

  private async keep(choice: Choice, button: HTMLButtonElement): Promise<void> {
    button.disabled = true;
    try {
      const made = await choice.make();
      if (made && typeof made !== "string") download(made.name, made.content);
      const name = typeof made === "string" ? made : made?.name;
      setText(this.said, name ? texts.exports.done(name) : texts.exports.failed);
    } catch (thrown) {
      setText(this.said, `${texts.exports.failed}: ${String(thrown)}`);
    }
    button.disabled = false;
    button.focus();
  }
}

/** Returns the button that opens the dialog. */
export function exportTool(session: Session, scene: Scene, plots: () => readonly Plot[], runs: Runs, openFilm: () => Promise<void>): HTMLElement {
  const dialog = new ExportDialog(session, scene, plots, runs, openFilm);
  return tool(texts.exports.open, texts.exports.open, "export", "M10 13V3M6 7l4-4 4 4M3.5 12v4.5h13V12", () => dialog.open());
}
