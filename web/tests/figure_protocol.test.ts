import { describe, expect, it } from "vitest";
import { Link } from "../figure/src/link";
import { Port } from "../src/figure/port";
import type { Framed } from "../src/figure/port";
import { fromFigureOf, isClaimed, sent, toFigureOf, VERSION } from "../src/figure/protocol";
import type { FromFigure, ToFigure } from "../src/figure/protocol";

const TO: ToFigure[] = [
  { kind: "hello" },
  { kind: "wake" },
  { kind: "set", name: "load", value: true },
  { kind: "set", name: "history", value: "pulse" },
  { kind: "time", time_s: 0 },
  { kind: "camera", camera: "top" },
  { kind: "play" },
  { kind: "pause" },
];
const FROM: FromFigure[] = [
  { kind: "here" },
  { kind: "ready", title: "A ship", duration_s: 3, columns: ["time"], settable: [{ name: "load", label: "Load", unit: "", value: true, range: null, choices: null }] },
  { kind: "state", time_s: 1, isPlaying: true, row: Float64Array.of(1, NaN, -0) },
  { kind: "changed", name: "load", value: false },
  { kind: "height", height_px: 400 },
  { kind: "error", code: "name", message: "no" },
];
/** Values that are no message, whatever their fields. */
const NONSENSE: unknown[] = [undefined, null, 0, "play", [], {}, { kind: "play" }, { kingpost: 2, kind: "play" }, { kingpost: VERSION }, { kingpost: VERSION, kind: "fly" }, { kingpost: VERSION, kind: 3 }];
const WRONG_TO = [
  { kind: "set", name: "", value: 1 },
  { kind: "set", name: "load" },
  { kind: "set", name: "load", value: NaN },
  { kind: "set", name: "load", value: { valueOf: 1 } },
  { kind: "set", name: "x".repeat(20_000), value: 1 },
  { kind: "time", time_s: -1 },
  { kind: "time", time_s: Infinity },
  { kind: "time", time_s: "1" },
  { kind: "camera", camera: 3 },
];
const WRONG_FROM = [
  { kind: "ready", title: "A ship", duration_s: 3, columns: [1], settable: [] },
  { kind: "ready", title: "A ship", duration_s: 3, columns: [], settable: [{ name: "load" }] },
  { kind: "ready", title: "A ship", duration_s: "3", columns: [], settable: [] },
  { kind: "state", time_s: 1, isPlaying: true, row: [1, 2] },
  { kind: "state", time_s: NaN, isPlaying: true, row: new Float64Array() },
  { kind: "changed", name: "load", value: null },
  { kind: "height", height_px: 0 },
  { kind: "error", code: 1, message: "no" },
];

describe("messages of figures", () => {
  it("reads every message that it writes", () => {
    for (const message of TO) expect(toFigureOf(sent(message))).toEqual(message);
    for (const message of FROM) expect(fromFigureOf(sent(message))).toEqual(message);
  });

  it("refuses values of other forms and versions without an exception", () => {
    for (const data of NONSENSE) expect([toFigureOf(data), fromFigureOf(data)]).toEqual([null, null]);
    for (const message of WRONG_TO) expect(toFigureOf({ ...message, kingpost: VERSION }), JSON.stringify(message)).toBeNull();
    for (const message of WRONG_FROM) expect(fromFigureOf({ ...message, kingpost: VERSION }), JSON.stringify(message)).toBeNull();
  });

  it("drops fields that a message does not have", () => {
    expect(toFigureOf({ kingpost: VERSION, kind: "play", extra: 1 })).toEqual({ kind: "play" });
  });

  it("recognises messages of another version as its own", () => {
    expect([isClaimed({ kingpost: 99 }), isClaimed({}), isClaimed(null)]).toEqual([true, false, false]);
  });
});

/** A window in a frame, with what its parent receives. */
function framed() {
  const got: { message: unknown; origin: string }[] = [];
  let hear: (event: { data: unknown; origin: string; source: unknown }) => void = () => undefined;
  const parent = { postMessage: (message: unknown, origin: string) => void got.push({ message, origin }) };
  const scope: Framed = { parent, addEventListener: (_type, listener) => (hear = listener as typeof hear) };
  const taken: ToFigure[] = [];
  const port = new Port(scope, (message) => taken.push(message));
  return { port, taken, got, parent, hear: (message: unknown, origin = "https://journal.example", source: unknown = parent) => hear({ data: message, origin, source }) };
}

describe("the figure's end", () => {
  it("answers a greeting at its origin, and sends what has waited", () => {
    const { port, got, hear } = framed();
    port.tell({ kind: "height", height_px: 300 });
    expect(got).toEqual([]);
    hear(sent({ kind: "hello" }));
    expect(got).toEqual([sent({ kind: "here" }), sent({ kind: "height", height_px: 300 })].map((message) => ({ message, origin: "https://journal.example" })));
  });

  it("takes no message before a greeting, from another window or from another origin", () => {
    const { taken, hear } = framed();
    hear(sent({ kind: "play" }));
    hear(sent({ kind: "hello" }), "https://journal.example", {});
    hear(sent({ kind: "play" }));
    expect(taken).toEqual([]);
    hear(sent({ kind: "hello" }));
    hear(sent({ kind: "play" }), "https://evil.example");
    hear(sent({ kind: "play" }), "https://journal.example", {});
    expect(taken).toEqual([]);
    hear(sent({ kind: "play" }));
    expect(taken).toEqual([{ kind: "play" }]);
  });

  it("answers a message of its own that it cannot read with an error, and others with nothing", () => {
    const { taken, got, hear } = framed();
    hear(sent({ kind: "hello" }));
    hear({ other: "library" });
    hear("text");
    expect(got).toHaveLength(1);
    hear({ kingpost: 99, kind: "play" });
    expect(got.at(-1)!.message).toMatchObject({ kind: "error", code: "message" });
    expect(taken).toEqual([]);
  });

  it("answers a page without an origin, as a file has none", () => {
    const { got, hear } = framed();
    hear(sent({ kind: "hello" }), "null");
    expect(got).toEqual([{ message: sent({ kind: "here" }), origin: "*" }]);
  });

  it("hears nothing on a page that is in no frame", () => {
    const taken: ToFigure[] = [];
    let hear: (event: Pick<MessageEvent, "data" | "origin" | "source">) => void = () => undefined;
    const scope = { postMessage: () => undefined, addEventListener: (_type: "message", listener: typeof hear) => void (hear = listener) } as unknown as Framed;
    scope.parent = scope as unknown as Framed["parent"];
    new Port(scope, (message) => taken.push(message));
    hear({ data: sent({ kind: "hello" }), origin: "https://a.example", source: scope as unknown as Window });
    hear({ data: sent({ kind: "play" }), origin: "https://a.example", source: scope as unknown as Window });
    expect(taken).toEqual([]);
  });
});

describe("the page's end", () => {
  function linked() {
    const posted: { message: unknown; origin: string }[] = [];
    const figure = { postMessage: (message: unknown, origin: string) => void posted.push({ message, origin }) };
    const taken: FromFigure[] = [];
    const link = new Link(() => figure, "https://ships.example", (message) => taken.push(message));
    const hear = (message: unknown, origin = "https://ships.example", source: unknown = figure) => link.hear({ data: message, origin, source: source as Window });
    return { link, posted, taken, hear };
  }

  it("keeps messages in order until the figure has answered, and sends them to the app's origin only", () => {
    const { link, posted, hear } = linked();
    link.send({ kind: "time", time_s: 2 });
    link.send({ kind: "play" });
    link.greet();
    expect(posted).toEqual([{ message: sent({ kind: "hello" }), origin: "https://ships.example" }]);
    hear(sent({ kind: "here" }));
    expect(link.hasAnswered).toBe(true);
    expect(posted.slice(1).map(({ message }) => message)).toEqual([sent({ kind: "time", time_s: 2 }), sent({ kind: "play" })]);
  });

  it("takes no message from another origin, another window or of another form", () => {
    const { taken, hear } = linked();
    const state = sent({ kind: "changed", name: "load", value: 1 });
    hear(state, "https://evil.example");
    hear(state, "https://ships.example", {});
    for (const data of NONSENSE) hear(data);
    expect(taken).toEqual([]);
    hear(state);
    expect(taken).toEqual([{ kind: "changed", name: "load", value: 1 }]);
  });
});
