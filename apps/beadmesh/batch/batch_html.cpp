// The page of a batch: totals, and a table that sorts and filters.
#include <fmt/format.h>

#include "batch/batch_summary.h"

namespace beadmesh::app {
namespace {

constexpr const char* style = R"(
body { font: 15px/1.45 system-ui, sans-serif; margin: 1.5rem auto; max-width: 90rem; padding: 0 1rem; color: #1b1b1b; }
h1 { font-size: 1.4rem; }
.totals { display: flex; flex-wrap: wrap; gap: .6rem; margin: 1rem 0; padding: 0; list-style: none; }
.totals li { border: 1px solid #c8c8c8; border-radius: .4rem; padding: .4rem .9rem; }
.totals b { display: block; font-size: 1.35rem; font-variant-numeric: tabular-nums; }
form { display: flex; flex-wrap: wrap; gap: 1rem; align-items: center; margin: 1rem 0; }
input, select { font: inherit; padding: .25rem .4rem; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: .3rem .55rem; border-bottom: 1px solid #ddd; vertical-align: top; }
th { position: sticky; top: 0; background: #f1f3f5; }
th button { all: unset; cursor: pointer; font-weight: 600; }
th button:focus-visible, a:focus-visible { outline: 3px solid #0b63c5; outline-offset: 2px; }
th[aria-sort=ascending] button::after { content: " \25B2"; }
th[aria-sort=descending] button::after { content: " \25BC"; }
th[data-numeric="1"], td.n { text-align: right; font-variant-numeric: tabular-nums; }
td.m { max-width: 34rem; overflow-wrap: anywhere; font-size: .9em; }
.o { white-space: nowrap; border-left: .4rem solid #0072b2; padding-left: .5rem; }
.short .o { border-left-color: #e69f00; }
.bad .o { border-left: .4rem double #a4243b; font-weight: 600; }
@media print { form { display: none; } th { position: static; } body { max-width: none; margin: 0; font-size: 10px; } }
)";

constexpr const char* script = R"(
"use strict";
const table = document.querySelector("table"), body = table.tBodies[0], rows = [...body.rows];
const text = document.getElementById("text"), outcome = document.getElementById("outcome");
const count = document.getElementById("count");
function filter() {
  const wanted = text.value.toLowerCase();
  let shown = 0;
  for (const row of rows) {
    const group = row.className || "done";
    const fits = (!outcome.value || outcome.value === group) && row.textContent.toLowerCase().includes(wanted);
    row.hidden = !fits;
    shown += fits;
  }
  count.textContent = shown + " of " + rows.length + " shown";
}
function sort(head, column) {
  const down = head.getAttribute("aria-sort") === "ascending";
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const numeric = head.dataset.numeric === "1";
  const key = row => row.cells[column].textContent;
  const compare = numeric
    ? (a, b) => (key(a) === "" ? -Infinity : +key(a)) - (key(b) === "" ? -Infinity : +key(b))
    : (a, b) => key(a) < key(b) ? -1 : key(a) > key(b) ? 1 : 0;
  const order = rows.map((row, i) => [row, i]);
  order.sort((a, b) => (down ? compare(b[0], a[0]) : compare(a[0], b[0])) || a[1] - b[1]);
  body.append(...order.map(entry => entry[0]));
}
[...table.tHead.rows[0].cells].forEach((head, i) => head.querySelector("button").onclick = () => sort(head, i));
text.oninput = outcome.onchange = filter;
document.querySelector("form").onsubmit = event => event.preventDefault();
document.querySelector("form").hidden = false;
filter();
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out;
}

/// A path as the target of a link.
std::string link_target(const std::string& path) {
  std::string out;
  for (const char c : path) {
    const auto u = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(u) || c == '/' || c == '.' || c == '-' || c == '_';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", u);
  }
  return out;
}

std::string link(const PanelState& state, const std::string& file, const std::string& label) {
  for (const std::string& one : state.files)
    if (one == file)
      return fmt::format("<a href=\"{}\">{}</a> ", link_target("panels/" + state.name + "/" + file),
                         escaped(label));
  return "";
}

/// Deck, table and log; the report has a column of its own.
std::string links_of(const PanelState& state) {
  std::string out;
  for (const std::string& file : state.files) {
    if (file == "log.txt" || file == state.name + ".html" || file == state.name + ".svg") continue;
    out += link(state, file, file.substr(std::min(file.size(), state.name.size() + 1)));
  }
  return out + link(state, "log.txt", "log");
}

std::string report_of(const PanelState& state) {
  const std::string html = link(state, state.name + ".html", state.name);
  if (!html.empty()) return html;
  const std::string svg = link(state, state.name + ".svg", state.name);
  return svg.empty() ? escaped(state.name) : svg;
}

std::string figure_cells(const PanelState& state) {
  if (!has_results(state.outcome)) {
    std::string empty;
    for (int i = 0; i < 9; ++i) empty += "<td class=n></td>";
    return empty;
  }
  const PanelFigures& f = state.figures;
  std::string cells;
  for (const int n : {f.I, f.generic, f.annular, f.fallbacks, f.quads, f.trias})
    cells += fmt::format("<td class=n>{}</td>", n);
  return cells + fmt::format("<td class=n>{:.3f}</td><td class=n>{:.3f}</td><td class=n>{}</td>",
                             f.scaled_jacobian_min, f.edge_min, f.edges_below_min);
}

std::string row_of(const PanelState& state) {
  const char* group = state.outcome == Outcome::done         ? ""
                      : state.outcome == Outcome::fell_short ? " class=short"
                                                             : " class=bad";
  return fmt::format(
      "<tr{}><td>{}</td><td><span class=o>{}</span></td>{}<td class=m>{}</td><td>{}</td></tr>\n", group,
      report_of(state), name_of(state.outcome), figure_cells(state), escaped(state.message), links_of(state));
}

std::string totals_list(const BatchTotals& t) {
  std::string out = "<ul class=totals>";
  const auto add = [&](int number, const char* what) {
    out += fmt::format("<li><b>{}</b>{}</li>", number, what);
  };
  add(t.panels, "panels"), add(t.done, "done"), add(t.fell_short, "fell short"), add(t.failed, "failed");
  if (t.not_run) add(t.not_run, "not run");
  add(t.figures.I, "I-beads"), add(t.figures.generic, "generic beads"),
      add(t.figures.annular, "annular beads");
  add(t.figures.fallbacks, "by the fall-back"), add(t.figures.quads, "quads"),
      add(t.figures.trias, "triangles");
  add(t.figures.edges_below_min, "edges below the minimum");
  return out + "</ul>\n";
}

std::string head_row() {
  std::string out = "<tr>";
  for (const auto& [name, numeric] :
       {std::pair{"panel", 0}, std::pair{"outcome", 0}, std::pair{"I", 1}, std::pair{"generic", 1},
        std::pair{"annular", 1}, std::pair{"fall-backs", 1}, std::pair{"quads", 1}, std::pair{"triangles", 1},
        std::pair{"scaled Jacobian", 1}, std::pair{"shortest edge", 1}, std::pair{"below minimum", 1},
        std::pair{"why", 0}, std::pair{"files", 0}})
    out += fmt::format("<th scope=col data-numeric={}><button type=button>{}</button></th>", numeric, name);
  return out + "</tr>";
}

}  // namespace

std::string batch_html(const std::vector<PanelState>& states, const std::string& title) {
  std::string rows;
  for (const PanelState& state : states) rows += row_of(state);
  return fmt::format(
      "<!doctype html>\n<html lang=en><meta charset=utf-8>\n"
      "<meta name=viewport content=\"width=device-width, initial-scale=1\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n<h1>{0}</h1>\n{2}"
      "<form hidden><label>Find <input id=text type=search></label> "
      "<label>Outcome <select id=outcome><option value=\"\">all</option><option value=done>done</option>"
      "<option value=short>fell short</option><option value=bad>failed or not run</option></select></label> "
      "<output id=count></output></form>\n"
      "<table><thead>{3}</thead><tbody>\n{4}</tbody></table>\n<script>{5}</script>\n</html>\n",
      escaped(title), style, totals_list(totals_of(states)), head_row(), rows, script);
}

}  // namespace beadmesh::app
