import { fixed } from "../app/format";
import type { Session } from "../app/session";
import { asFault } from "../engine/engine";
import { isOfEngine } from "../engine/faults";
import { texts } from "../texts";
import { make } from "../ui/dom";
import { figureOf } from "./embed";
import type { Shown } from "./embed";
import { EmbedFields } from "./embed_fields";
import { hashOf } from "./link";
import { sharedRun } from "./making";
import type { SharedRun } from "./shared_run";

const words = texts.share;
/** Hosts of addresses that are valid on this machine only. */
const OWN_HOSTS = /^(localhost|127\.|\[::1\])/;

/** Dialog with a link to the present run: to send to another program, to copy, or as a QR code. */
export class ShareDialog {
  private readonly says = make("div", { class: "share-says" });
  private readonly field = make("textarea", { readonly: true, rows: 3, spellcheck: "false", "aria-label": words.link, "data-testid": "share-link" });
  private readonly copy = button(words.copy, "share-copy");
  private readonly send = button(words.send, "share-send");
  private readonly done = make("p", { role: "status", class: "share-done", "data-testid": "share-done" });
  private readonly qr = make("div", { class: "share-qr", "data-testid": "share-qr" });
  private readonly embed = new EmbedFields();
  private readonly dialog = this.made();

  constructor(
    private readonly session: Session,
    /** Returns the plot and viewpoint that are shown, for a figure of the run. */
    private readonly shown: () => Shown,
  ) {
    document.body.append(this.dialog);
    this.copy.addEventListener("click", () => void this.toClipboard());
    this.send.addEventListener("click", () => void this.toOthers());
    this.field.addEventListener("focus", () => this.field.select());
  }

  async open(): Promise<void> {
    this.say([words.making]);
    this.show("");
    this.dialog.showModal();
    try {
      const run = await sharedRun(this.session);
      if (!run) return this.dialog.close();
      const hash = await hashOf(run);
      this.say(this.wordsOf(run));
      this.show(location.origin + location.pathname + hash);
      this.embed.show(figureOf(run, this.session.run?.model.title ?? "", this.shown(), hash));
      await this.showQr();
    } catch (fault) {
      if (isOfEngine(fault)) this.dialog.close();
      this.say([asFault(fault).message]);
    }
  }

  private made(): HTMLDialogElement {
    const close = make("button", { type: "button", class: "button alert-close", "aria-label": words.close, "data-testid": "share-close" }, "×");
    const heading = make("h2", { id: "share-title" }, words.title);
    const head = make("div", { class: "share-head" }, heading, close);
    const buttons = make("div", { class: "share-buttons" }, this.copy, this.send);
    const dialog = make("dialog", { class: "share", "aria-labelledby": "share-title", "data-testid": "share-dialog" }, head, this.says, this.field, buttons, this.done, this.qr, this.embed.element);
    close.addEventListener("click", () => dialog.close());
    // Closes the dialog after a click outside it: the dialog has no padding, so a click on the element itself is on the
    // backdrop.
    dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());
    return dialog;
  }

  private wordsOf({ scenario, changes, moment }: SharedRun): string[] {
    const { run } = this.session;
    const waiting = this.session.pending();
    const holds = [words.holds(run?.model.title ?? ""), changes.length > 0 ? words.holds_changes(changes.length) : "", moment ? words.holds_moment(fixed(moment.time_s, 2)) : ""];
    return [
      holds.filter((text) => text !== "").join(" "),
      "text" in scenario ? words.holds_texts : "",
      waiting.length > 0 ? words.waiting(waiting.join(", ")) : "",
      OWN_HOSTS.test(location.hostname) ? words.this_machine : "",
    ].filter((text) => text !== "");
  }

  private say(lines: readonly string[]): void {
    this.says.replaceChildren(...lines.map((line) => make("p", {}, line)));
  }

  /** Shows the link; a page without a secure connection cannot use the clipboard or send the link to other programs. */
  private show(link: string): void {
    this.field.value = link;
    this.field.hidden = this.embed.element.hidden = link === "";
    this.copy.hidden = link === "" || !navigator.clipboard;
    this.send.hidden = link === "" || !navigator.canShare?.({ url: link });
    this.done.textContent = link !== "" && !navigator.clipboard ? words.copy_by_hand : "";
    this.qr.replaceChildren();
  }

  private async showQr(): Promise<void> {
    const link = this.field.value;
    const drawn = await import("./qr").then(
      ({ LONGEST_QR, qrCode }) => (link.length > LONGEST_QR ? words.qr_too_long(link.length, LONGEST_QR) : qrCode(link, words.qr)),
      () => words.qr_failed,
    );
    if (link === this.field.value) this.qr.replaceChildren(drawn);
  }

  private async toClipboard(): Promise<void> {
    const said = await navigator.clipboard.writeText(this.field.value).then(
      () => words.copied,
      () => words.copy_by_hand,
    );
    this.done.textContent = said;
  }

  private async toOthers(): Promise<void> {
    // Cancelling is not a failure.
    await navigator.share({ title: document.title, url: this.field.value }).catch(() => undefined);
  }
}

function button(label: string, testId: string): HTMLButtonElement {
  return make("button", { type: "button", class: "button", "data-testid": testId }, label);
}
