// Colour of the mesh: by kind of bead or by a measure, with range, palette, legend and histogram.
import {grouped, make, makeSvg, short} from "./dom.js";
import {css, kinds, ramps} from "./palette.js";

const bins = 24;

/** Share of the elements that may lie beyond either end of the colours. */
const tail = 0.001;

/** Range that holds nearly all values, and the limit where there is one. */
export function usualRange(measure) {
  const values = measure.values.filter((value) => !Number.isNaN(value)).sort();
  let low = values[Math.floor(tail * (values.length - 1))], high = values[Math.ceil((1 - tail) * (values.length - 1))];
  const span = high - low;
  // A far outlier must not press all others into one colour; a near one may as well be shown.
  if (measure.low > low - 0.5 * span) low = measure.low;
  if (measure.high < high + 0.5 * span) high = measure.high;
  if (measure.name === "scaled Jacobian" || measure.name === "jacobian") high = Math.max(high, 1), low = Math.min(low, 0.6);
  if (!(high > low)) high = low + 1e-6;
  return {low, high};
}

export function histogramOf(measure, low, high) {
  const counts = new Array(bins).fill(0), binOf = new Int8Array(measure.values.length).fill(-1);
  for (let e = 0; e < measure.values.length; ++e) {
    const value = measure.values[e];
    if (Number.isNaN(value)) continue;
    const bin = Math.min(bins - 1, Math.max(0, Math.floor((value - low) / (high - low) * bins)));
    ++counts[bin];
    binOf[e] = bin;
  }
  return {counts, binOf};
}

export class Coloring {
  /** @param {import("./stage.js").Stage} stage */
  constructor(stage) {
    this.stage = stage;
    this.measures = stage.scene.mesh.measures;
    this.ramp = "viridis";
    this.measure = null;
    this.legend = make("div", {class: "legend"});
    this.select = make("select", {id: "measure", onchange: () => this.show(this.select.value)},
                       make("option", {value: ""}, "Kind of bead"),
                       ...(this.measures.length ? [make("optgroup", {label: "Quality of elements"},
                            ...this.measures.map((m) => make("option", {value: m.name}, m.name)))] : []));
    this.element = make("section", {class: "group"}, make("h2", {}, "Colour"),
                        make("label", {class: "field", for: "measure"}, make("span", {class: "quiet"}, "Mesh by"), this.select),
                        this.legend);
    this.show("");
  }

  /** By the name of a measure, or by kind: "". */
  show(name) {
    this.select.value = name;
    this.measure = this.measures.find((m) => m.name === name) ?? null;
    this.range = this.measure && usualRange(this.measure);
    this.bin = null;
    this.#apply();
  }

  setRamp(name) {
    this.ramp = name;
    this.#apply();
  }

  refresh() { this.#apply(); }

  #apply() {
    const {stage, measure, range} = this;
    stage.keep(null);
    stage.setColoring(measure && {measure, ...range, ramp: this.ramp, flip: !measure.large_is_bad});
    this.legend.replaceChildren(...(measure ? this.#measureLegend() : this.#kindLegend()));
  }

  #kindLegend() {
    const present = new Set(this.stage.scene.beads.map((bead) => bead.kind)), tone = this.stage.themeName ?? "light";
    const rows = Object.entries(kinds).filter(([key]) => key === "sheet" || present.has(key)).map(([key, kind]) => {
      const count = this.stage.scene.beads.filter((bead) => bead.kind === key).length;
      return make("li", {}, make("i", {class: `swatch pattern-${kind.code}`, style: `--swatch:${kind[tone]}`}),
                  make("span", {}, kind.name), make("span", {class: "quiet number"}, key === "sheet" ? "" : String(count)));
    });
    return [make("ul", {class: "kinds"}, ...rows)];
  }

  /** The legend for paper: without controls. */
  caption() {
    if (!this.measure) return this.#kindLegend();
    const name = make("span", {}, this.measure.name + (this.measure.unit && `, ${this.measure.unit}`));
    return [name, ...[...this.legend.querySelectorAll(".ramp, .ends")].map((part) => part.cloneNode(true))];
  }

  #t(value) {
    const t = (value - this.range.low) / (this.range.high - this.range.low);
    return this.measure.large_is_bad ? t : 1 - t;
  }

  #measureLegend() {
    const {measure, range, ramp} = this, table = ramps[ramp];
    const {counts, binOf} = histogramOf(measure, range.low, range.high);
    this.binOf = binOf;
    const unit = measure.unit ? ` ${measure.unit}` : "";
    const stops = Array.from({length: 13}, (_, i) => css(table, this.#t(range.low + i / 12 * (range.high - range.low))));
    const end = (value, beyond, sign) => `${beyond ? sign : ""}${short(value)}`;
    const failing = measure.failing.length;
    const parts = [
      make("p", {class: "meaning"}, measure.meaning + (unit ? `, in ${measure.unit}` : "")),
      this.#histogram(counts),
      make("div", {class: "ramp", style: `background:linear-gradient(to right,${stops.join(",")})`}),
      make("div", {class: "ends"}, make("span", {}, end(range.low, measure.low < range.low, "≤ ")),
           make("span", {}, end(range.high, measure.high > range.high, "≥ "))),
      make("div", {class: "range"},
           make("label", {}, "from ", this.#rangeInput("low")), make("label", {}, "to ", this.#rangeInput("high")),
           make("button", {class: "small", title: "Range and palette as at first", onclick: () => {
             this.ramp = "viridis";
             this.show(measure.name);
           }}, "Reset")),
      make("label", {class: "field"}, make("span", {class: "quiet"}, "Palette"),
           make("select", {onchange: (event) => this.setRamp(event.target.value)},
                ...Object.keys(ramps).map((name) => make("option", {value: name, selected: name === ramp}, name)))),
    ];
    const beyond = `${measure.large_is_bad ? "over" : "under"} ${short(measure.limit)}${unit}`;
    if (measure.limit !== null)
      parts.push(make("p", {class: failing ? "verdict fails" : "verdict passes"},
          failing ? `✗ ${grouped(failing)} ${beyond}` : `✓ none ${beyond}`,
          failing ? make("button", {class: "small", "aria-pressed": "false", onclick: (event) => this.#toggleFailing(event.target)}, "Show") : null));
    return parts;
  }

  #rangeInput(end) {
    return make("input", {type: "number", step: "any", value: Number(short(this.range[end]).replaceAll(",", "")), onchange: (event) => {
      const wanted = {...this.range, [end]: Number(event.target.value)};
      if (Number.isFinite(wanted.low) && wanted.high > wanted.low) this.range = wanted;
      this.bin = null;
      this.#apply();
    }});
  }

  #binName(bin, count) {
    const {low, high} = this.range, at = (k) => short(low + k / bins * (high - low));
    return `${at(bin)} to ${at(bin + 1)}: ${grouped(count)} element${count === 1 ? "" : "s"}`;
  }

  /** Heights by square root: few bad elements beside many good ones stay to be seen. */
  #histogram(counts) {
    const width = 216, height = 64, most = Math.max(1, ...counts), table = ramps[this.ramp];
    const bars = counts.map((count, bin) => {
      const h = count ? Math.max(2, Math.sqrt(count / most) * (height - 4)) : 0, w = width / bins;
      const name = this.#binName(bin, count), t = this.#t(this.range.low + (bin + 0.5) / bins * (this.range.high - this.range.low));
      return makeSvg("g", {class: "bin", tabindex: count ? 0 : -1, role: "button", "aria-pressed": String(bin === this.bin),
                           "aria-label": name, onclick: () => this.#toggleBin(bin),
                           onkeydown: (event) => {
                             if (event.key !== "Enter" && event.key !== " ") return;
                             event.preventDefault();
                             this.#toggleBin(bin);
                           }},
                     makeSvg("title", {}, name),
                     makeSvg("rect", {class: "room", x: bin * w, y: 0, width: w, height}),
                     makeSvg("rect", {class: "bar", x: bin * w + 0.5, y: height - h, width: w - 1, height: h,
                                      fill: css(table, t)}));
    });
    const {limit} = this.measure, at = (limit - this.range.low) / (this.range.high - this.range.low) * width;
    const line = limit !== null && at >= 0 && at <= width
        ? [makeSvg("line", {class: "limit", x1: at, x2: at, y1: 0, y2: height}, makeSvg("title", {}, `limit ${short(limit)}`))] : [];
    this.chart = makeSvg("svg", {class: "histogram", viewBox: `0 0 ${width} ${height}`, role: "group",
                                 "aria-label": `Histogram of ${this.measure.name}; heights by square root`}, ...bars, ...line);
    return this.chart;
  }

  #toggleBin(bin) {
    this.bin = this.bin === bin ? null : bin;
    [...this.chart.querySelectorAll(".bin")].forEach((bar, k) => bar.setAttribute("aria-pressed", String(k === this.bin)));
    this.chart.classList.toggle("picked", this.bin !== null);
    this.stage.keep(this.bin === null ? null : (e) => this.binOf[e] === this.bin);
  }

  #toggleFailing(button) {
    const on = button.getAttribute("aria-pressed") !== "true", failing = new Set(this.measure.failing);
    button.setAttribute("aria-pressed", String(on));
    this.stage.keep(on ? (e) => failing.has(e) : null);
  }
}
