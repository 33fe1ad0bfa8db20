import { defineConfig } from "@playwright/test";
import tests from "./playwright.config";

/** `npm --prefix tests/browser run picture` after `web/build`: the README's picture of the page. */
export default defineConfig({ ...tests, testMatch: "picture.ts" });
