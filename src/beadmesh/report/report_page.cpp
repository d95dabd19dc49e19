#include "beadmesh/report/report_page.h"

namespace beadmesh {

const char* const report_style = R"css(
:root { color-scheme: light; --ink: #1b1f24; --soft: #57606a; --line: #d8dee4; --back: #f6f8fa; }
* { box-sizing: border-box; }
body { margin: 0; font: 15px/1.45 system-ui, "Segoe UI", Helvetica, Arial, sans-serif; color: var(--ink); background: var(--back); }
header, section { max-width: 1480px; margin: 0 auto; padding: 0 24px; }
header { padding-top: 28px; }
h1 { font-size: 26px; margin: 0 0 4px; overflow-wrap: anywhere; }
h2 { font-size: 18px; margin: 32px 0 10px; }
.settings { color: var(--soft); }
.settings span { margin-right: 18px; white-space: nowrap; }
.figures { display: flex; flex-wrap: wrap; gap: 12px; margin-top: 18px; }
.figure { background: #fff; border: 1px solid var(--line); border-radius: 8px; padding: 10px 16px; min-width: 116px; }
.figure b { display: block; font-size: 22px; font-variant-numeric: tabular-nums; }
.figure small { color: var(--soft); }
.figure.bad { border-color: #cf222e; background: #fff1f0; }
.picture { position: relative; background: #fff; border: 1px solid var(--line); border-radius: 8px; overflow: hidden; margin-top: 18px; }
.picture svg { display: block; width: 100%; height: 72vh; cursor: grab; touch-action: none; }
.picture svg:active { cursor: grabbing; }
.picture .tools { position: absolute; right: 12px; top: 12px; display: flex; gap: 6px; }
.picture button { font: inherit; width: 34px; height: 34px; border: 1px solid var(--line); border-radius: 6px; background: #fff; cursor: pointer; }
.wide { overflow-x: auto; background: #fff; border: 1px solid var(--line); border-radius: 8px; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: 6px 12px; text-align: left; border-bottom: 1px solid var(--line); white-space: nowrap; }
td.text { white-space: normal; }
tr:last-child td { border-bottom: 0; }
th { position: sticky; top: 0; background: #fff; color: var(--soft); font-weight: 600; }
table.sortable th { cursor: pointer; user-select: none; }
table.sortable th[data-order="1"]::after { content: " \25B4"; }
table.sortable th[data-order="-1"]::after { content: " \25BE"; }
td.number, th.number { text-align: right; }
.dot { display: inline-block; width: 11px; height: 11px; border-radius: 3px; margin-right: 7px; }
.kind-I { background: #56a0d3; } .kind-generic { background: #f0ad28; } .kind-annular { background: #2eb28c; }
.fallback { color: #b3400a; font-weight: 600; }
.error { color: #cf222e; } .warning { color: #9a6700; } .note { color: var(--soft); }
.none { color: var(--soft); }
footer { max-width: 1480px; margin: 28px auto; padding: 0 24px; color: var(--soft); font-size: 13px; }
)css";

const char* const report_script = R"js(
"use strict";
(() => {
  const svg = document.querySelector(".picture svg");
  if (svg) {
    const home = svg.getAttribute("viewBox").split(" ").map(Number);
    let box = home.slice();
    svg.removeAttribute("width");
    svg.removeAttribute("height");
    const show = () => svg.setAttribute("viewBox", box.join(" "));
    const perPixel = () => Math.max(box[2] / svg.clientWidth, box[3] / svg.clientHeight);
    const zoom = (factor, x, y) => {
      const width = Math.min(home[2] * 4, Math.max(home[2] / 400, box[2] * factor));
      const f = width / box[2];
      box = [x - (x - box[0]) * f, y - (y - box[1]) * f, width, box[3] * f];
      show();
    };
    const place = (event) => {
      const r = svg.getBoundingClientRect(), s = perPixel();
      return [box[0] + box[2] / 2 + (event.clientX - r.left - r.width / 2) * s,
              box[1] + box[3] / 2 + (event.clientY - r.top - r.height / 2) * s];
    };
    const middle = (factor) => zoom(factor, box[0] + box[2] / 2, box[1] + box[3] / 2);
    svg.addEventListener("wheel", (event) => {
      event.preventDefault();
      zoom(Math.exp(event.deltaY * 0.0015), ...place(event));
    }, {passive: false});
    let last = null;
    svg.addEventListener("pointerdown", (event) => {
      last = [event.clientX, event.clientY];
      svg.setPointerCapture(event.pointerId);
    });
    svg.addEventListener("pointermove", (event) => {
      if (!last) return;
      const s = perPixel();
      box[0] -= (event.clientX - last[0]) * s;
      box[1] -= (event.clientY - last[1]) * s;
      last = [event.clientX, event.clientY];
      show();
    });
    for (const name of ["pointerup", "pointercancel"]) svg.addEventListener(name, () => { last = null; });
    const reset = () => { box = home.slice(); show(); };
    svg.addEventListener("dblclick", reset);
    document.getElementById("zoom-in").onclick = () => middle(0.7);
    document.getElementById("zoom-out").onclick = () => middle(1 / 0.7);
    document.getElementById("zoom-all").onclick = reset;
  }
  for (const table of document.querySelectorAll("table.sortable")) {
    const heads = [...table.tHead.rows[0].cells];
    heads.forEach((head, column) => head.addEventListener("click", () => {
      const order = head.dataset.order === "1" ? -1 : 1;
      heads.forEach((other) => delete other.dataset.order);
      head.dataset.order = order;
      const key = (row) => row.cells[column].textContent.trim();
      const rows = [...table.tBodies[0].rows];
      rows.sort((a, b) => order * key(a).localeCompare(key(b), "en", {numeric: true}));
      table.tBodies[0].append(...rows);
    }));
  }
})();
)js";

}  // namespace beadmesh
