import { existsSync, readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { afterEach, describe, expect, it, vi } from "vitest";
import { Gallery, firstSentence } from "../src/app/gallery";
import { galleryIndex } from "../vite/gallery";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const index = await galleryIndex(here("../../scenarios"), here("../src/engine/pkg"));

afterEach(() => void vi.unstubAllGlobals());

async function loaded(entries: unknown): Promise<Gallery> {
  vi.stubGlobal("fetch", async () => new Response(JSON.stringify(entries)));
  return Gallery.load("https://ships.example/app/");
}

describe("the start page", () => {
  it("the start page has every scenario of the gallery in one group, and the paper's first", async () => {
    const { groups, entries } = await loaded(index);
    const files = readdirSync(here("../../scenarios")).filter((file) => file.endsWith(".yaml"));
    expect(entries.map(({ file }) => file).sort()).toEqual(files.sort());
    expect(groups.map(({ title }) => title)).toEqual(["The paper: Jardim et al. (2019)", "Lifts", "Cranes", "Afloat", "Physics"]);
    expect(groups[0].entries[0].name).toBe("paper");
  });

  it("the start page shows the server's own file last, in a separate group", async () => {
    const own = { name: "mine", title: "Mine", file: "mine.yaml", description: "" };
    const { groups } = await loaded([...index, own]);
    expect(groups.at(-1)).toEqual({ title: null, entries: [own] });
  });

  it("the start page describes each scenario in one sentence", () => {
    for (const { name, description } of index) {
      const sentence = firstSentence(description);
      expect(description.startsWith(sentence), name).toBe(true);
      expect(sentence, name).toMatch(/^[A-Z].{30,}[.]$/s);
      expect(sentence.length, name).toBeLessThan(260);
    }
  });

  it("the first sentence does not end after an initial", () => {
    expect(firstSentence("As Hulme computed it (J. Fluid Mech. 121). The wave passes.")).toBe("As Hulme computed it (J. Fluid Mech. 121).");
    expect(firstSentence("A box without end")).toBe("A box without end");
    expect(firstSentence("")).toBe("");
  });

  it("the gallery has one picture for each scenario, and no other pictures", () => {
    const pictures = readdirSync(here("../public/cards")).map((file) => file.replace(".webp", ""));
    expect(pictures.sort()).toEqual([...index.map(({ name }) => name), "hero"].sort());
    for (const { name } of index) {
      expect(readFileSync(here(`../public/cards/${name}.webp`)).subarray(8, 12).toString(), name).toBe("WEBP");
    }
    expect(existsSync(here("../public/cards/hero.webp"))).toBe(true);
  });
});
