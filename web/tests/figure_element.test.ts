import { afterAll, beforeAll, beforeEach, describe, expect, it, vi } from "vitest";
import type { KingpostFigureElement } from "../figure/kingpost-figure";
import { figureBy } from "../src/figure/address";
import { sent } from "../src/figure/protocol";
import type { FromFigure } from "../src/figure/protocol";
import { FakeElement, fakePage } from "./fake_dom";

const APP = "https://ships.example/app/";

let page: ReturnType<typeof fakePage>;
let Figure: new () => KingpostFigureElement;

beforeAll(async () => {
  vi.useFakeTimers();
  page = fakePage("https://journal.example/1.html");
  Figure = (await import("../figure/src/kingpost-figure")).KingpostFigure;
});
afterAll(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

/** A figure in a page, with what a test reads of it. */
function figureOf(attributes: Record<string, string>) {
  const figure = new Figure() as KingpostFigureElement & { connectedCallback(): void; disconnectedCallback(): void };
  const element = figure as unknown as FakeElement;
  for (const [name, value] of Object.entries({ src: APP, ...attributes })) element.setAttribute(name, value);
  figure.connectedCallback();
  const events: { type: string; detail: unknown }[] = [];
  for (const type of ["kingpost-ready", "kingpost-time", "kingpost-changed", "kingpost-error"]) {
    element.addEventListener(type, (event) => events.push({ type, detail: (event as CustomEvent).detail }));
  }
  const frame = () => element.all("iframe")[0];
  const say = (message: FromFigure) => page.hear({ data: sent(message), origin: "https://ships.example", source: frame().contentWindow });
  const greet = () => {
    frame().dispatchEvent(new Event("load"));
    say({ kind: "here" });
  };
  const kinds = () => frame().posted.map(({ message }) => (message as { kind: string }).kind);
  return { figure, element, events, frame, say, greet, kinds };
}

const ready: FromFigure = { kind: "ready", title: "A ship", duration_s: 3, columns: ["time", "ship.roll"], settable: [] };

describe("the element", () => {
  let one: ReturnType<typeof figureOf>;
  beforeEach(() => (one = figureOf({ scenario: "paper", set: "load=true", caption: "A ship." })));

  it("is a still with a button and a caption until something is asked", () => {
    const { element, figure } = one;
    expect(element.all("iframe")).toEqual([]);
    expect(element.all("img")[0].getAttribute("src")).toBe(`${APP}cards/paper.webp`);
    expect(element.all("button")[0].getAttribute("aria-label")).toBe("Start the figure: A ship.");
    expect(element.all("figcaption")[0].textContent).toBe("A ship.");
    expect([figure.paused, figure.time, figure.row, figure.camera]).toEqual([true, 0, {}, "free"]);
    figure.pause();
    expect(element.all("iframe")).toEqual([]);
  });

  it("opens the figure page at a touch and plays when it has answered", () => {
    const { element, frame, greet, kinds, say } = one;
    element.all("button")[0].onclick!();
    expect(figureBy(new URL(frame().getAttribute("src")!).search)).toMatchObject({ scenario: "paper", set: { load: true }, isAwake: true });
    expect(kinds()).toEqual([]);
    greet();
    expect(kinds()).toEqual(["hello", "play"]);
    expect(element.all("button")[0].hidden).toBe(false);
    say(ready);
    expect(element.all("button")[0].hidden).toBe(true);
  });

  it("keeps what a script asks, in order, until the figure has answered", () => {
    const { figure, greet, kinds } = one;
    figure.set("crane_x_m", 3);
    figure.camera = "top";
    figure.time = 2;
    figure.play();
    greet();
    expect(kinds()).toEqual(["hello", "set", "camera", "time", "play"]);
    expect(figure.camera).toBe("top");
  });

  it("reports moments, values and faults as events, and has the row by column name", () => {
    const { events, figure, greet, say } = one;
    figure.time = 1;
    greet();
    say(ready);
    say({ kind: "state", time_s: 1, isPlaying: true, row: Float64Array.of(1, 0.25) });
    say({ kind: "changed", name: "load", value: false });
    say({ kind: "error", code: "name", message: "no such name" });
    expect(events.map(({ type }) => type)).toEqual(["kingpost-ready", "kingpost-time", "kingpost-changed", "kingpost-error"]);
    expect(events.map(({ detail }) => detail)).toMatchObject([{ title: "A ship", duration_s: 3 }, { time_s: 1, isPlaying: true }, { name: "load", value: false }, { code: "name" }]);
    expect([figure.time, figure.paused, figure.row]).toEqual([1, false, { time: 1, "ship.roll": 0.25 }]);
  });

  it("hears neither another window nor another origin", () => {
    const { events, figure, frame, greet } = one;
    figure.play();
    greet();
    page.hear({ data: sent(ready), origin: "https://evil.example", source: frame().contentWindow });
    page.hear({ data: sent(ready), origin: "https://ships.example", source: {} });
    page.hear({ data: { kingpost: 99, kind: "ready" }, origin: "https://ships.example", source: frame().contentWindow });
    expect(events).toEqual([]);
  });

  it("shows why a figure cannot be opened, and tries again at the next touch", () => {
    const { element, events, figure, greet, say } = one;
    figure.play();
    greet();
    say({ kind: "error", code: "open", message: "no such scenario" });
    expect(element.all("iframe")).toEqual([]);
    expect(element.all("div").map(({ textContent }) => textContent)).toContain("The figure could not be opened: no such scenario");
    expect(events.at(-1)).toEqual({ type: "kingpost-error", detail: { code: "open", message: "no such scenario" } });
    element.all("button")[0].onclick!();
    expect(element.all("iframe")).toHaveLength(1);
  });

  it("reports a frame that loads and never answers", () => {
    const { events, figure, frame } = one;
    figure.play();
    frame().dispatchEvent(new Event("load"));
    vi.runAllTimers();
    expect(events).toMatchObject([{ type: "kingpost-error", detail: { code: "silent" } }]);
  });

  it("sets changed values and the camera in the figure, and opens another scenario in a new frame", () => {
    const { element, figure, frame, greet, kinds } = one;
    figure.time = 0;
    greet();
    element.setAttribute("set", "load=true; crane_x_m=3");
    element.setAttribute("camera", "load");
    expect(kinds()).toEqual(["hello", "time", "set", "camera"]);
    const before = frame();
    element.setAttribute("scenario", "chain");
    expect(frame()).not.toBe(before);
    expect(figureBy(new URL(frame().getAttribute("src")!).search).scenario).toBe("chain");
  });

  it("wakes when it is scrolled to only if the author asks for it", () => {
    page.see({ intersectionRatio: 1, isIntersecting: true });
    expect(one.element.all("iframe")).toEqual([]);
    const eager = figureOf({ scenario: "paper", wake: "scroll" });
    page.see({ intersectionRatio: 0.2, isIntersecting: true });
    expect(eager.element.all("iframe")).toEqual([]);
    page.see({ intersectionRatio: 0.6, isIntersecting: true });
    expect(eager.element.all("iframe")).toHaveLength(1);
    eager.greet();
    expect(eager.kinds()).toEqual(["hello"]);
  });

  it("pauses a run that leaves the view", () => {
    const { figure, greet, kinds, say } = one;
    figure.play();
    greet();
    say({ kind: "state", time_s: 0.1, isPlaying: true, row: new Float64Array() });
    page.see({ intersectionRatio: 0, isIntersecting: false });
    expect(kinds()).toEqual(["hello", "play", "pause"]);
  });

  it("follows the height that the figure reports", () => {
    const { element, figure, greet, say } = one;
    figure.play();
    greet();
    say({ kind: "height", height_px: 512 });
    expect(element.all("div").map(({ style }) => style.cssText)).toContain("height: 512px; aspect-ratio: auto");
  });

  it("reports a missing address of the app", () => {
    const { element, events, figure } = one;
    element.attributes.delete("src");
    figure.play();
    expect(element.all("iframe")).toEqual([]);
    expect(events).toMatchObject([{ detail: { code: "address" } }]);
  });

  it("stops hearing when it leaves the page", () => {
    const before = page.heard.size;
    one.figure.disconnectedCallback();
    expect(page.heard.size).toBe(before - 1);
  });
});
