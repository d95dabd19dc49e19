// The report comes alive: reads its data, builds the picture and the tools around it, ties tables and picture together.
import {views} from "./camera_rig.js";
import {Coloring} from "./coloring.js";
import {Details} from "./details.js";
import {make} from "./dom.js";
import {showFlatPicture} from "./flat_picture.js";
import {makeHelp} from "./help.js";
import {Layers, layers} from "./layers.js";
import {readScene} from "./scene_data.js";
import {Stage} from "./stage.js";
import {Tables} from "./tables.js";

const stageHost = document.getElementById("stage"), tablesHost = document.getElementById("tables");

/** A canvas with a context to draw in; null where the browser has none. */
function drawableCanvas() {
  const canvas = document.createElement("canvas");
  try {
    const context = canvas.getContext("webgl2", {antialias: true, powerPreference: "high-performance"});
    return context && {canvas, context};
  } catch {
    return null;
  }
}

class Report {
  async start() {
    document.body.classList.add("live");
    stageHost.replaceChildren();
    this.#theme();
    this.tables = new Tables(tablesHost, {go: (subject) => this.choose(this.#known(subject), {zoom: true}),
                                          point: (subject) => this.stage?.hover(subject && this.#known(subject))});
    this.help = makeHelp();
    this.#divider();
    const drawable = drawableCanvas();
    if (!drawable) {
      document.body.classList.add("flat-only");
      await showFlatPicture(stageHost, "this browser has no WebGL 2");
    } else {
      await this.#picture(drawable);
    }
    addEventListener("keydown", (event) => this.#key(event));
    document.documentElement.dataset.ready = "true";
    dispatchEvent(new Event("beadmesh-ready"));
  }

  async #picture(drawable) {
    const scene = await readScene(JSON.parse(document.getElementById("scene").textContent));
    this.view = make("div", {class: "view"});
    const sidebar = make("div", {class: "sidebar"});
    stageHost.append(sidebar, this.view);
    const stage = this.stage = new Stage(scene, this.view, drawable);
    this.details = new Details(stage, this.view, () => this.choose(null));
    stage.covered = () => this.details.covers;
    this.coloring = new Coloring(stage);
    this.layers = new Layers(stage, () => document.body.classList.toggle("patterned", stage.visible.patterns));
    sidebar.append(this.layers.element, this.coloring.element);
    this.view.append(this.#toolbar());
    this.#applyTheme();
    stage.fit({...stage.panelAngles(true), instantly: true});
    this.#pointer();
    this.#printing();
  }

  // ------------------------------------------------------------------ choosing

  /** From the file's face number to the index; null where the picture does not know it. */
  #known(subject) {
    if (!this.stage || !subject) return null;
    if (subject.number === undefined) return subject;
    const face = this.stage.scene.faceByNumber.get(subject.number);
    return face === undefined ? null : {face};
  }

  choose(what, {zoom = false, at = null} = {}) {
    if (!this.stage) return;
    this.chosen = what;
    this.stage.choose(what);
    this.details.showCard(what, at);
    const {faces} = this.stage.scene;
    this.tables.mark(!what ? null : what.bead ? `#beads tr[data-bead="${what.bead}"]`
        : what.element !== undefined ? `tr[data-element="${what.element}"]`
        : faces[what.face].numbers.map((n) => `#faces tr[data-face="${n}"]`).join(","), true);
    if (zoom && what) this.stage.goTo(what);
  }

  chooseNeighbour(step) {
    const {beads} = this.stage.scene;
    if (!beads.length) return;
    const at = beads.findIndex((bead) => bead.id === this.chosen?.bead);
    const next = at < 0 ? (step > 0 ? 0 : beads.length - 1) : (at + step + beads.length) % beads.length;
    this.choose({bead: beads[next].id}, {zoom: true});
  }

  #beadOf(what) {
    const {mesh, faces} = this.stage.scene;
    return what?.element !== undefined ? mesh.bead[what.element] : what ? faces[what.face].bead : 0;
  }

  #pointer() {
    const {canvas} = this.stage;
    let down = null, place = null, busy = false;
    const at = (event) => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      down = [event.clientX, event.clientY];
      this.details.showTip(null);
    });
    canvas.addEventListener("pointerup", (event) => {
      const still = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4 && event.button === 0;
      down = null;
      if (still) this.choose(this.stage.pick(...at(event)), {at: at(event)});
    });
    canvas.addEventListener("dblclick", (event) => {
      const bead = this.#beadOf(this.stage.pick(...at(event)));
      if (bead) this.choose({bead}, {zoom: true, at: at(event)});
    });
    // Where looking takes long (no graphics card, a large panel) it is done less often; the last place counts.
    const look = () => {
      if (busy || !place || down) return;
      busy = true;
      requestAnimationFrame(() => {
        const [x, y] = place ?? [], start = performance.now();
        place = null;
        if (x !== undefined && !down) this.details.showTip(this.stage.pick(x, y), x, y);
        setTimeout(() => {
          busy = false;
          look();
        }, Math.min(500, 4 * (performance.now() - start)));
      });
    };
    canvas.addEventListener("pointermove", (event) => {
      if (event.pointerType === "touch") return;
      place = at(event);
      look();
    });
    canvas.addEventListener("pointerleave", () => {
      place = null;
      this.details.showTip(null);
    });
  }

  // ------------------------------------------------------------------ tools

  #toolbar() {
    const button = (name, key, text, run) => make("button", {title: `${name} (${key})`, "aria-label": name, onclick: run}, text);
    const select = make("select", {"aria-label": "View", title: "View from", onchange: () => {
      this.look(select.value);
      select.value = "";
    }}, make("option", {value: ""}, "View"), ...Object.entries(views).map(([id, view]) => make("option", {value: id}, view.name)));
    return make("div", {class: "toolbar", role: "toolbar", "aria-label": "Picture"}, select,
                button("Show all", "F", "Fit", () => this.stage.fit()),
                button("Zoom in", "+", "+", () => this.stage.rig.zoom(0.7)),
                button("Zoom out", "−", "−", () => this.stage.rig.zoom(1 / 0.7)),
                make("button", {title: "Save the picture as PNG", onclick: () => this.#save()}, "Save"),
                button("Keys", "?", "?", () => this.help.showModal()));
  }

  look(id) {
    const view = views[id];
    const angles = id === "panel" ? this.stage.panelAngles(false) : {azimuth: view.azimuth, elevation: view.elevation};
    this.stage.fit(angles);
  }

  #save() {
    const name = document.title.replace(/[^\w.-]+/g, "_");
    make("a", {href: this.stage.picture(), download: `${name}.png`}).click();
  }

  #theme() {
    this.dark = matchMedia("(prefers-color-scheme: dark)");
    this.dark.addEventListener("change", () => this.#applyTheme());
    this.themeButton = make("button", {class: "theme", onclick: () => {
      document.documentElement.dataset.theme = this.themeName === "dark" ? "light" : "dark";
      this.#applyTheme();
    }});
    document.querySelector("header").append(this.themeButton);
    this.#applyTheme();
  }

  get themeName() { return document.documentElement.dataset.theme ?? (this.dark.matches ? "dark" : "light"); }

  #applyTheme() {
    const other = this.themeName === "dark" ? "Light" : "Dark";
    this.themeButton.textContent = other;
    this.themeButton.title = `${other} ground`;
    if (!this.stage) return;
    this.stage.setTheme(this.themeName);
    this.coloring.refresh();
  }

  /** The bar between picture and tables can be dragged, or moved by arrow keys. */
  #divider() {
    const divider = make("div", {class: "divider", role: "separator", tabindex: 0, "aria-orientation": "horizontal",
                                 "aria-label": "Height of the tables", "aria-valuenow": 34, "aria-valuemin": 8, "aria-valuemax": 85});
    const main = document.querySelector("main");
    tablesHost.before(divider);
    let share = 34;
    const set = (value) => {
      share = Math.min(85, Math.max(8, value));
      main.style.setProperty("--dock", `${share}%`);
      divider.setAttribute("aria-valuenow", String(Math.round(share)));
    };
    divider.addEventListener("pointerdown", (event) => divider.setPointerCapture(event.pointerId));
    divider.addEventListener("pointermove", (event) => {
      if (!divider.hasPointerCapture(event.pointerId)) return;
      const box = main.getBoundingClientRect();
      set((box.bottom - event.clientY) / box.height * 100);
    });
    divider.addEventListener("keydown", (event) => {
      const step = {ArrowUp: 4, ArrowDown: -4}[event.key];
      if (!step) return;
      event.preventDefault();
      set(share + step);
    });
  }

  /** On paper there is a still picture, light, and all tables. */
  #printing() {
    const picture = make("img", {alt: "The panel as it was seen"}), legend = make("figcaption");
    stageHost.before(make("figure", {class: "print-picture"}, picture, legend));
    let theme = null;
    const prepare = () => {
      if (theme) return;
      theme = this.themeName;
      this.stage.setTheme("light");
      legend.replaceChildren(...this.coloring.caption());
      picture.src = this.stage.picture();
    };
    addEventListener("beforeprint", prepare);
    addEventListener("afterprint", () => {
      if (theme) this.stage.setTheme(theme);
      theme = null;
    });
    this.preparePrint = prepare;
  }

  // ------------------------------------------------------------------ keys

  #key(event) {
    const typing = event.target.closest?.("input:not([type=checkbox]), select, textarea, dialog");
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape" && !this.help.open) {
      if (!typing) return this.choose(null);
      if (event.target.type === "search") this.tables.clearFilter();
      return event.target.blur();
    }
    if (typing) return;
    if (event.key === "?") return this.help.showModal();
    if (event.key === "/") {
      event.preventDefault();
      return this.tables.focusFilter();
    }
    if (!this.stage) return;
    const key = event.key.toLowerCase();
    const layer = layers.find((l) => l.key === key), view = Object.keys(views).find((id) => views[id].key === key);
    if (layer) this.layers.toggle(layer.id);
    else if (view) this.look(view);
    else if (key === "f") this.stage.fit();
    else if (key === "z" && this.chosen) this.stage.goTo(this.chosen);
    else if (key === "]") this.chooseNeighbour(1);
    else if (key === "[") this.chooseNeighbour(-1);
  }
}

const report = new Report();
report.start().catch((error) => {
  console.error(error);
  document.body.classList.add("flat-only");
  stageHost.replaceChildren();
  showFlatPicture(stageHost, `the 3-D view failed (${error.message})`);
});
// For those who want to look further from the browser's console, and for the tests.
window.beadmesh = report;
