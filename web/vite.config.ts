import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";
import { gallery } from "./vite/gallery.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  base: "./",
  plugins: [gallery(here("../scenarios"), here("src/engine/pkg"))],
  worker: { format: "es" },
  build: {
    target: "es2022",
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 800,
  },
  test: {
    include: ["tests/*.test.ts"],
    environment: "node",
  },
});
