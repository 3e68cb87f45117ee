import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { build } from "vite";
import { expect, it } from "vitest";

/** Largest size of the element's script before the engine is wanted, bytes: the requirement on the package. */
const MOST_BYTES = 30_000;

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

it("the element is one script of less than 30 kB without engine, and works with and without modules", async () => {
  const built = await build({ configFile: here("../figure/vite.config.ts"), logLevel: "error", build: { write: false } });
  const outputs = [built].flat().flatMap((one) => ("output" in one ? one.output : []));
  expect(outputs.map(({ fileName }) => fileName)).toEqual(["kingpost-figure.js"]);
  const [script] = outputs;
  const code = "code" in script ? script.code : "";
  expect(code.length).toBeGreaterThan(1000);
  expect(new TextEncoder().encode(code).length).toBeLessThan(MOST_BYTES);
  expect(code).not.toMatch(/^(import|export)\b|\bimport\(|\.wasm/m);
});

it("the package names its script, its types and its readme", () => {
  const { exports, files } = JSON.parse(readFileSync(here("../figure/package.json"), "utf8"));
  expect(exports["."]).toEqual({ types: "./kingpost-figure.d.ts", default: "./dist/kingpost-figure.js" });
  expect(files).toEqual(["dist", "kingpost-figure.d.ts", "README.md"]);
  expect(readFileSync(here("../figure/README.md"), "utf8")).toContain("<kingpost-figure");
  expect(readFileSync(here("../figure/kingpost-figure.d.ts"), "utf8")).toContain("HTMLElementTagNameMap");
});
