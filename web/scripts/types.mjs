// Writes src/generated: types from the JSON Schemas of the scenario and of what the engine says of it, of its hulls and of its equations,
// which come from the engine's types.
import { writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { compileFromFile } from "json-schema-to-typescript";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

/** Name of each schema, and where its types stand. */
export const TYPES = Object.fromEntries(
  ["scenario", "model", "hydrostatics", "equations"].map((name) => [name, here(`../src/generated/${name}.d.ts`)]),
);

export function typesOf(name) {
  return compileFromFile(here(`../../schema/${name}.schema.json`), {
    additionalProperties: false,
    bannerComment: `/* Generated from schema/${name}.schema.json by \`npm run types\`; do not edit. */`,
    style: { printWidth: 110 },
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const [name, file] of Object.entries(TYPES)) writeFileSync(file, await typesOf(name));
}
