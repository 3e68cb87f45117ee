import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gathered } from "../src/engine/files";
import init, { file_names } from "../src/engine/pkg/kingpost_wasm.js";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
const GALLERY = "gallery:";

/** Loads the engine. */
export const initEngine = () => init({ module_or_path: readFileSync(here("../src/engine/pkg/kingpost_wasm_bg.wasm")) });

/** Returns the text of a file of the repository. */
export const read = (path: string) => readFileSync(here(`../../${path}`), "utf8");

/** Names of the gallery's scenarios. */
export const gallery = readdirSync(here("../../scenarios"))
  .filter((name) => name.endsWith(".yaml"))
  .map((name) => name.replace(".yaml", ""));

/** Returns, as JSON, the gallery's files that a scenario needs, and no others. */
export async function filesOf(text: string): Promise<string> {
  const files = await gathered(
    (texts) => JSON.parse(file_names(text, "", "{}", JSON.stringify(texts))),
    async (names) => {
      const shared = names.filter((name) => name.startsWith(GALLERY));
      return Object.fromEntries(shared.map((name) => [name, read(`scenarios/${name.slice(GALLERY.length)}`)]));
    },
  );
  return JSON.stringify(files);
}

/** Returns the bits of numbers. */
export const bits = (row: ArrayLike<number>) => Array.from(new BigUint64Array(Float64Array.from(row).buffer), String);
