import { test } from "@playwright/test";
import { measureOn } from "./budgets/on-renderer";
import { graphicsBrowser } from "./playwright.config";

test.use({ launchOptions: graphicsBrowser });

measureOn("webgpu");
