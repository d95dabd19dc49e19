// Headless Chromium for the tests of the report, and a coarse comparison of pictures.
import {execFileSync} from "node:child_process";
import {existsSync, mkdirSync, readFileSync, writeFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath, pathToFileURL} from "node:url";
import {chromium} from "playwright-core";

const here = dirname(fileURLToPath(import.meta.url));

/** No graphics card is needed: SwiftShader draws. The sandbox of Chromium does not run as root. */
const flags = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
               "--disable-background-networking", "--force-color-profile=srgb", "--hide-scrollbars"];

function browserPath() {
  for (const name of ["chromium", "chromium-browser", "google-chrome"]) {
    try {
      return execFileSync("sh", ["-c", `command -v ${name}`], {encoding: "utf8"}).trim();
    } catch { /* the next one */ }
  }
  throw new Error("no Chromium on the path: apt-get install chromium");
}

export const launch = (more = []) => chromium.launch({executablePath: browserPath(), args: [...flags, ...more]});

/** Opens a report; fails on any error of the page, and on any request but the file's own. */
export async function open(browser, file, {width = 1080, height = 700, colorScheme = "light", media} = {}) {
  const page = await browser.newPage({viewport: {width, height}, colorScheme, reducedMotion: "reduce"});
  page.setDefaultTimeout(120000);  // the machine may be busy
  page.faults = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver Message/.test(message.text()))
      page.faults.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => page.faults.push(String(error.stack)));
  page.on("request", (request) => {
    if (request.url() !== pathToFileURL(file).href && !/^(data|blob):/.test(request.url()))
      page.faults.push(`request: ${request.url()}`);
  });
  if (media) await page.emulateMedia({media});
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "true", null, {timeout: 120000});
  await drawn(page);
  return page;
}

/** Until what was asked for is on the screen. */
export const drawn = (page) => page.evaluate(() => new Promise((done) =>
    requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));

/** The 3-D picture alone, as PNG. */
export async function picture(page) {
  await drawn(page);
  const box = await page.locator(".view").boundingBox();
  return page.screenshot({clip: box});
}

/** Means of red, green and blue over tiles of the picture, row by row. */
async function tiles(page, png, across = 36, down = 20) {
  return page.evaluate(async ([url, columns, rows]) => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.width, canvas.height = image.height;
    const context = canvas.getContext("2d", {willReadFrequently: true});
    context.drawImage(image, 0, 0);
    const {data} = context.getImageData(0, 0, image.width, image.height), out = [];
    for (let row = 0; row < rows; ++row)
      for (let column = 0; column < columns; ++column) {
        const x0 = Math.floor(column * image.width / columns), x1 = Math.floor((column + 1) * image.width / columns);
        const y0 = Math.floor(row * image.height / rows), y1 = Math.floor((row + 1) * image.height / rows);
        const sum = [0, 0, 0];
        for (let y = y0; y < y1; ++y)
          for (let x = x0; x < x1; ++x) for (let c = 0; c < 3; ++c) sum[c] += data[4 * (y * image.width + x) + c];
        out.push(...sum.map((value) => value / ((x1 - x0) * (y1 - y0))));
      }
    return out;
  }, [`data:image/png;base64,${png.toString("base64")}`, across, down]);
}

/** Largest and mean difference of the tiles, of 255. */
export async function difference(page, one, other) {
  const [a, b] = [await tiles(page, one), await tiles(page, other)];
  const apart = a.map((value, i) => Math.abs(value - b[i]));
  return {largest: Math.max(...apart), mean: apart.reduce((sum, value) => sum + value, 0) / apart.length};
}

/** Half as wide and high: what is kept as reference. */
async function reduced(page, png) {
  const url = await page.evaluate(async (source) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.width / 2, canvas.height = image.height / 2;
    const context = canvas.getContext("2d");
    context.imageSmoothingQuality = "high";
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    return canvas.toDataURL("image/png");
  }, `data:image/png;base64,${png.toString("base64")}`);
  return Buffer.from(url.split(",")[1], "base64");
}

/**
 * Compares with tests/report/pictures/NAME.png; with UPDATE_PICTURES=1 writes it instead. Fonts and rasterisers differ
 * a little from machine to machine, so tiles of some 30 pixels are compared.
 */
export async function matchesReference(page, name) {
  const png = await picture(page), path = join(here, "pictures", `${name}.png`);
  if (process.env.UPDATE_PICTURES) writeFileSync(path, await reduced(page, png));
  if (!existsSync(path)) throw new Error(`no reference ${path}: run with UPDATE_PICTURES=1 and look at it`);
  const apart = await difference(page, await reduced(page, png), readFileSync(path));
  const kept = process.env.PICTURES_KEPT;
  if (kept) {
    mkdirSync(kept, {recursive: true});
    writeFileSync(join(kept, `${name}.png`), png);
  }
  return apart;
}
