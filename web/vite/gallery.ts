import { readFileSync, readdirSync, existsSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";

export interface GalleryEntry {
  name: string;
  title: string;
  file: string;
}

/** The list of the gallery, `paper` first: it is the page that opens. */
export function galleryIndex(folder: string): GalleryEntry[] {
  if (!existsSync(folder)) return [];
  const entries = readdirSync(folder)
    .filter((file) => /\.ya?ml$/.test(file))
    .map((file) => ({ name: file.replace(/\.ya?ml$/, ""), title: titleOf(join(folder, file)), file }));
  return entries.sort((a, b) => rank(a) - rank(b) || a.name.localeCompare(b.name));
}

function rank(entry: GalleryEntry): number {
  return entry.name === "paper" ? 0 : 1;
}

function titleOf(path: string): string {
  const line = /^title:\s*(.+?)\s*$/m.exec(readFileSync(path, "utf8"));
  return line ? line[1].replace(/^(["'])(.*)\1$/, "$2") : "";
}

/** The hydrodynamic databases that scenarios name, as they name them. */
export function databases(folder: string): string[] {
  const hydro = join(folder, "hydro");
  if (!existsSync(hydro)) return [];
  return readdirSync(hydro).filter((file) => file.endsWith(".json")).sort().map((file) => `hydro/${file}`);
}

/** The parts that scenarios are made of, as they name them. */
export function parts(folder: string): string[] {
  const below = join(folder, "parts");
  if (!existsSync(below)) return [];
  return readdirSync(below).filter((file) => /\.ya?ml$/.test(file)).sort().map((file) => `parts/${file}`);
}

function served(folder: string): string[] {
  return [...galleryIndex(folder).map(({ file }) => file), ...parts(folder), ...databases(folder)];
}

/** Serves the gallery under `scenarios/` while developing and copies it into the built folder. */
export function gallery(folder: string): Plugin {
  return {
    name: "kingpost-gallery",
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        const asked = /\/scenarios\/([\w./-]+)$/.exec((request.url ?? "").split("?")[0])?.[1];
        if (!asked) return next();
        if (asked === "index.json") return void response.end(JSON.stringify(galleryIndex(folder)));
        if (!served(folder).includes(asked)) {
          response.statusCode = 404;
          return void response.end();
        }
        response.end(readFileSync(join(folder, asked)));
      });
    },
    generateBundle() {
      const entries = galleryIndex(folder);
      if (entries.length === 0) this.error(`no scenarios in ${folder}`);
      this.emitFile({ type: "asset", fileName: "scenarios/index.json", source: JSON.stringify(entries, null, 1) });
      for (const file of served(folder)) {
        this.emitFile({ type: "asset", fileName: `scenarios/${file}`, source: readFileSync(join(folder, file)) });
      }
    },
  };
}
