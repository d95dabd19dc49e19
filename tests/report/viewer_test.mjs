// The report in headless Chromium: node --test viewer_test.mjs. MAKE_REPORT_PAGE is the program that writes synthetic
// reports, PAGES the folder for them; BEADMESH and MAKE_EXAMPLE_PANEL make one from a CAD file.
import assert from "node:assert/strict";
import {execFileSync, spawnSync} from "node:child_process";
import {mkdirSync, readFileSync, statSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {after, before, describe, test} from "node:test";
import {difference, drawn, launch, matchesReference, open, picture} from "./browser.mjs";

const {MAKE_REPORT_PAGE, BEADMESH, MAKE_EXAMPLE_PANEL, PAGES} = process.env;
const page_of = (name) => join(PAGES, `${name}.html`);

let browser, page;

function makePage(along, name, ...more) {
  execFileSync(MAKE_REPORT_PAGE, [String(along), page_of(name), ...more]);
  return page_of(name);
}

before(async () => {
  mkdirSync(PAGES, {recursive: true});
  browser = await launch();
});
after(() => browser?.close());

/** Pictures that a person tells apart at a glance differ by more. */
const visible = 0.4;

async function differs(page, change, least = visible) {
  const one = await picture(page);
  await change();
  const {mean} = await difference(page, one, await picture(page));
  assert.ok(mean > least, `the picture has changed by ${mean} only`);
}

async function same(page, change) {
  const one = await picture(page);
  await change();
  const {largest} = await difference(page, one, await picture(page));
  assert.ok(largest < 2, `the picture has changed by ${largest}`);
}

/** As the page opens, whatever tests before have left. */
async function fresh(page) {
  await page.mouse.move(2, 2);
  await page.evaluate(() => {
    document.activeElement?.blur();
    beadmesh.choose(null);
    beadmesh.coloring.show("");
    beadmesh.stage.fit({...beadmesh.stage.panelAngles(true), instantly: true});
  });
}

/** Of some 720 tiles, in 255 steps: a layer more or less changes some of them by more. */
const isAlike = (apart) => apart.mean < 1.5 && apart.largest < 10;

async function looksAs(page, name) {
  const apart = await matchesReference(page, name);
  assert.ok(isAlike(apart), JSON.stringify(apart));
}

/** Pixel of a point of the surface over a plane point. */
const pixelOf = (page, bead) => page.evaluate((id) => {
  const {stage} = beadmesh, box = stage.canvas.getBoundingClientRect();
  const [x, y] = stage.rig.project(stage.scene.beadById.get(id).at);
  return [box.left + x, box.top + y];
}, bead);

describe("a panel of 6,000 elements", () => {
  before(async () => {
    page = await open(browser, makePage(95, "panel"));
  });
  after(async () => {
    assert.deepEqual(page.faults, []);
    await page.close();
  });

  test("opens with beads by kind, element edges and crest lines, all of it in the picture", async () => {
    const on = await page.$$eval(".layers input:checked", (boxes) => boxes.map((box) => box.id));
    assert.deepEqual(on, ["layer-mesh", "layer-edges", "layer-crests", "layer-labels"]);
    const inside = await page.evaluate(() => {
      const {stage} = beadmesh, {nodes} = stage.scene.mesh;
      for (let i = 0; i < nodes.length; i += 3) {
        const [x, y] = stage.rig.project([nodes[i], nodes[i + 1], nodes[i + 2]]);
        if (x < 0 || y < 0 || x > stage.rig.width || y > stage.rig.heightInPixels) return false;
      }
      return true;
    });
    assert.ok(inside);
  });

  test("looks as its reference does", async () => {
    await fresh(page);
    await looksAs(page, "kinds");
  });

  test("with a layer more or less it does not look as its reference does", async () => {
    for (const layer of ["mesh", "edges", "crests", "axes", "splits", "blocks", "labels", "patterns"]) {
      await page.click(`#layer-${layer}`);
      await fresh(page);
      const apart = await matchesReference(page, "kinds");
      assert.ok(!isAlike(apart), `${layer}: ${JSON.stringify(apart)}`);
      await page.click(`#layer-${layer}`);
    }
  });

  test("every layer changes the picture and changes it back", async () => {
    for (const layer of ["mesh", "edges", "crests", "axes", "splits", "blocks", "labels", "patterns"]) {
      const one = await picture(page), box = page.locator(`#layer-${layer}`), was = await box.isChecked();
      await box.click();
      const changed = await difference(page, one, await picture(page));
      assert.ok(changed.largest > 4, `${layer}: ${JSON.stringify(changed)}`);
      await box.click();
      assert.equal(await box.isChecked(), was);
      const back = await difference(page, one, await picture(page));
      assert.ok(back.largest < 1, `${layer}: ${JSON.stringify(back)}`);
    }
  });

  test("surface and mesh take turns", async () => {
    await differs(page, () => page.click("#layer-surface"));
    assert.equal(await page.isChecked("#layer-mesh"), false);
    await page.click("#layer-mesh");
    assert.equal(await page.isChecked("#layer-surface"), false);
  });

  test("turns, moves and zooms by mouse", async () => {
    const box = await page.locator(".view").boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
    const state = () => page.evaluate(() => structuredClone(beadmesh.stage.rig.state));
    const start = await state();
    const drag = async (keys) => {
      if (keys) await page.keyboard.down(keys);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 80, y + 30, {steps: 4});
      await page.mouse.up();
      if (keys) await page.keyboard.up(keys);
    };
    await differs(page, () => drag());
    const turned = await state();
    assert.notEqual(turned.azimuth, start.azimuth);
    assert.deepEqual(turned.target, start.target);
    await differs(page, () => drag("Shift"));
    const moved = await state();
    assert.notDeepEqual(moved.target, start.target);
    assert.equal(moved.azimuth, turned.azimuth);
    await differs(page, () => page.mouse.wheel(0, -300));
    assert.ok((await state()).height < start.height * 0.8);
    await page.evaluate((s) => { beadmesh.stage.rig.flyTo(s, true); }, start);
  });

  test("a zoom keeps the point under the pointer", async () => {
    const [x, y] = await pixelOf(page, 2);
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, -400);
    await drawn(page);
    const [x1, y1] = await pixelOf(page, 2);
    assert.ok(Math.hypot(x1 - x, y1 - y) < 1, `${x1 - x} ${y1 - y}`);
    await page.keyboard.press("f");
  });

  test("a click chooses the element under it, a double click its bead", async () => {
    await page.keyboard.press("2");  // from above
    for (const id of [1, 2, 3]) {
      const [x, y] = await pixelOf(page, id);
      await page.mouse.click(x + 1, y + 1);
      const card = await page.locator(".card").innerText();
      assert.match(card, /^×?\s*(Quad|Triangle) \d+/);
      assert.match(card, new RegExp(`bead ${id}, `));
      const right = await page.evaluate((bead) => {
        const {stage, chosen} = beadmesh, {mesh, beadById} = stage.scene, at = beadById.get(bead).at;
        const corners = [0, 1, 2, 3].map((k) => 3 * mesh.corners[4 * chosen.element + k]);
        return Math.min(...corners.map((c) => Math.hypot(mesh.nodes[c] - at[0], mesh.nodes[c + 1] - at[1])));
      }, id);
      assert.ok(right < 6, `the element is ${right} mm away`);
      await page.keyboard.press("Escape");  // the card may cover the next one
    }
    const [x, y] = await pixelOf(page, 3);
    await page.mouse.dblclick(x, y);
    assert.deepEqual(await page.evaluate(() => beadmesh.chosen), {bead: 3});
    assert.match(await page.locator(".card h3").innerText(), /Bead 3: ring, annular bead/);
    assert.equal(await page.locator("#beads tr.chosen th").innerText(), "3");
    await page.keyboard.press("Escape");
    assert.ok(await page.locator(".card").isHidden());
    await page.keyboard.press("0");
  });

  test("a click beside the panel chooses nothing", async () => {
    const box = await page.locator(".view").boundingBox();
    await page.mouse.click(box.x + 4, box.y + box.height / 2);
    assert.equal(await page.evaluate(() => beadmesh.chosen), null);
  });

  test("the pointer tells what lies under it", async () => {
    const [x, y] = await pixelOf(page, 1);
    await page.mouse.move(x, y);
    await page.locator(".tip:not([hidden])").waitFor();
    assert.match(await page.locator(".tip").innerText(), /element \d+\s+bead 1, I \(I bead\), face 2/);
    await page.mouse.move(2, 2);
  });

  test("colours by every measure, with legend, limits and a histogram that counts every element", async () => {
    const names = await page.$$eval("#measure optgroup option", (options) => options.map((o) => o.value));
    assert.deepEqual(names, ["scaled Jacobian", "jacobian", "min length", "max length", "aspect ratio", "warpage", "skew",
                             "min angle", "max angle"]);
    const kinds = await picture(page);
    for (const name of names) {
      await page.selectOption("#measure", name);
      const {mean} = await difference(page, kinds, await picture(page));
      assert.ok(mean > visible, `${name}: ${mean}`);
      const labels = await page.$$eval(".bin", (bins) => bins.map((bin) => bin.getAttribute("aria-label")));
      const sum = labels.reduce((all, label) => all + Number(label.match(/: ([\d,]+) element/)[1].replaceAll(",", "")), 0);
      const applicable = await page.evaluate((measure) => beadmesh.stage.scene.mesh.measures
          .find((m) => m.name === measure).values.filter((value) => !Number.isNaN(value)).length, name);
      assert.equal(sum, applicable, name);
    }
    await fresh(page);
    await page.selectOption("#measure", "warpage");
    await looksAs(page, "warpage");
  });

  test("a bin of the histogram makes the others step back", async () => {
    const bin = page.locator(".bin[tabindex='0']").last();
    await differs(page, () => bin.click());
    assert.equal(await bin.getAttribute("aria-pressed"), "true");
    const count = Number((await bin.getAttribute("aria-label")).match(/: ([\d,]+) element/)[1].replaceAll(",", ""));
    assert.equal(await page.evaluate(() => beadmesh.stage.mesh.state.filter((s) => s === 0).length), count);
    await bin.press("Enter");
    assert.equal(await page.evaluate(() => beadmesh.stage.mesh.state.filter((s) => s === 1).length), 0);
  });

  test("palette and range can be set", async () => {
    await differs(page, () => page.selectOption(".legend select", "cividis"));
    const high = page.locator(".range input").last();
    await differs(page, async () => {
      await high.fill("3");
      await high.press("Tab");
    });
    await page.click(".range button");
    assert.equal(await page.evaluate(() => beadmesh.coloring.ramp), "viridis");
    await page.selectOption("#measure", "");
  });

  test("the elements of the table's worst values are what the data say", async () => {
    await page.click("#tab-quality");
    const rows = page.locator("#quality tbody tr[data-element]");
    const names = await rows.evaluateAll((all) => all.map((row) => row.cells[0].textContent));
    assert.ok(names.length >= 9);
    for (const [name, measure] of [["min length", "min length"], ["warpage", "warpage"], ["min angle quad", "min angle"]]) {
      const row = rows.nth(names.indexOf(name));
      const shown = Number(await row.locator("td").nth(1).innerText());
      await row.click();
      const value = await page.evaluate((m) => beadmesh.stage.scene.mesh.measures.find((x) => x.name === m)
          .values[beadmesh.chosen.element], measure);
      assert.ok(Math.abs(value - shown) < 0.002, `${name}: ${value} ${shown}`);
    }
    await page.keyboard.press("Escape");
    await page.keyboard.press("f");
  });

  test("the bead table sorts, filters and zooms", async () => {
    await page.click("#tab-beads");
    const ids = () => page.$$eval("#beads tbody tr:not([hidden]) th", (cells) => cells.map((cell) => cell.textContent));
    const head = (name) => page.locator("#beads thead button", {hasText: new RegExp(`^${name}$`)});
    assert.deepEqual(await ids(), ["1", "2", "3"]);
    await head("length, mm").click();
    const lengths = await page.$$eval("#beads tbody tr", (rows) => rows.map((row) => parseFloat(row.cells[4].textContent)));
    assert.deepEqual(lengths, [...lengths].sort((a, b) => a - b));
    await head("length, mm").click();
    assert.equal(await page.locator("#beads th[aria-sort]").getAttribute("aria-sort"), "descending");
    assert.deepEqual(await ids(), ["3", "2", "1"]);
    await head("id").click();
    await page.selectOption(".table-tools select", "generic");
    assert.deepEqual(await ids(), ["2"]);
    await page.selectOption(".table-tools select", "");
    await page.fill(".table-tools input", "RING");
    assert.deepEqual(await ids(), ["3"]);
    await page.fill(".table-tools input", "no such bead");
    assert.deepEqual(await ids(), []);
    await page.fill(".table-tools input", "");
    const before = await page.evaluate(() => beadmesh.stage.rig.state.height);
    await differs(page, () => page.click("#beads tr[data-bead='1']"));
    assert.ok(await page.evaluate(() => beadmesh.stage.rig.state.height) < 0.7 * before);
    await fresh(page);
    await page.click("#beads tr[data-bead='1']");
    await page.mouse.move(2, 2);
    await looksAs(page, "zoomed");
    await page.keyboard.press("Escape");
    await page.keyboard.press("f");
  });

  test("a row under the pointer is outlined in the picture", async () => {
    const one = await picture(page);
    await page.hover("#beads tr[data-bead='3']");
    const {largest} = await difference(page, one, await picture(page));
    assert.ok(largest > 4, String(largest));
    await page.mouse.move(2, 2);
  });

  test("diagnostics and faces go to their place", async () => {
    await page.click("#tab-diagnostics");
    await page.click("#diagnostics tr[data-face='3']");
    assert.deepEqual(await page.evaluate(() => beadmesh.chosen), {bead: 2});
    await page.click("#tab-faces");
    await page.click("#faces tr[data-face='1']");
    assert.deepEqual(await page.evaluate(() => beadmesh.chosen), {face: 0});
    assert.match(await page.locator(".card").innerText(), /it has 4 loops/);
    await page.keyboard.press("Escape");
    await page.keyboard.press("f");
    await page.click("#tab-beads");
  });

  test("all of it by keyboard alone", async () => {
    await page.locator(".view canvas").first().focus();
    await differs(page, () => page.keyboard.press("ArrowRight"));
    await differs(page, () => page.keyboard.press("Shift+ArrowRight"));
    await differs(page, () => page.keyboard.press("+"));
    await page.keyboard.press("f");
    await differs(page, () => page.keyboard.press("s"));
    await page.keyboard.press("m");
    await page.keyboard.press("]");
    await page.keyboard.press("]");
    assert.deepEqual(await page.evaluate(() => beadmesh.chosen), {bead: 2});
    await page.keyboard.press("[");
    assert.deepEqual(await page.evaluate(() => beadmesh.chosen), {bead: 1});
    await page.keyboard.press("/");
    assert.equal(await page.evaluate(() => document.activeElement.type), "search");
    await page.keyboard.type("m");  // a letter, no layer
    assert.ok(await page.isChecked("#layer-mesh"));
    await page.keyboard.press("Escape");
    assert.equal(await page.inputValue(".table-tools input"), "");
    assert.equal(await page.locator("#beads tbody tr:not([hidden])").count(), 3);
    await page.locator("#beads tr[data-bead='1']").focus();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Enter");
    assert.deepEqual(await page.evaluate(() => beadmesh.chosen), {bead: 2});
    await page.locator("#tab-beads").focus();
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.evaluate(() => document.activeElement.id), "tab-quality");
    assert.ok(await page.isVisible("#quality"));
    await page.locator(".divider").focus();
    await page.keyboard.press("ArrowUp");
    assert.equal(await page.getAttribute(".divider", "aria-valuenow"), "38");
    await page.keyboard.press("ArrowDown");
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("?");
    assert.ok(await page.isVisible("dialog.help"));
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    await page.keyboard.press("f");
    await page.click("#tab-beads");
  });

  test("every control is reached by Tab and says its name", async () => {
    const unnamed = await page.$$eval("button, select, input, [tabindex='0']", (all) => all
        .filter((e) => e.offsetParent !== null && !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length))
        .map((e) => e.outerHTML.slice(0, 80)));
    assert.deepEqual(unnamed, []);
    await page.evaluate(() => document.activeElement?.blur());
    const reached = new Set();
    for (let i = 0; i < 45; ++i) {
      await page.keyboard.press("Tab");
      const [id, outlined] = await page.evaluate(() => {
        const e = document.activeElement;
        return [e === document.body ? "BODY" : e.id || e.getAttribute("aria-label") || e.textContent.trim() || e.tagName, getComputedStyle(e).outlineStyle !== "none"];
      });
      assert.ok(id === "BODY" || outlined, `${id} shows no focus`);
      reached.add(id);
    }
    for (const id of ["layer-mesh", "measure", "tab-beads", "View", "Show all", "Keys", "Height of the tables"])
      assert.ok([...reached].some((r) => r === id || r.startsWith(id)), `${id} not among ${[...reached]}`);
  });

  test("the theme can be changed", async () => {
    await differs(page, () => page.click("header .theme"), 40);
    await fresh(page);
    await looksAs(page, "dark");
    await page.click("header .theme");
  });

  test("prints the picture and all tables", async () => {
    const pdf = await page.pdf({preferCSSPageSize: true, path: page_of("panel").replace(".html", ".pdf")});
    assert.ok(pdf.length > 30000, `${pdf.length} bytes hold no picture`);
    await page.emulateMedia({media: "print"});
    for (const table of ["#beads", "#quality", "#diagnostics", "#faces"]) assert.ok(await page.isVisible(table), table);
    for (const part of [".toolbar", ".sidebar", ".dock-bar"]) assert.ok(!(await page.isVisible(part)), part);
    await page.emulateMedia({media: "screen"});
    await same(page, () => page.keyboard.press("f"));
  });
});

describe("other pages", () => {
  test("a panel of 300,000 elements loads, picks and colours", async () => {
    const file = makePage(672, "large");
    assert.ok(statSync(file).size < 15e6, `${statSync(file).size} bytes`);
    const large = await open(browser, file);
    assert.ok(await large.evaluate(() => beadmesh.stage.scene.mesh.count) > 300000);
    const calls = await large.evaluate(() => beadmesh.stage.renderer.info.render.calls);
    assert.ok(calls <= 8, `${calls} draw calls`);
    const [x, y] = await pixelOf(large, 3);
    await large.mouse.click(x, y);
    assert.match(await large.locator(".card").innerText(), /bead 3, ring/);
    await large.keyboard.press("Escape");
    await differs(large, () => large.selectOption("#measure", "min angle"));
    assert.deepEqual(large.faults, []);
    await large.close();
  });

  test("beads without a mesh are shown on the surface", async () => {
    const surface = await open(browser, makePage(95, "recognised", "recognised"));
    assert.ok(await surface.isChecked("#layer-surface"));
    assert.equal(await surface.locator("#layer-mesh").count(), 0);
    const [x, y] = await pixelOf(surface, 2);
    await surface.mouse.click(x, y);
    assert.match(await surface.locator(".card h3").innerText(), /Face 3/);
    await surface.keyboard.press("Escape");
    await fresh(surface);
    await looksAs(surface, "recognised");
    assert.deepEqual(surface.faults, []);
    await surface.close();
  });

  test("without WebGL the flat picture stands in and says so", async () => {
    const plain = await launch(["--disable-gpu", "--disable-webgl", "--disable-3d-apis"]);
    const flat = await open(plain, makePage(95, "panel"));
    assert.match(await flat.locator(".notice").innerText(), /No 3-D view: .*flat picture/);
    assert.ok(await flat.locator(".flat svg #mesh path").count() > 0);
    const before = await flat.getAttribute(".flat svg", "viewBox");
    await flat.click(".toolbar button[aria-label='Zoom in']");
    assert.notEqual(await flat.getAttribute(".flat svg", "viewBox"), before);
    assert.ok(await flat.isVisible("#beads tbody tr"));
    assert.deepEqual(flat.faults, []);
    await plain.close();
  });

  test("a browser that cannot inflate gets it done by the page", async () => {
    const context = await browser.newContext(), old = await context.newPage();
    await old.addInitScript(() => { delete window.DecompressionStream; });
    await old.goto(`file://${makePage(95, "panel")}`);
    await old.waitForFunction(() => document.documentElement.dataset.ready === "true", null, {timeout: 120000});
    assert.equal(await old.evaluate(() => typeof DecompressionStream), "undefined");
    assert.equal(await old.evaluate(() => beadmesh.stage.scene.mesh.count), 6046);
    await context.close();
  });

  test("without script the tables are there", async () => {
    const context = await browser.newContext({javaScriptEnabled: false});
    const bare = await context.newPage();
    await bare.goto(`file://${makePage(95, "panel")}`);
    for (const table of ["#beads", "#quality", "#diagnostics", "#faces"]) assert.ok(await bare.isVisible(`${table} table`), table);
    await context.close();
  });

  test("nothing is cut off at 900 x 700 and on a telephone", async () => {
    for (const [width, height] of [[900, 700], [400, 800]]) {
      const small = await open(browser, makePage(95, "panel"), {width, height});
      assert.ok(await small.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${width}`);
      assert.ok(await small.isVisible(".view canvas"));
      assert.deepEqual(small.faults, []);
      await small.close();
    }
  });

  test("the report of a CAD panel by the program", async () => {
    const step = join(PAGES, "basic.step"), file = page_of("basic");
    execFileSync(MAKE_EXAMPLE_PANEL, ["basic", step]);
    const limits = join(PAGES, "design.toml");
    writeFileSync(limits, "[design]\nmax_wall_angle = 10.0\n");
    const made = spawnSync(BEADMESH, ["mesh", step, "-o", join(PAGES, "basic.bdf"), "--report", file, "--design-check", "--config", limits]);
    assert.equal(made.status, 1, "walls are steeper than 10 degrees");
    assert.ok(statSync(file).size < 1.5e6, `${statSync(file).size} bytes`);
    const basic = await open(browser, file);
    assert.equal(await basic.locator("#beads tbody tr").count(), 4);
    await basic.click("#tab-design");
    assert.equal(await basic.locator("#design td.fails").count(), 4);
    await basic.click("#design tr[data-bead='2']");
    assert.deepEqual(await basic.evaluate(() => beadmesh.chosen), {bead: 2});
    await basic.keyboard.press("Escape");
    await basic.keyboard.press("f");
    for (const layer of ["axes", "splits", "blocks"]) {
      const one = await picture(basic);
      await basic.click(`#layer-${layer}`);
      const {largest} = await difference(basic, one, await picture(basic));
      assert.ok(largest > 4, `${layer}: ${largest}`);
    }
    assert.deepEqual(basic.faults, []);
    await basic.close();
    const beads = page_of("basic_beads");
    execFileSync(BEADMESH, ["beads", step, "--report", beads], {stdio: "ignore"});
    assert.match(readFileSync(beads, "utf8"), /<tr data-bead="4">/);
  });
});
