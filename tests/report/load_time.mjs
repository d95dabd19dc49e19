// load_time.mjs REPORT.html...: how large each report is and how long Chromium (software renderer) takes until it is drawn, by
// the clock and by the processor time of the page's main thread. No test: machines differ.
import {statSync} from "node:fs";
import {resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {drawn, launch} from "./browser.mjs";

const browser = await launch();
await browser.newPage();
for (const file of process.argv.slice(2)) {
  const page = await browser.newPage({viewport: {width: 1400, height: 900}});
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", {timeDomain: "threadTicks"});
  const start = performance.now();
  await page.goto(pathToFileURL(resolve(file)).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "true", null, {timeout: 120000});
  await drawn(page);
  const seconds = (performance.now() - start) / 1000;
  const {metrics} = await session.send("Performance.getMetrics");
  const busy = metrics.find(({name}) => name === "TaskDuration").value;
  const elements = await page.evaluate(() => beadmesh.stage.scene.mesh.count);
  console.log(`${file}: ${elements} elements, ${(statSync(file).size / 1e6).toFixed(2)} MB, ${seconds.toFixed(2)} s, ` +
              `main thread ${busy.toFixed(2)} s`);
  await page.close();
}
await browser.close();
