import { namesIn, valuesIn } from "../../src/figure/address";
import type { FromFigure, ToFigure } from "../../src/figure/protocol";
import { words } from "../../src/figure/words";
import type { FigureValue, KingpostFigureElement, ReadyDetail } from "../kingpost-figure";
import { appOf, pageOf, stillOf } from "./addresses";
import { Link } from "./link";
import { frameOf, partsIn } from "./parts";
import type { Parts } from "./parts";

/** Address of this script, if a page has loaded it by itself: the app's folder is beside it. */
const SCRIPT = (globalThis.document?.currentScript as HTMLScriptElement | null | undefined)?.src ?? null;
/** Time after which a frame that has loaded and says nothing is reported, ms: its server refuses frames. */
const PATIENCE_MS = 20_000;
/** Share of a figure in view at which `wake="scroll"` wakes it. */
const IN_VIEW = 0.5;
/** Attributes that need another page in the frame. */
const OF_PAGE = ["scenario", "src", "controls", "plot", "run"];

// A page that is made on a server imports the package without a browser.
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

/** The element `<kingpost-figure>`. */
export class KingpostFigure extends Base implements KingpostFigureElement {
  static readonly observedAttributes = [...OF_PAGE, "set", "camera", "caption", "poster"];
  private readonly parts: Parts = partsIn(this.attachShadow({ mode: "open" }), words.start);
  private frame: HTMLIFrameElement | null = null;
  private link: Link | null = null;
  private columns: readonly string[] = [];
  private state = { time_s: 0, isPlaying: false, values: new Float64Array() as Float64Array };
  private view: string | null = null;
  private observer: IntersectionObserver | null = null;
  private readonly hear = (event: MessageEvent) => this.link?.hear(event);

  connectedCallback(): void {
    const { parts } = this;
    parts.start.onclick = parts.slot.onclick = () => this.play();
    addEventListener("message", this.hear);
    this.showStill();
    this.observer = new IntersectionObserver(([{ intersectionRatio, isIntersecting }]) => {
      if (intersectionRatio >= IN_VIEW && this.getAttribute("wake") === "scroll") this.wake();
      if (!isIntersecting && this.state.isPlaying) this.pause();
    }, { threshold: [0, IN_VIEW] });
    this.observer.observe(this);
  }

  disconnectedCallback(): void {
    removeEventListener("message", this.hear);
    this.observer?.disconnect();
    this.sleep();
  }

  attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    if (before === value) return;
    if (name === "caption" || name === "poster" || !this.link) this.showStill();
    else if (name === "camera") this.camera = value ?? "free";
    else if (name === "set") this.setChanged(before, value);
    else this.renew();
  }

  set(name: string, value: FigureValue): void {
    this.send({ kind: "set", name, value });
  }

  play(): void {
    this.send({ kind: "play" });
  }

  pause(): void {
    if (this.link) this.send({ kind: "pause" });
  }

  get time(): number {
    return this.state.time_s;
  }

  set time(time_s: number) {
    this.send({ kind: "time", time_s: Number(time_s) });
  }

  get camera(): string {
    return this.view ?? this.getAttribute("camera") ?? "free";
  }

  set camera(camera: string) {
    this.view = camera;
    this.send({ kind: "camera", camera });
  }

  get paused(): boolean {
    return !this.state.isPlaying;
  }

  get row(): Readonly<Record<string, number>> {
    const { values } = this.state;
    return Object.fromEntries(this.columns.slice(0, values.length).map((name, at) => [name, values[at]]));
  }

  private send(message: ToFigure): void {
    this.wake();
    this.link?.send(message);
  }

  private get app(): string | null {
    return appOf(this.getAttribute("src"), SCRIPT, document.baseURI);
  }

  /** Loads the figure's page, once. */
  private wake(): void {
    const { app, parts } = this;
    if (this.frame) return;
    if (app === null) return this.fail("address", words.no_address);
    const attribute = (name: string) => this.getAttribute(name);
    const frame = frameOf(pageOf(attribute, app, document.baseURI), this.getAttribute("caption") || words.label);
    this.frame = frame;
    this.link = new Link(() => frame.contentWindow, new URL(app).origin, (message) => this.take(message));
    frame.addEventListener("load", () => this.greet(frame, app));
    parts.start.setAttribute("aria-busy", "true");
    parts.alert.textContent = "";
    // Under the still, until the figure can be played.
    parts.picture.prepend(frame);
  }

  private greet(frame: HTMLIFrameElement, app: string): void {
    const { link } = this;
    link?.greet();
    setTimeout(() => {
      if (link && frame === this.frame && !link.hasAnswered) this.fail("silent", words.not_there(app));
    }, PATIENCE_MS);
  }

  private take(message: FromFigure): void {
    const { kind } = message;
    if (kind === "ready") this.begin(message);
    else if (kind === "height") this.parts.picture.style.cssText = `height: ${message.height_px}px; aspect-ratio: auto`;
    else if (kind === "state") this.show(message.time_s, message.isPlaying, message.row);
    else if (kind === "changed") this.tell("kingpost-changed", { name: message.name, value: message.value });
    else if (kind === "error") this.fail(message.code, message.message);
  }

  private begin({ title, duration_s, columns, settable }: ReadyDetail): void {
    const { parts } = this;
    this.columns = columns;
    parts.alert.textContent = "";
    parts.slot.hidden = parts.start.hidden = true;
    // The focus goes from the button into the figure.
    if (this.shadowRoot?.activeElement === parts.start || this.matches(":focus-within")) this.frame?.focus();
    this.tell("kingpost-ready", { title, duration_s, columns, settable });
  }

  private show(time_s: number, isPlaying: boolean, values: Float64Array): void {
    this.state = { time_s, isPlaying, values };
    this.tell("kingpost-time", { time_s, isPlaying });
  }

  /** Reports a fault; if the figure could not be opened, the still stays, and the next touch tries again. */
  private fail(code: string, message: string): void {
    // A frame that is silent may only be slow: it stays, and clears the message when it answers.
    if (code === "open" || code === "address") this.sleep();
    if (code === "open" || code === "address" || code === "silent") this.parts.alert.textContent = words.failed(message);
    this.tell("kingpost-error", { code, message });
  }

  private sleep(): void {
    const { parts } = this;
    this.frame?.remove();
    [this.frame, this.link, this.view] = [null, null, null];
    this.state = { time_s: 0, isPlaying: false, values: new Float64Array() };
    parts.slot.hidden = parts.start.hidden = false;
    parts.start.removeAttribute("aria-busy");
    parts.picture.style.cssText = "";
  }

  /** Loads the page again, for other attributes. */
  private renew(): void {
    this.sleep();
    this.showStill();
    this.wake();
  }

  private setChanged(before: string | null, value: string | null): void {
    const [old, now] = [before, value].map((text) => valuesIn(text ?? ""));
    if (namesIn(Object.keys(old).join()).some((name) => !(name in now))) return this.renew();
    for (const [name, one] of Object.entries(now)) if (old[name] !== one) this.set(name, one);
  }

  private showStill(): void {
    const { caption, start, still } = this.parts;
    const text = this.getAttribute("caption") ?? "";
    const address = this.app === null ? "" : stillOf((name) => this.getAttribute(name), this.app, document.baseURI);
    caption.textContent = text;
    caption.hidden = text === "";
    start.setAttribute("aria-label", text === "" ? words.start : `${words.start}: ${text}`);
    still.hidden = address === "";
    if (address !== "" && still.getAttribute("src") !== address) still.setAttribute("src", address);
  }

  private tell(name: string, detail: object): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

if (globalThis.customElements && !customElements.get("kingpost-figure")) customElements.define("kingpost-figure", KingpostFigure);
