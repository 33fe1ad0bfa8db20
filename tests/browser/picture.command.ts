import { fileURLToPath } from "node:url";
import { expect, test } from "@playwright/test";
import { Lab } from "./lab";
import { graphicsBrowser } from "./playwright.config";

test.use({ launchOptions: graphicsBrowser });

const file = (name: string) => fileURLToPath(new URL(`../../web/page/${name}.png`, import.meta.url));

test("Track as the README shows it", async ({ page }) => {
  await Lab.open(page, "./?theme=light");
  await page.screenshot({ path: file("picture") });
});

test("Explore as the README shows it", async ({ page }) => {
  const lab = await Lab.open(page, "./?theme=light");
  await page.getByRole("navigation", { name: "Labs" }).getByRole("button", { name: "Explore" }).click();
  await expect(page.getByRole("table", { name: "Bounds of one epoch" })).toBeVisible();
  await lab.settled();
  await page.screenshot({ path: file("picture-explore") });
});
