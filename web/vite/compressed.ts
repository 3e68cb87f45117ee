import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { extname, join, resolve } from "node:path";
import { brotliCompressSync } from "node:zlib";
import type { Plugin } from "vite";

/** Endings of the files that are compressed, and the least size, bytes: a smaller file is one packet already. */
const ENDINGS = [".css", ".js", ".wasm"];
const LEAST = 1400;

/**
 * Writes a copy of each script, style sheet and engine in Brotli beside it, with the ending `.br`: a third smaller than gzip for the
 * engine. `kingpost serve` sends it, and hosts that send files as they are do so too.
 */
export function compressed(): Plugin {
  let folder = "";
  return {
    name: "kingpost-compressed",
    apply: "build",
    configResolved(config) {
      folder = resolve(config.root, config.build.outDir, config.build.assetsDir);
    },
    closeBundle() {
      // A build that failed calls this, too, and has its own error.
      if (!existsSync(folder)) return;
      for (const name of readdirSync(folder).filter((name) => ENDINGS.includes(extname(name)))) {
        const content = readFileSync(join(folder, name));
        if (content.length >= LEAST) writeFileSync(join(folder, `${name}.br`), brotliCompressSync(content));
      }
    },
  };
}
