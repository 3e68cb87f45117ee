import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Builds the element as one script that a page can load from another origin, and a bundler can import. */
export default defineConfig({
  root: here("."),
  publicDir: false,
  build: {
    target: "es2022",
    outDir: here("dist"),
    emptyOutDir: true,
    lib: { entry: here("src/kingpost-figure.ts"), formats: ["iife"], name: "kingpostFigure", fileName: () => "kingpost-figure.js" },
  },
});
