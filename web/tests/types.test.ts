import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { scenarioTypes, TYPES } from "../scripts/types.mjs";

it("has the scenario's types as its schema gives them (else: npm run types)", async () => {
  expect(readFileSync(TYPES, "utf8")).toBe(await scenarioTypes());
});
