// The list of layers: what is drawn.
import {make, short} from "./dom.js";
import {css, ramps} from "./palette.js";

/** Name, what it is, key; `has` says whether there is anything to show. */
export const layers = [
  {id: "mesh", name: "Mesh", key: "m", meaning: "the elements", has: (stage) => stage.hasMesh},
  {id: "edges", name: "Element edges", key: "e", meaning: "lines around the elements", has: (stage) => stage.hasMesh},
  {id: "surface", name: "CAD surface", key: "s", meaning: "the faces as they were read; seen where the mesh is off",
   has: (stage) => stage.scene.surface.triangles.length > 0},
  {id: "crests", name: "Crest lines", key: "c", meaning: "ridges of the beads, where the mesh has its nodes", swatch: "crest",
   has: (stage) => !stage.lines.crests.isEmpty},
  {id: "axes", name: "Medial axes", key: "a", meaning: "centres of the inscribed circles, coloured by thickness",
   swatch: "axis", has: (stage) => stage.hasAxes},
  {id: "splits", name: "Split lines", key: "p", meaning: "cuts across the beads, and (dashed) lines inside clamps and hubs", swatch: "split",
   has: (stage) => !stage.lines.splits.isEmpty || !stage.lines.inner.isEmpty},
  {id: "blocks", name: "Blocks", key: "b", meaning: "outlines of the four-sided blocks", swatch: "block",
   has: (stage) => !stage.lines.blocks.isEmpty},
  {id: "labels", name: "Labels", key: "l", meaning: "number and shape of the beads", has: (stage) => stage.scene.beads.length > 0},
  {id: "patterns", name: "Patterns", key: "t", meaning: "hatching that tells the kinds without colour",
   has: (stage) => stage.scene.beads.length > 0},
];

export class Layers {
  constructor(stage, changed) {
    this.stage = stage;
    this.changed = changed;
    this.boxes = new Map();
    const rows = layers.map((layer) => this.#row(layer)).filter(Boolean);
    this.scale = make("div", {class: "thickness", hidden: true});
    this.element = make("section", {class: "group"}, make("h2", {}, "Layers"), make("ul", {class: "layers"}, ...rows), this.scale);
    this.#thicknessScale();
  }

  #row(layer) {
    const {stage} = this;
    if (!layer.has(stage)) return null;
    const box = make("input", {type: "checkbox", id: `layer-${layer.id}`,
                               onchange: () => this.set(layer.id, box.checked)});
    box.checked = stage.visible[layer.id];
    this.boxes.set(layer.id, box);
    return make("li", {title: layer.meaning}, make("label", {}, box, make("span", {}, layer.name),
                layer.swatch ? make("i", {class: `line-swatch ${layer.swatch}`}) : null,
                make("kbd", {"aria-hidden": "true"}, layer.key.toUpperCase())));
  }

  set(id, on) {
    const box = this.boxes.get(id);
    if (!box) return;
    box.checked = on;
    this.stage.setVisible(id, on);
    // One of the two is seen: the surface lies under the mesh.
    if (id === "surface" && on && this.boxes.has("mesh")) this.set("mesh", false);
    if (id === "mesh" && on && this.boxes.has("surface")) this.set("surface", false);
    this.scale.hidden = !this.stage.visible.axes;
    this.changed(id);
  }

  toggle(id) { this.set(id, !this.stage.visible[id]); }

  #thicknessScale() {
    const range = this.stage.thicknessRange;
    if (!range) return;
    const stops = Array.from({length: 9}, (_, i) => css(ramps.viridis, i / 8));
    this.scale.append(make("span", {class: "quiet"}, "Thickness of the medial axes, mm"),
                      make("div", {class: "ramp", style: `background:linear-gradient(to right,${stops.join(",")})`}),
                      make("div", {class: "ends"}, make("span", {}, short(range[0])), make("span", {}, short(range[1]))));
  }
}
