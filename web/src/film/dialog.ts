import "../styles/film.css";
import { fixed } from "../app/format";
import { stemOf } from "../app/saved";
import { asFault } from "../engine/engine";
import { make, setText } from "../ui/dom";
import { download } from "../ui/download";
import { countOf, FORMATS, longestOf } from "./choice";
import type { Format } from "./choice";
import { canEncode, codecOf } from "./encoder";
import { CancelledError, makeFilm, makePicture } from "./film";
import type { Studio } from "./film";
import { Fields } from "./fields";
import { MOST_PLOTS } from "./layout";
import { words } from "./words";

/** Dialog for a film of a part of the recording, and for a picture of any size of the moment that is shown. */
export class FilmDialog {
  private readonly dialog = make("dialog", { class: "picker", "aria-labelledby": "film-title", "data-testid": "film-dialog" });
  private readonly fields = new Fields(() => void this.check());
  private readonly about = make("p", { class: "muted", "data-testid": "film-about" });
  private readonly said = make("p", { class: "muted", role: "status", "data-testid": "film-said" });
  private readonly bar = make("progress", { hidden: true, "aria-labelledby": "film-title", "data-testid": "film-progress" });
  private readonly film = button(words.make, "film-make");
  private readonly picture = button("", "film-picture");
  private readonly cancel = button(words.cancel, "film-cancel");
  private readonly close = button(words.close, "film-close");
  private work: AbortController | null = null;

  constructor(private readonly studio: Studio) {
    const notes = [words.camera, ...(canEncode() ? [] : [words.no_encoder])].map((note) => make("p", { class: "muted" }, note));
    const buttons = make("div", { class: "picker-buttons" }, this.close, this.cancel, this.picture, this.film);
    const form = make("form", { class: "film-form" }, make("h2", { id: "film-title" }, words.title), this.fields.element, this.about, ...notes, this.bar, this.said, buttons);
    this.dialog.append(form);
    this.film.classList.add("button-primary");
    form.addEventListener("submit", (event) => event.preventDefault());
    this.film.addEventListener("click", () => void this.during(() => this.makeFilm()));
    this.picture.addEventListener("click", () => void this.during(() => this.makePicture()));
    this.cancel.addEventListener("click", () => this.work?.abort());
    this.close.addEventListener("click", () => this.dialog.close());
    // Escape cancels the work first.
    this.dialog.addEventListener("cancel", (event) => {
      if (!this.work) return;
      event.preventDefault();
      this.work.abort();
    });
    document.body.append(this.dialog);
  }

  /** Opens the dialog for the present recording. */
  open(): void {
    const { session } = this.studio;
    if (!session.run || !session.shown.recording) return;
    session.pause();
    const plots = this.studio.plots().filter(({ view, drawn }) => view.kind === "time" && drawn.length > 0).length;
    this.fields.offer(session.shown.recording.now.time_s, plots > MOST_PLOTS ? words.most_plots(MOST_PLOTS) : words.plots, plots > 0);
    setText(this.picture, words.picture(`${fixed(session.shown.time_s, 2)} s`));
    setText(this.said, "");
    this.show();
    this.dialog.showModal();
    void this.check();
  }

  /** Describes the film that the fields choose, and offers the formats that the browser encodes in its size. */
  private async check(): Promise<void> {
    const { choice } = this.fields;
    const { size, frames_per_s } = choice;
    const frames = countOf(choice);
    const isWhole = frames > 0 && Number.isFinite(frames) && size.width > 0;
    const longest = words.minutes(fixed(longestOf(size, frames_per_s) / 60, 1));
    setText(this.about, isWhole ? words.about(frames, fixed(frames / frames_per_s, 1), longest) : "");
    const codecs = await Promise.all(FORMATS.map((format) => codecOf(format, size, frames_per_s).catch(() => null)));
    this.fields.offerFormats(FORMATS.filter((_, i) => codecs[i] !== null));
  }

  private async makeFilm(): Promise<void> {
    const { choice } = this.fields;
    const started_ms = performance.now();
    setText(this.said, words.opening);
    const progress = (done: number, of: number) => {
      [this.bar.max, this.bar.value] = [of, done];
      const left_s = Math.ceil((((performance.now() - started_ms) / done) * (of - done)) / 1000);
      setText(this.said, words.frame(done, of, done > 1 ? words.left(left_s) : ""));
    };
    this.save(await makeFilm(this.studio, choice, progress, this.work!.signal), choice.format);
  }

  private async makePicture(): Promise<void> {
    const { choice } = this.fields;
    this.save(await makePicture(this.studio, choice, this.studio.session.shown.time_s, [choice.from_s, choice.to_s]), "png");
  }

  private save(content: Blob, suffix: Format | "png"): void {
    const name = `${stemOf(this.studio.session.source?.file ?? "run")}.${suffix}`;
    download(name, content);
    setText(this.said, words.done(name, fixed(content.size / 1e6, 2)));
  }

  private async during(work: () => Promise<void>): Promise<void> {
    if (this.work) return;
    this.work = new AbortController();
    this.show();
    try {
      await work();
    } catch (thrown) {
      setText(this.said, thrown instanceof CancelledError ? words.cancelled : `${words.failed}: ${asFault(thrown).message}`);
    }
    this.work = null;
    this.show();
  }

  private show(): void {
    const isBusy = this.work !== null;
    this.bar.hidden = this.cancel.hidden = !isBusy;
    this.bar.removeAttribute("value");
    this.fields.element.disabled = this.picture.disabled = this.close.disabled = isBusy;
    this.film.disabled = isBusy || !canEncode();
    (isBusy ? this.cancel : canEncode() ? this.film : this.picture).focus();
  }
}

function button(label: string, testId: string): HTMLButtonElement {
  return make("button", { type: "button", class: "button", "data-testid": testId }, label);
}
