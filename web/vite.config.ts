import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";
import { compressed } from "./vite/compressed.ts";
import { figure } from "./vite/figure.ts";
import { gallery } from "./vite/gallery.ts";
import { notices } from "./vite/notices.ts";
import { offline } from "./vite/offline.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  base: "./",
  plugins: [gallery(here("../scenarios"), here("src/engine/pkg")), notices(here("../THIRD_PARTY_NOTICES.txt")), figure(here("figure")), offline(here("src/offline")), compressed()],
  worker: { format: "es" },
  // The paper's equations stand beside the Python package.
  server: { fs: { allow: [".."] } },
  build: {
    target: "es2022",
    rolldownOptions: { input: [here("index.html"), here("figure.html")] },
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 800,
  },
  test: {
    include: ["tests/*.test.ts"],
    environment: "node",
    // Files share what they import: the engine's module is compiled once for each process, not once for each file.
    isolate: false,
    testTimeout: 30_000,
  },
});
