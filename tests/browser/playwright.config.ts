import { defineConfig } from "@playwright/test";

const quiet = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];
const executablePath = process.env["CHROMIUM"] ?? "/usr/bin/chromium";

/** Without a graphics device the browser draws pages and plain canvases itself: much faster than a device in software. */
export const plainBrowser = { executablePath, args: [...quiet, "--disable-gpu"] };

/** WebGPU and WebGL2 by software drivers: for tests of what draws by them, `test.use({ launchOptions: graphicsBrowser })`. */
export const graphicsBrowser = {
  executablePath,
  args: [
    ...quiet,
    "--enable-unsafe-webgpu",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--use-angle=swiftshader",
    "--ignore-gpu-blocklist",
  ],
};

/** Another run on the same machine takes another one: PAGE_PORT=4300. */
const port = Number(process.env["PAGE_PORT"] ?? 4183);

export default defineConfig({
  testDir: ".",
  outputDir: "results",
  // A page and its browser take all cores: tests beside each other would only wait for each other.
  workers: 1,
  timeout: 60_000,
  expect: { timeout: 10_000 },
  reporter: [["list"]],
  use: {
    baseURL: `http://localhost:${port}/`,
    viewport: { width: 1440, height: 900 },
    launchOptions: plainBrowser,
    permissions: ["clipboard-read", "clipboard-write"],
  },
  webServer: {
    command: `../../web/page/node_modules/.bin/vite preview ../../web/page --host localhost --port ${port} --strictPort`,
    url: `http://localhost:${port}/`,
    reuseExistingServer: false,
  },
});
