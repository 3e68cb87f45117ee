import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Plugin } from "vite";
import type { GalleryEntry } from "../src/app/gallery";
import { ScenarioFiles, gathered, textsOf } from "../src/engine/files";

/** Of the engine for the browser, what reads a scenario. */
type Reader = Pick<typeof import("../src/engine/pkg/kingpost_wasm.js"), "file_names" | "resolved">;

/** The list of the gallery with what the engine reads in it, in the order of its groups. */
export async function galleryIndex(folder: string, engine: string): Promise<GalleryEntry[]> {
  const reader = await loaded(engine);
  const groups = groupsOf(folder);
  const textAt = async (url: string) => (existsSync(new URL(url)) ? readFileSync(new URL(url), "utf8") : null);
  const ofFolder = new ScenarioFiles(pathToFileURL(`${folder}/`).href, textAt);
  const entry = async (file: string): Promise<GalleryEntry> => {
    const text = readFileSync(join(folder, file), "utf8");
    const files = await gathered(
      (texts) => JSON.parse(reader.file_names(text, file, "{}", JSON.stringify(texts))) as string[],
      (names) => textsOf(names, null, ofFolder),
    );
    const { title, description } = JSON.parse(reader.resolved(text, file, "{}", JSON.stringify(files))) as GalleryEntry;
    const name = file.replace(/\.ya?ml$/, "");
    return { name, title, file, description: description ?? "", group: groups.get(name) };
  };
  const entries = await Promise.all(scenarios(folder).map(entry));
  const order = [...groups.keys()];
  return entries.sort((a, b) => order.indexOf(a.name) - order.indexOf(b.name));
}

/** The group of each scenario by its name, in the order in which they are shown. */
function groupsOf(folder: string): Map<string, string> {
  const { groups } = JSON.parse(readFileSync(join(folder, "gallery.json"), "utf8")) as { groups: { title: string; scenarios: string[] }[] };
  return new Map(groups.flatMap(({ title, scenarios }) => scenarios.map((name) => [name, title] as const)));
}

async function loaded(engine: string): Promise<Reader> {
  const { default: init, ...reader } = await import(pathToFileURL(join(engine, "kingpost_wasm.js")).href);
  await init({ module_or_path: readFileSync(join(engine, "kingpost_wasm_bg.wasm")) });
  return reader;
}

function scenarios(folder: string): string[] {
  return existsSync(folder) ? readdirSync(folder).filter((file) => /\.ya?ml$/.test(file)) : [];
}

/** The hydrodynamic databases and tables of RAOs that scenarios name, as they name them. */
export function databases(folder: string): string[] {
  const hydro = join(folder, "hydro");
  if (!existsSync(hydro)) return [];
  return readdirSync(hydro).filter((file) => /\.(json|csv)$/.test(file)).sort().map((file) => `hydro/${file}`);
}

/** The parts that scenarios are made of, as they name them. */
export function parts(folder: string): string[] {
  const below = join(folder, "parts");
  if (!existsSync(below)) return [];
  return readdirSync(below).filter((file) => /\.ya?ml$/.test(file)).sort().map((file) => `parts/${file}`);
}

function served(folder: string): string[] {
  return [...scenarios(folder), ...parts(folder), ...databases(folder)];
}

/** Serves the gallery under `scenarios/` while developing and copies it into the built folder; `engine` is the folder of the engine for the browser. */
export function gallery(folder: string, engine: string): Plugin {
  return {
    name: "kingpost-gallery",
    configureServer(server) {
      server.middlewares.use(async (request, response, next) => {
        const asked = /\/scenarios\/([\w./-]+)$/.exec((request.url ?? "").split("?")[0])?.[1];
        if (!asked) return next();
        if (asked === "index.json") return void response.end(JSON.stringify(await galleryIndex(folder, engine)));
        if (!served(folder).includes(asked)) {
          response.statusCode = 404;
          return void response.end();
        }
        response.end(readFileSync(join(folder, asked)));
      });
    },
    async generateBundle() {
      const entries = await galleryIndex(folder, engine);
      if (entries.length === 0) this.error(`no scenarios in ${folder}`);
      this.emitFile({ type: "asset", fileName: "scenarios/index.json", source: JSON.stringify(entries, null, 1) });
      for (const file of served(folder)) {
        this.emitFile({ type: "asset", fileName: `scenarios/${file}`, source: readFileSync(join(folder, file)) });
      }
    },
  };
}
