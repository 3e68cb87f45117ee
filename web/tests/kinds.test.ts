import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

interface Choice {
  oneOf: { properties: Record<string, unknown> }[];
}

const { $defs } = JSON.parse(readFileSync(here("../../schema/scenario.schema.json"), "utf8")) as { $defs: Record<string, Choice> };
const namesOf = (choice: string) => $defs[choice].oneOf.flatMap(({ properties }) => Object.keys(properties ?? {}));
/** Kinds of forces and drives, except those that are also names of solids, and a line, which is also one of a text or of a drawing. */
const KINDS = ["Force", "Drive"].flatMap(namesOf).filter((kind) => ![...namesOf("Shape"), "line"].includes(kind));

/** Source files of the app, except generated ones. */
function sources(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return ["generated", "pkg"].includes(entry.name) ? [] : sources(path);
    return entry.name.endsWith(".ts") ? [path] : [];
  });
}

it("the app's code names no kind of force or drive", () => {
  expect(KINDS.length).toBeGreaterThan(10);
  const found = sources(here("../src")).flatMap((path) => {
    const text = readFileSync(path, "utf8");
    return KINDS.filter((kind) => new RegExp(`\\b${kind}\\b`).test(text)).map((kind) => `${path}: ${kind}`);
  });
  expect(found).toEqual([]);
});
