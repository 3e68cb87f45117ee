import "./figure.css";
import { enablePalettes } from "../app/palette";
import { languageHere } from "../texts/language";
import { byId } from "../ui/dom";
import { figureBy, isFileAddress } from "./address";
import type { FigureChoice } from "./address";
import { reportHeight } from "./height";
import type { Live } from "./live";
import { Port } from "./port";
import type { ToFigure } from "./protocol";
import { words } from "./words";

/** The figure page: a still until it is touched, or until the page around it asks for something. */
class FigurePage {
  private readonly port = new Port(window, (message) => this.take(message));
  private readonly start = byId("wake", HTMLButtonElement);
  private live: Promise<Live> | null = null;

  constructor(private readonly choice: FigureChoice) {
    document.documentElement.lang = languageHere();
    byId("scene").setAttribute("aria-label", words.label);
    byId("controls").setAttribute("aria-label", words.controls);
    byId("caption").textContent = choice.caption;
    byId("caption").hidden = choice.caption === "";
    document.title = choice.caption || choice.scenario || document.title;
    byId("title").textContent = document.title;
    this.start.setAttribute("aria-label", words.start);
    this.start.addEventListener("click", () => this.take({ kind: "play" }));
    byId("still").addEventListener("click", () => this.take({ kind: "play" }));
    reportHeight((height_px) => this.port.tell({ kind: "height", height_px }));
    if (choice.isAwake) this.wake();
    else this.showStill();
  }

  private showStill(): void {
    const { scenario, still } = this.choice;
    const address = still || (scenario && !isFileAddress(scenario) ? `./cards/${encodeURIComponent(scenario)}.webp` : "");
    if (address === "") return;
    byId("still").setAttribute("src", address);
    byId("still").hidden = false;
  }

  /** Wakes the figure, and hands a message to it when it can be played. */
  private take(message: ToFigure): void {
    const { live } = this;
    if (message.kind === "pause" && !live) return;
    void this.wake().then((figure) => figure.take(message), () => undefined);
  }

  private wake(): Promise<Live> {
    this.live ??= this.brought();
    return this.live;
  }

  private async brought(): Promise<Live> {
    this.start.hidden = true;
    byId("scene").setAttribute("aria-busy", "true");
    byId("scene-message").textContent = words.loading;
    byId("scene-message").hidden = false;
    byId("canvas").hidden = false;
    try {
      const { bringToLife } = await import("./live");
      const live = await bringToLife(this.choice, location.hash, (message) => this.port.tell(message));
      byId("scene-message").hidden = true;
      byId("bar").hidden = false;
      byId("still").hidden = true;
      return live;
    } catch (thrown) {
      this.fail(thrown);
      throw thrown;
    } finally {
      byId("scene").removeAttribute("aria-busy");
    }
  }

  /** Shows why the figure could not be opened; the next touch tries again. */
  private fail(thrown: unknown): void {
    const why = typeof thrown === "object" && thrown !== null && "message" in thrown ? String(thrown.message) : String(thrown);
    this.live = null;
    this.start.hidden = false;
    byId("scene-message").hidden = true;
    byId("alert").textContent = words.failed(why);
    this.port.tell({ kind: "error", code: "open", message: why });
  }
}

enablePalettes();
new FigurePage(figureBy(location.search));
