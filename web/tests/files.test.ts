import { afterEach, describe, expect, it, vi } from "vitest";
import { gathered, openedWith, scenarioAmong, ScenarioFiles, textsOf } from "../src/engine/files";
import { fetchText } from "../src/engine/network";

const FOLDER = "https://ships.example/app/scenarios/";

/** Returns a folder with these files, and the list of requested addresses. */
function folderOf(texts: Record<string, string>) {
  const asked: string[] = [];
  const files = new ScenarioFiles(FOLDER, async (url) => {
    asked.push(url);
    if (url.endsWith("/broken.json")) throw new TypeError("failed to fetch");
    return texts[url.slice(FOLDER.length)] ?? null;
  });
  return { files, asked };
}

describe("the files that a scenario names", () => {
  it("files that a scenario names are fetched once from the gallery's folder", async () => {
    const { files, asked } = folderOf({ "hydro/barge.hydro.json": "barge", "hydro/sphere.hydro.json": "sphere" });
    expect(await files.take([])).toEqual({});
    expect(await files.take(["hydro/barge.hydro.json"])).toEqual({ "hydro/barge.hydro.json": "barge" });
    const both = { "hydro/barge.hydro.json": "barge", "hydro/sphere.hydro.json": "sphere" };
    expect(await files.take(Object.keys(both))).toEqual(both);
    expect(asked).toEqual([`${FOLDER}hydro/barge.hydro.json`, `${FOLDER}hydro/sphere.hydro.json`]);
  });

  it("a file that is requested twice at the same time is fetched once", async () => {
    const { files, asked } = folderOf({ "a.json": "a" });
    await Promise.all([files.take(["a.json"]), files.take(["a.json"])]);
    expect(asked.length).toBe(1);
  });

  it("a missing file is left out, and fetched again at the next request", async () => {
    const { files, asked } = folderOf({ "a.json": "a" });
    expect(await files.take(["missing.json", "a.json"])).toEqual({ "a.json": "a" });
    await files.take(["missing.json"]);
    expect(asked.filter((url) => url.endsWith("missing.json")).length).toBe(2);
  });

  it("a file is not missing if the connection fails, and is fetched again at the next request", async () => {
    const { files, asked } = folderOf({ "a.json": "a" });
    await expect(files.take(["a.json", "broken.json"])).rejects.toThrow("failed to fetch");
    await expect(files.take(["broken.json"])).rejects.toThrow("failed to fetch");
    expect(asked.filter((url) => url.endsWith("broken.json")).length).toBe(2);
  });

  it("files are not fetched from outside the gallery's folder", async () => {
    const { files, asked } = folderOf({});
    expect(await files.take(["https://elsewhere.example/a.json", "../a.json", "/a.json", "//[", "hydro/../../a.json"])).toEqual({});
    expect(asked).toEqual([]);
  });
});

it("requests files until no new file is named, because parts name further files", async () => {
  const taken: string[][] = [];
  const names = (texts: Record<string, string>) => ("part" in texts ? ["part", "hull", "gone"] : ["part"]);
  const texts = await gathered(names, async (asked) => {
    taken.push([...asked]);
    return Object.fromEntries(asked.filter((name) => name !== "gone").map((name) => [name, `text of ${name}`]));
  });
  expect(taken).toEqual([["part"], ["hull", "gone"]]);
  expect(texts).toEqual({ part: "text of part", hull: "text of hull" });
});

it("reads parts of the gallery from its folder, also for a user's scenario", async () => {
  const { files } = folderOf({ "parts/crane.yaml": "the gallery's", "own.yaml": "the gallery's own" });
  const names = ["gallery:parts/crane.yaml", "own.yaml"];
  expect(await textsOf(names, { "own.yaml": "mine" }, files)).toEqual({
    "gallery:parts/crane.yaml": "the gallery's",
    "own.yaml": "mine",
  });
  expect(await textsOf(names, null, files)).toEqual({
    "gallery:parts/crane.yaml": "the gallery's",
    "own.yaml": "the gallery's own",
  });
  const beside = new ScenarioFiles("https://ships.example/mine/", async (url) => (url.endsWith("/own.yaml") ? "beside" : null));
  expect(await textsOf(names, null, files, beside)).toEqual({
    "gallery:parts/crane.yaml": "the gallery's",
    "own.yaml": "beside",
  });
});

it("finds files that were opened with a scenario, ignoring the folders in their names", () => {
  const opened = { "ship.hydro.json": "ship", "other.hydro.json": "other" };
  expect(openedWith(["hydro/ship.hydro.json", "hydro/barge.hydro.json"], opened)).toEqual({ "hydro/ship.hydro.json": "ship" });
  expect(openedWith(["other.hydro.json"], opened)).toEqual({ "other.hydro.json": "other" });
});

it("finds the scenario among databases, tables and other programs' files", () => {
  const scenario = "version: 1\nbodies:\n  hull: {}\n";
  expect(scenarioAmong({ "a.hydro.json": "{}", "waves.csv": "time_s,elevation_m", "ship.yaml": scenario })).toBe("ship.yaml");
  expect(scenarioAmong({ "orcaflex.yml": "VesselTypes:\n  - Name: ship", "ship.yaml": scenario })).toBe("ship.yaml");
  expect(scenarioAmong({ "ship.json": '{"version": 1, "bodies": {}}', "other.json": "{}" })).toBe("ship.json");
  expect(scenarioAmong({ "crane.yaml": scenario, "ship.yaml": "version: 1\nparts:\n  crane: {part: crane.yaml}\n" })).toBe("ship.yaml");
  expect(scenarioAmong({ "wrong.toml": "[project]" })).toBe("wrong.toml");
  expect(scenarioAmong({ "a.hydro.json": "{}" })).toBeUndefined();
});

describe("a fetched file", () => {
  afterEach(() => void vi.unstubAllGlobals());
  const answering = (answer: () => Promise<Response>) => vi.stubGlobal("fetch", answer);

  it("a fetched file is missing only if the server reports it", async () => {
    answering(async () => new Response("", { status: 404 }));
    expect(await fetchText("https://ships.example/a.json")).toBeNull();
    answering(async () => new Response("", { status: 503, statusText: "Service Unavailable" }));
    await expect(fetchText("https://ships.example/a.json")).rejects.toMatchObject({
      kind: "network",
      message: "a.json could not be fetched: the server answered 503 Service Unavailable.",
    });
  });

  it("a fetched file is not missing if the connection fails", async () => {
    answering(() => Promise.reject(new TypeError("Failed to fetch")));
    await expect(fetchText("https://ships.example/a.json")).rejects.toMatchObject({
      kind: "network",
      message: "a.json could not be fetched: the connection failed.",
    });
  });
});
