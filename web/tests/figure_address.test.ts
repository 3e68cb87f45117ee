import { describe, expect, it } from "vitest";
import { appOf, pageOf, stillOf } from "../figure/src/addresses";
import { figurePageFor } from "../src/app/address";
import { figureBy, isFileAddress, namesIn, queryOfFigure, textOfValues, valuesIn } from "../src/figure/address";
import { elementFor, figureOf, frameFor } from "../src/share/embed";
import { textOfPlace, viewpointOf } from "../src/view/viewpoint";

const APP = "https://ships.example/app/";
const ARTICLE = "https://journal.example/paper/1.html";

const choice = {
  scenario: "paper",
  set: { load: true, crane_x_m: -2.5, torque_history: "pulse" },
  controls: ["load", "crane_x_m"],
  plot: ["ship.roll", "a.force_x+a.force_y"],
  camera: "-60 -90 50 0 0 5",
  caption: "A ship & her crane; “slow”, 100 %",
  still: "./still.webp",
  isAwake: true,
};

describe("addresses of figures", () => {
  it("reads back every choice that an address holds", () => {
    expect(figureBy(queryOfFigure(choice))).toEqual(choice);
    const nothing = figureBy("");
    expect(nothing).toEqual({ scenario: null, set: {}, controls: [], plot: [], camera: "", caption: "", still: "", isAwake: false });
    expect(queryOfFigure(nothing)).toBe("?");
  });

  it("reads values with semicolons between them, and leaves out parts without a name", () => {
    expect(valuesIn(" load = true; crane_x_m=-2.5 ;simulation.integrator=rk4; ;=3;name")).toEqual({ load: true, crane_x_m: -2.5, "simulation.integrator": "rk4" });
    expect(valuesIn(textOfValues(choice.set))).toEqual(choice.set);
    expect(namesIn(" load,, crane_x_m ")).toEqual(["load", "crane_x_m"]);
  });

  it("joins the values of several set parameters", () => {
    expect(figureBy("?scenario=paper&set=load%3Dtrue&set=crane_x_m%3D3").set).toEqual({ load: true, crane_x_m: 3 });
  });

  it("leads from the app's page to the figure page only with the mark", () => {
    expect(figurePageFor({ search: "?figure&scenario=paper", hash: "#k1=abc" })).toBe("figure.html?scenario=paper#k1=abc");
    expect(figurePageFor({ search: "?scenario=paper", hash: "" })).toBeNull();
  });

  it("tells the address of a file from the name of a scenario", () => {
    expect(["lift.yaml", "../lift.yml?v=2", "https://a.example/x.json"].map(isFileAddress)).toEqual([true, true, true]);
    expect(["paper", "yaml", "lift.yaml.txt"].map(isFileAddress)).toEqual([false, false, false]);
  });
});

describe("viewpoints", () => {
  it("reads a name or the six numbers of a place, and nothing else", () => {
    expect(viewpointOf("load")).toBe("load");
    expect(viewpointOf("-60, -90 50 0,0,5")).toEqual({ eye: [-60, -90, 50], target: [0, 0, 5] });
    expect(["", "moon", "1 2 3", "1 2 3 4 5 six", "1 2 3 4 5 Infinity"].map(viewpointOf)).toEqual([null, null, null, null, null]);
  });

  it("writes a place to a centimetre", () => {
    expect(textOfPlace({ eye: [1.23456, -2, 0], target: [0.004, 0, 5.678] })).toBe("1.23 -2 0 0 0 5.68");
  });
});

describe("the element's addresses", () => {
  const attributes = (given: Record<string, string>) => (name: string) => given[name] ?? null;

  it("opens the figure page of the app, awake, with the attributes", () => {
    const page = pageOf(attributes({ scenario: "paper", set: "load=true", controls: "load", plot: "ship.roll", camera: "top", caption: "not sent" }), APP, ARTICLE);
    expect(page.startsWith(`${APP}figure.html?`)).toBe(true);
    expect(figureBy(new URL(page).search)).toEqual({ ...figureBy(""), scenario: "paper", set: { load: true }, controls: ["load"], plot: ["ship.roll"], camera: "top", isAwake: true });
  });

  it("resolves a scenario file at the article, and a run at the figure page", () => {
    expect(figureBy(new URL(pageOf(attributes({ scenario: "lift.yaml" }), APP, ARTICLE)).search).scenario).toBe("https://journal.example/paper/lift.yaml");
    expect(new URL(pageOf(attributes({ run: "k1=abc.def" }), APP, ARTICLE)).hash).toBe("#k1=abc.def");
    expect(new URL(pageOf(attributes({ run: "#k1=abc.def" }), APP, ARTICLE)).hash).toBe("#k1=abc.def");
  });

  it("finds the app by src relative to the article, otherwise beside the script", () => {
    expect(appOf("../app", null, ARTICLE)).toBe("https://journal.example/app/");
    expect(appOf(APP, null, ARTICLE)).toBe(APP);
    expect(appOf(null, `${APP}kingpost-figure.js?v=1`, ARTICLE)).toBe(APP);
    expect(appOf(null, null, ARTICLE)).toBeNull();
  });

  it("shows the author's still, otherwise the gallery's picture, and none for a file", () => {
    expect(stillOf(attributes({ scenario: "paper", poster: "ship.png" }), APP, ARTICLE)).toBe("https://journal.example/paper/ship.png");
    expect(stillOf(attributes({ scenario: "paper" }), APP, ARTICLE)).toBe(`${APP}cards/paper.webp`);
    expect(stillOf(attributes({ scenario: "lift.yaml" }), APP, ARTICLE)).toBe("");
    expect(stillOf(attributes({}), APP, ARTICLE)).toBe("");
  });
});

describe("embed code", () => {
  const shown = { plot: ["ship.roll"], camera: "free" };
  const run = { scenario: { gallery: "paper", digest: "d" }, values: { load: true, "simulation.step_s": 0.002 }, changes: [], moment: null };

  it("names a scenario of the gallery with its values", () => {
    const figure = figureOf(run, 'A "ship" <her>', shown, "#k1=abc");
    expect(figure).toEqual({ scenario: "paper", set: run.values, controls: ["load"], plot: ["ship.roll"], camera: "", caption: 'A "ship" <her>', hash: "" });
    const code = elementFor(figure, APP);
    expect(code).toContain(`<script src="${APP}kingpost-figure.js" async></script>`);
    expect(code).toContain('scenario="paper"');
    expect(code).toContain('set="load=true; simulation.step_s=0.002"');
    expect(code).toContain('caption="A &quot;ship&quot; &lt;her&gt;"');
    expect(code).not.toMatch(/camera=|run=/);
  });

  it("holds the link of a run that was changed by hand, or of a user's own scenario", () => {
    const own = { ...run, scenario: { file: "a.yaml", text: "x", opened: {} } };
    const changed = { ...run, changes: [{ time_s: 1, input: "hoist", value: 2 }] };
    for (const one of [own, changed]) {
      const figure = figureOf(one, "Mine", { plot: [], camera: "load" }, "#k1=abc.def");
      expect(figure.scenario).toBeNull();
      expect(elementFor(figure, APP)).toContain('run="k1=abc.def"');
      expect(elementFor(figure, APP)).toContain('camera="load"');
      expect(frameFor(figure, APP)).toContain("#k1=abc.def\"");
    }
  });

  it("gives a plain frame the address with the same choices", () => {
    const code = frameFor(figureOf(run, "A ship", shown, ""), APP);
    const address = /src="([^"]*)"/.exec(code)![1].replaceAll("&amp;", "&");
    expect(figureBy(new URL(address).search)).toEqual({ ...figureBy(""), scenario: "paper", set: run.values, controls: ["load"], plot: ["ship.roll"], caption: "A ship" });
  });
});
