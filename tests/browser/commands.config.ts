import { defineConfig } from "@playwright/test";
import tests from "./playwright.config";

/** What is run by its own command after `web/build`, not with the tests: `npm --prefix tests/browser run` lists them. */
export default defineConfig({
  ...tests,
  testMatch: ["*.command.ts", "budgets.spec.ts"],
  reporter: [["list"], ["./budgets/reporter.ts"]],
});
