// make_report_pictures.mjs REPORT.html FOLDER: screenshots of a report for the pages and the README. Needs `npm ci`.
import {writeFileSync} from "node:fs";
import {join, resolve} from "node:path";
import {drawn, launch, open} from "../../tests/report/browser.mjs";

const [report, folder] = process.argv.slice(2);
const browser = await launch();
const page = await open(browser, resolve(report), {width: 1400, height: 900});

async function shot(name) {
  await drawn(page);
  writeFileSync(join(folder, `${name}.png`), await page.screenshot());
}

await shot("report");
await page.selectOption("#measure", "warpage");
await page.click("#beads tr[data-bead='14']");
for (const layer of ["axes", "splits"]) await page.click(`#layer-${layer}`);
await page.click("#tab-quality");
await shot("report_quality");
for (const layer of ["axes", "splits"]) await page.click(`#layer-${layer}`);
await page.selectOption("#measure", "jacobian");
await page.locator("#quality tbody tr", {hasText: "jacobian"}).click();
await shot("quality");
await browser.close();
