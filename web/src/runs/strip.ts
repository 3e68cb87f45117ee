import type { Session } from "../app/session";
import { byId, make, setText } from "../ui/dom";
import { COMPARISONS } from "./runs";
import type { Runs } from "./runs";
import type { KeptRun } from "./kept";
import { words } from "./words";

/** Kept runs above the plots: a button for each that shows or hides it, lines or differences, and the list. */
export class RunStrip {
  readonly element = make("div", { class: "runs-strip", role: "group", "aria-label": words.kept, hidden: true, "data-testid": "runs" });
  private readonly marks = make("div", { class: "runs-marks" });
  private readonly comparisons: HTMLButtonElement[];
  private readonly said = make("p", { class: "visually-hidden", role: "status", "data-testid": "runs-said" });
  private opening: Promise<{ open(): void }> | null = null;

  constructor(
    private readonly runs: Runs,
    private readonly session: Session,
  ) {
    this.comparisons = COMPARISONS.map((name) => {
      const button = make("button", { type: "button", title: words.comparisons_help, "data-testid": `compare-${name}` }, words.comparisons[name]);
      button.addEventListener("click", () => runs.compare(name));
      return button;
    });
    const manage = make("button", { type: "button", class: "button button-quiet", "aria-haspopup": "dialog", "data-testid": "manage-runs" }, words.manage);
    manage.addEventListener("click", () => void this.openList());
    const compare = make("div", { class: "segmented", role: "group", "aria-label": words.compare }, ...this.comparisons);
    this.element.append(this.marks, compare, manage);
    byId("app").append(this.said);
    runs.onChange(() => this.show());
    this.show();
  }

  private async openList(): Promise<void> {
    this.opening ??= import("./list").then(({ RunList }) => new RunList(this.runs, this.session));
    (await this.opening).open();
  }

  private show(): void {
    const { all, comparison, said } = this.runs;
    this.element.hidden = all.length === 0;
    setText(this.said, said);
    const focused = this.marks.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset.testid : undefined;
    this.marks.replaceChildren(...all.map((run) => this.chip(run)));
    this.comparisons.forEach((button, i) => button.setAttribute("aria-pressed", String(COMPARISONS[i] === comparison)));
    if (focused) this.marks.querySelector<HTMLElement>(`[data-testid="${focused}"]`)?.focus();
  }

  private chip(run: KeptRun): HTMLElement {
    const { mark, name, colour, isShown } = run;
    const swatch = make("span", { class: "run-swatch", style: `border-color: var(--${colour})`, "aria-hidden": "true" });
    const title = words.show(mark, name);
    const chip = make("button", { type: "button", class: "run-chip", title, "aria-label": title, "aria-pressed": isShown, "data-testid": `run-${mark}` }, swatch, make("b", {}, mark), make("span", { class: "run-chip-name" }, name));
    chip.setAttribute("aria-pressed", String(isShown));
    chip.addEventListener("click", () => this.runs.show(run, !isShown));
    return chip;
  }
}
