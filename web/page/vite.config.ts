import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vitest/config";

export default defineConfig({
  // Relative addresses: the built folder opens below any path of a web server.
  base: "./",
  plugins: [svelte()],
  build: {
    target: "es2023",
    // Each WebAssembly module stays a file of its own: it is compiled while it streams in.
    assetsInlineLimit: 0,
  },
  // Workers share chunks with the page: they are modules too.
  worker: { format: "es" },
  test: { include: ["src/**/*.test.ts"], environment: "node", css: true },
});
