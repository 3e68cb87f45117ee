import { readFileSync } from "node:fs";
import type { Plugin } from "vite";

/** Puts the names and terms of those whose work is in the app beside it, as `third-party-notices.txt`. */
export function notices(file: string): Plugin {
  return {
    name: "kingpost-notices",
    generateBundle() {
      this.emitFile({ type: "asset", fileName: "third-party-notices.txt", source: readFileSync(file) });
    },
  };
}
