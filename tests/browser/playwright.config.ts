import { defineConfig } from "@playwright/test";

/** Debian's Chromium with software drivers for WebGPU and WebGL2; no machine needs a graphics card. */
export const chromiumArguments = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--enable-unsafe-webgpu",
  "--enable-features=Vulkan",
  "--use-vulkan=swiftshader",
  "--use-angle=swiftshader",
  "--ignore-gpu-blocklist",
];

/** Another run on the same machine takes another one: PAGE_PORT=4300. */
const port = Number(process.env["PAGE_PORT"] ?? 4183);

export default defineConfig({
  testDir: ".",
  outputDir: "results",
  // Software rendering takes all cores: tests beside each other would only wait for each other.
  workers: 1,
  timeout: 60_000,
  expect: { timeout: 10_000 },
  reporter: [["list"]],
  use: {
    baseURL: `http://localhost:${port}/`,
    viewport: { width: 1440, height: 900 },
    launchOptions: {
      executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium",
      args: chromiumArguments,
    },
    permissions: ["clipboard-read", "clipboard-write"],
  },
  webServer: {
    command: `../../web/page/node_modules/.bin/vite preview ../../web/page --host localhost --port ${port} --strictPort`,
    url: `http://localhost:${port}/`,
    reuseExistingServer: false,
  },
});
