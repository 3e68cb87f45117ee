import { texts } from "../texts";
import { make } from "../ui/dom";
import { elementFor, frameFor } from "./embed";
import type { Embedded } from "./embed";

const words = texts.share;
/** Kinds of HTML code. */
const KINDS = { element: elementFor, frame: frameFor } as const;
type Kind = keyof typeof KINDS;

/** Part of the dialog with the HTML code that shows the present run as a figure in another page. */
export class EmbedFields {
  private readonly field = make("textarea", { readonly: true, rows: 6, spellcheck: "false", "aria-label": words.embed_code, "data-testid": "embed-code" });
  private readonly copy = make("button", { type: "button", class: "button", "data-testid": "embed-copy" }, words.embed_copy);
  private readonly done = make("p", { role: "status", class: "share-done" });
  readonly element = this.made();
  private kind: Kind = "element";
  private figure: Embedded | null = null;

  /** Shows the code for a figure. */
  show(figure: Embedded): void {
    this.figure = figure;
    this.done.textContent = "";
    this.write();
  }

  private made(): HTMLElement {
    const kinds = make("fieldset", { class: "share-kinds" }, make("legend", { class: "visually-hidden" }, words.embed_code), this.choice("element", words.embed_element), this.choice("frame", words.embed_frame));
    this.field.addEventListener("focus", () => this.field.select());
    this.copy.hidden = !navigator.clipboard;
    this.copy.addEventListener("click", () => void this.toClipboard());
    const body = make("div", { class: "share-embed" }, make("p", {}, words.embed_help), kinds, this.field, this.copy, this.done);
    return make("details", { class: "fold", "data-testid": "embed" }, make("summary", {}, words.embed), body);
  }

  private choice(kind: Kind, label: string): HTMLElement {
    const input = make("input", { type: "radio", name: "embed-kind", value: kind, checked: kind === "element", "data-testid": `embed-${kind}` });
    input.addEventListener("change", () => {
      this.kind = kind;
      this.write();
    });
    return make("label", { class: "menu-item" }, input, make("span", {}, label));
  }

  private write(): void {
    if (this.figure) this.field.value = KINDS[this.kind](this.figure, new URL("./", location.href.split(/[?#]/)[0]).href);
  }

  private async toClipboard(): Promise<void> {
    this.done.textContent = await navigator.clipboard.writeText(this.field.value).then(
      () => words.copied,
      () => words.copy_by_hand,
    );
  }
}
