import { createServer } from "node:net";
import { chromium } from "@playwright/test";
import lighthouse, { desktopConfig } from "lighthouse";
import { plainBrowser } from "../playwright.config";

export interface Score {
  readonly category: string;
  readonly score: number;
  /** What the category lost points for. */
  readonly complaints: readonly string[];
}

/** Lighthouse's four categories for an address, each of 100. */
export async function scores(address: string, form: "desktop" | "mobile"): Promise<Score[]> {
  const port = await freePort();
  const browser = await chromium.launch({
    ...plainBrowser,
    args: [...plainBrowser.args, `--remote-debugging-port=${port}`],
  });
  try {
    const result = await lighthouse(
      address,
      { port, logLevel: "error" },
      form === "desktop" ? desktopConfig : undefined,
    );
    if (!result) throw new Error("Lighthouse gave no result");
    const { categories, audits } = result.lhr;
    return Object.values(categories).map((category) => ({
      category: category.title,
      score: Math.round(100 * (category.score ?? 0)),
      complaints: category.auditRefs
        .filter(({ id, weight }) => weight > 0 && (audits[id].score ?? 1) < 0.9)
        .map(({ id }) => `${id}: ${audits[id].displayValue ?? audits[id].title}`),
    }));
  } finally {
    await browser.close();
  }
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const server = createServer();
    server.listen(0, () => {
      const address = server.address();
      server.close(() => resolve(typeof address === "object" && address ? address.port : 0));
    });
  });
}
