import { createHash } from "node:crypto";
import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import type { Plugin } from "vite";

/** Of the service worker, beside the page; and of the one that takes its place where nothing is to be kept. */
const SCRIPT = "offline.js";
const LEAVING = "offline-leave.js";

/** Every file of a built folder by its path, with a digest of it; the page stands under the folder's own address. */
export function digests(folder: string): Record<string, string> {
  const entries = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const paths = entries.map(({ parentPath, name }) => join(parentPath, name).slice(folder.length + 1).replaceAll("\\", "/"));
  const digest = (path: string) => createHash("sha256").update(readFileSync(join(folder, path))).digest("hex").slice(0, 16);
  const kept = paths.filter((path) => path !== SCRIPT && path !== LEAVING).sort();
  return Object.fromEntries(kept.map((path) => [path === "index.html" ? "" : path, digest(path)]));
}

/** Builds the service workers of a folder of sources, and writes into the one that keeps the app which files the build has. */
export function offline(sources: string): Plugin {
  let folder = "";
  return {
    name: "kingpost-offline",
    apply: "build",
    configResolved(config) {
      folder = resolve(config.root, config.build.outDir);
    },
    buildStart() {
      this.emitFile({ type: "chunk", id: join(sources, "worker.ts"), fileName: SCRIPT });
      this.emitFile({ type: "chunk", id: join(sources, "leave.ts"), fileName: LEAVING });
    },
    closeBundle() {
      const script = join(folder, SCRIPT);
      // A build that failed calls this, too, and has its own error.
      if (!existsSync(script)) return;
      writeFileSync(script, `self.kingpost_files=${JSON.stringify(digests(folder))};\n${readFileSync(script, "utf8")}`);
    },
  };
}
