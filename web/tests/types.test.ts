import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { TYPES, typesOf } from "../scripts/types.mjs";

it.each(Object.entries(TYPES))("generated types agree with their schema (otherwise: npm run types): %s", async (name, file) => {
  expect(readFileSync(file, "utf8")).toBe(await typesOf(name));
});
