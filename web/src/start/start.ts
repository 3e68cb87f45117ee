import type { Gallery, Group } from "../app/gallery";
import { OPENING } from "../app/opening";
import { language, texts } from "../texts";
import { byId, make } from "../ui/dom";
import { languageChoice } from "../ui/language";
import { addressOf, cardOf } from "./card";

const { start } = texts;

/** The start page: a description of Kingpost, and the gallery as cards. */
export class StartPage {
  private readonly page = byId("start-page");
  private readonly alert = make("p", { class: "start-alert", role: "alert", "data-testid": "start-alert" });
  private readonly groups = make("div", { class: "start-groups" }, make("p", { class: "muted" }, start.loading));

  /** `open` receives the address of the chosen scenario, and whether its run starts; `prepare` is called when the user is likely to choose one. */
  constructor(
    private readonly open: (query: string, starts: boolean) => void,
    private readonly prepare: () => void,
  ) {
    this.page.append(this.hero(), make("main", { class: "start-main" }, this.alert, make("h2", { class: "visually-hidden" }, start.choose), this.groups));
    this.page.append(make("footer", { class: "start-foot" }, make("p", {}, start.about)));
    this.page.addEventListener("click", (event) => this.follow(event));
    for (const sign of ["pointerover", "focusin", "touchstart"]) this.page.addEventListener(sign, (event) => this.notice(event), { passive: true });
  }

  private hero(): HTMLElement {
    const paper = make("a", { class: "button button-primary", href: addressOf(OPENING.scenario!), "data-testid": "open-paper", "data-starts": true }, start.open_paper);
    const file = make("button", { type: "button", class: "button", "data-opens-file": true }, start.open_file);
    const words = make(
      "div",
      { class: "hero-words" },
      make("h1", {}, texts.page.name),
      make("p", { class: "hero-lead" }, start.lead),
      make("p", {}, start.intro),
      make("div", { class: "hero-actions" }, paper, file),
    );
    const picture = make("img", { class: "hero-picture", loading: "lazy", src: "./cards/hero.webp", alt: "", width: 1600, height: 700 });
    return make("header", { class: "hero" }, picture, words, languageChoice("language"));
  }

  /** Shows the cards, which need the list of the gallery but not the engine. */
  offer(gallery: Gallery): void {
    this.groups.replaceChildren(...gallery.groups.map((group, k) => section(group, k)));
  }

  /** Shows that the list of the gallery could not be loaded; files can still be opened. */
  lack(why: string): void {
    this.groups.replaceChildren();
    this.say(start.failed(why));
  }

  say(text: string): void {
    this.alert.textContent = text;
  }

  set isShown(isShown: boolean) {
    this.page.hidden = !isShown;
    if (isShown) document.title = start.page_title;
  }

  /** Opens a link of this page within the document; with a modifier key the browser handles it. */
  private follow(event: MouseEvent): void {
    const link = linkOf(event);
    if (!link || event.button !== 0 || event.metaKey || event.ctrlKey || event.shiftKey || event.altKey) return;
    event.preventDefault();
    this.open(link.getAttribute("href")!, "starts" in link.dataset);
  }

  private notice(event: Event): void {
    if (linkOf(event)) this.prepare();
  }
}

function section({ title, entries }: Group, k: number): HTMLElement {
  const id = `group-${k}`;
  const heading = make("h2", { id, lang: title ? "en" : language }, title ?? start.ungrouped);
  return make("section", { class: "start-group", "aria-labelledby": id }, heading, make("div", { class: "cards" }, ...entries.map(cardOf)));
}

function linkOf(event: Event): HTMLAnchorElement | null {
  return event.target instanceof Element ? event.target.closest<HTMLAnchorElement>("a[href^='?']") : null;
}
