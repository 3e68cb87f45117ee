import { readFileSync } from "node:fs";
import { join } from "node:path";
import { build } from "vite";
import type { Plugin } from "vite";

/** Name of the element's script, in its package and beside the app. */
export const SCRIPT = "kingpost-figure.js";

/** Builds the element `<kingpost-figure>` in its package's folder, and puts its script beside the app. */
export function figure(folder: string): Plugin {
  return {
    name: "kingpost-figure",
    apply: "build",
    async generateBundle() {
      await build({ configFile: join(folder, "vite.config.ts"), logLevel: "warn" });
      this.emitFile({ type: "asset", fileName: SCRIPT, source: readFileSync(join(folder, "dist", SCRIPT)) });
    },
  };
}
