import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";
import { gallery } from "./vite/gallery.ts";

export default defineConfig({
  base: "./",
  plugins: [gallery(fileURLToPath(new URL("../scenarios", import.meta.url)))],
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
