import { test } from "@playwright/test";
import { report } from "./budgets/budget";
import { Host } from "./budgets/host";
import { scores } from "./budgets/lighthouse";
import { measureOn } from "./budgets/on-renderer";

measureOn("canvas2d");

for (const form of ["desktop", "mobile"] as const)
  test(`Lighthouse, ${form}`, async ({}, info) => {
    test.setTimeout(300_000);
    const host = await Host.start("gzip");
    for (const { category, score, complaints } of await scores(host.address, form)) {
      if (complaints.length) console.log(`${category}: ${complaints.join("; ")}`);
      report(info, {
        name: `Lighthouse ${category}, ${form}`,
        measured: String(score),
        limit: "at least 95",
        kept: score >= 95,
        decides: category !== "Performance",
      });
    }
    host.stop();
  });
