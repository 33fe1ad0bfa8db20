import { fileURLToPath } from "node:url";
import { test } from "@playwright/test";
import { Lab } from "./lab";
import { graphicsBrowser } from "./playwright.config";

test.use({ launchOptions: graphicsBrowser });

const file = fileURLToPath(new URL("../../web/page/picture.png", import.meta.url));

test("the page as the README shows it", async ({ page }) => {
  const lab = await Lab.open(page, "./?theme=light");
  await lab.page.screenshot({ path: file });
});
