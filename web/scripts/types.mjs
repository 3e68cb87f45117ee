// Writes src/generated/scenario.d.ts from the scenario's JSON Schema, which comes from the engine's types.
import { writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { compileFromFile } from "json-schema-to-typescript";

const SCHEMA = fileURLToPath(new URL("../../schema/scenario.schema.json", import.meta.url));
export const TYPES = fileURLToPath(new URL("../src/generated/scenario.d.ts", import.meta.url));

export function scenarioTypes() {
  return compileFromFile(SCHEMA, {
    additionalProperties: false,
    bannerComment: "/* Generated from schema/scenario.schema.json by `npm run types`; do not edit. */",
    style: { printWidth: 110 },
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) writeFileSync(TYPES, await scenarioTypes());
