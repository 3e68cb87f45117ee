import { fixed } from "../app/format";
import type { Session } from "../app/session";
import { make, setText } from "../ui/dom";
import { download } from "../ui/download";
import { fileOf, recordedOf } from "./files";
import type { KeptRun } from "./kept";
import { bytesOf, KEPT_BYTES } from "./memory";
import { MOST_SHOWN } from "./runs";
import type { Runs } from "./runs";
import { words } from "./words";

/** Dialog with the kept runs: name, colour, where each is shown, its file, and its removal. */
export class RunList {
  private readonly dialog = make("dialog", { class: "picker runs-dialog", "aria-label": words.kept, "data-testid": "run-list" });
  private readonly list = make("ul", { class: "runs-list" });
  private readonly memory = make("p", { class: "muted", "data-testid": "runs-memory" });
  private readonly removeAll = button(words.remove_all, words.remove_all, "remove-all-runs", () => this.runs.remove(...this.runs.all));
  private readonly atReset = make("input", { type: "checkbox", "data-testid": "keep-at-reset" });

  constructor(
    private readonly runs: Runs,
    private readonly session: Session,
  ) {
    this.atReset.addEventListener("change", () => (runs.keepsAtReset = this.atReset.checked));
    const at_reset = make("label", { class: "menu-item" }, this.atReset, make("span", {}, words.at_reset));
    const close = make("button", { class: "button button-primary", "data-testid": "close-runs" }, words.close);
    const buttons = make("div", { class: "picker-buttons" }, this.removeAll, close);
    const notes = make("p", { class: "muted" }, `${words.most(MOST_SHOWN)} ${words.not_stored}`);
    this.dialog.append(make("form", { method: "dialog" }, make("h2", {}, words.kept), this.list, at_reset, this.memory, notes, buttons));
    this.dialog.addEventListener("click", (event) => event.target === this.dialog && this.dialog.close());
    document.body.append(this.dialog);
    runs.onChange(() => this.dialog.open && this.show());
  }

  open(): void {
    this.atReset.checked = this.runs.keepsAtReset;
    this.show();
    this.dialog.showModal();
  }

  private show(): void {
    const { all } = this.runs;
    const focused = this.list.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset.testid : undefined;
    this.list.replaceChildren(...all.map((run) => this.item(run)));
    setText(this.memory, words.memory(fixed(bytesOf(all) / 1e6, 1), fixed(KEPT_BYTES / 1e6, 0)));
    this.removeAll.disabled = all.length === 0;
    if (focused) (this.list.querySelector<HTMLElement>(`[data-testid="${focused}"]`) ?? this.removeAll).focus();
  }

  private item(run: KeptRun): HTMLElement {
    const { runs } = this;
    const { mark, name } = run;
    const colour = make("button", { type: "button", class: "run-colour", title: words.colour(mark), "aria-label": words.colour(mark), "data-testid": `colour-${mark}` }, make("span", { class: "run-swatch", style: `border-color: var(--${run.colour})` }), make("b", {}, mark));
    colour.addEventListener("click", () => runs.recolour(run));
    const named = make("input", { type: "text", value: name, maxlength: 80, "aria-label": words.name(mark), "data-testid": `name-${mark}` });
    named.addEventListener("change", () => runs.rename(run, named.value));
    const isOther = this.session.run === null || !run.hasBodyOf(this.session.run.model);
    const ticks = [
      ticked(`show-${mark}`, words.in_plots, run.isShown, !run.isShown && runs.shown.length >= MOST_SHOWN, (isOn) => runs.show(run, isOn)),
      ticked(`ghost-${mark}`, isOther ? words.ghost_other : words.ghost, runs.ghost === run && !isOther, isOther, (isOn) => runs.haunt(isOn ? run : null)),
      button(words.save, words.save_run(mark, name), `save-run-${mark}`, () => void fileOf(run).then((file) => download(file.name, file.content))),
      button(words.remove, words.remove_run(mark, name), `remove-run-${mark}`, () => runs.remove(run)),
    ];
    return make("li", {}, make("div", { class: "run-head" }, colour, named), make("p", { class: "muted" }, rowsOf(run)), make("div", { class: "run-acts" }, ...ticks));
  }
}

/** Says how many rows of a run are kept, and from when to when. */
function rowsOf(run: KeptRun): string {
  const [kept, recorded] = [run.rows.length, recordedOf(run)];
  const ends = [fixed(run.start_s, 2), fixed(run.end_s, 2)] as const;
  return kept < recorded ? words.thinned(kept, recorded, ...ends) : words.rows(kept, ...ends);
}

function ticked(testId: string, label: string, isOn: boolean, disabled: boolean, set: (isOn: boolean) => void): HTMLElement {
  const input = make("input", { type: "checkbox", checked: isOn, disabled, "data-testid": testId });
  input.addEventListener("change", () => set(input.checked));
  return make("label", { class: "menu-item" }, input, make("span", {}, label));
}

function button(text: string, title: string, testId: string, act: () => void): HTMLButtonElement {
  const made = make("button", { type: "button", class: "button", title, "aria-label": title, "data-testid": testId }, text);
  made.addEventListener("click", act);
  return made;
}
