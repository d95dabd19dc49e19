// The picture: renderer, layers, what is marked, what lies under the pointer. Draws only when something has changed.
import {Color, ColorManagement, LinearSRGBColorSpace, Scene, WebGLRenderer, WebGLRenderTarget} from "three";
import {CameraRig} from "./camera_rig.js";
import {LineLayer, segmentsOf} from "./line_layer.js";
import {MeshLayer} from "./mesh_layer.js";
import {Overlay} from "./overlay.js";
import {css, kinds, ramps, rgb} from "./palette.js";
import {SurfaceLayer} from "./surface_layer.js";

ColorManagement.enabled = false;

/** Kinds of block lines as the program numbers them. */
const blockKinds = {boundary: 0, split: 1, crest: 2, inner: 3};

/** More elements than these are seen without an outline. */
const mostOutlined = 5000;

export const themes = {
  light: {ground: "#f7f8fa", edge: "#3c4654", crest: "#12161c", axisCase: "#ffffff", split: "#8a1c00", inner: "#8a1c00",
          block: "#5b2a86", chosen: "#d1006c", ink: "#1b2430", halo: "#ffffff"},
  dark: {ground: "#171b21", edge: "#0e1116", crest: "#ffffff", axisCase: "#0e1116", split: "#ffe0c2", inner: "#ffe0c2",
         block: "#c9a2f2", chosen: "#ff6bb5", ink: "#e8edf3", halo: "#12161b"},
};

export class Stage {
  /** @param scene of scene_data.js @param {HTMLElement} host holds the canvases @param drawable canvas and its context */
  constructor(scene, host, {canvas, context}) {
    this.scene = scene;
    this.host = host;
    this.canvas = canvas;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label", "The panel in 3-D. Arrow keys turn it, shift and arrow keys move it, plus and " +
        "minus zoom, f shows all, question mark lists all keys.");
    host.append(this.canvas);
    this.renderer = new WebGLRenderer({canvas, context, antialias: true});
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.world = new Scene();
    this.pickWorld = new Scene();
    this.pickTarget = new WebGLRenderTarget(1, 1);
    this.radius = this.#radius();
    this.hasMesh = scene.mesh.count > 0;
    this.visible = {surface: !this.hasMesh, mesh: this.hasMesh, edges: true, crests: true, axes: false, splits: false,
                    blocks: false, labels: true, patterns: false};
    this.uniforms = {ground: {value: new Color()}, edgeColor: {value: new Color()}, patterns: {value: 0},
                     edges: {value: 0.85}, pixelRatio: {value: 1}};
    this.overlay = new Overlay(host);
    this.rig = new CameraRig(this.canvas, this.radius, () => this.draw());
    this.chosen = null;
    this.kept = null;
    this.#build();
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
    this.onDrawn = null;
  }

  #radius() {
    let most = 0;
    for (const points of [this.scene.mesh.nodes, this.scene.surface.points])
      for (let i = 0; i + 2 < points.length; i += 3)
        most = Math.max(most, points[i] ** 2 + points[i + 1] ** 2 + points[i + 2] ** 2);
    return Math.sqrt(most) || 1;
  }

  #build() {
    const {scene, world, pickWorld} = this;
    this.mesh = new MeshLayer(scene.mesh, this.uniforms);
    this.surface = new SurfaceLayer(scene.surface, this.uniforms);
    for (const layer of [this.mesh, this.surface]) world.add(layer.object), pickWorld.add(layer.pickable);
    this.lines = {
      crests: new LineLayer(segmentsOf(scene.crests), {width: 2, order: 4, forward: 1.4}),
      axes: new LineLayer(segmentsOf(scene.axes), {width: 3.2, order: 6, forward: 1.7, color: "#ffffff", colors: []}),
      axisCase: new LineLayer(segmentsOf(scene.axes), {width: 5.2, order: 5, forward: 1.6}),
      splits: new LineLayer(segmentsOf(scene.blocks, (l) => scene.blocks.kinds[l] === blockKinds.split),
                            {width: 2.4, order: 3, forward: 1.2}),
      inner: new LineLayer(segmentsOf(scene.blocks, (l) => scene.blocks.kinds[l] === blockKinds.inner),
                           {width: 2, order: 3, forward: 1.2, dash: this.#elementSize() * 0.5}),
      blocks: new LineLayer(segmentsOf(scene.blocks), {width: 1.6, order: 2, forward: 1.1}),
      chosen: new LineLayer([], {width: 4, order: 8, forward: 2.2}),
      kept: new LineLayer([], {width: 3, order: 7, forward: 1.8}),
      hovered: new LineLayer([], {width: 2.4, order: 7, forward: 2}),
    };
    for (const line of Object.values(this.lines)) world.add(line.object);
    this.hasAxes = !this.lines.axes.isEmpty;
    this.#colorAxes();
  }

  /** Mean side of the elements, mm. */
  #elementSize() {
    const {count, corners, nodes} = this.scene.mesh;
    if (!count) return this.radius / 100;
    let sum = 0, taken = 0;
    for (let e = 0; e < count; e += Math.ceil(count / 2000), ++taken) {
      const a = 3 * corners[4 * e], b = 3 * corners[4 * e + 1];
      sum += Math.hypot(nodes[a] - nodes[b], nodes[a + 1] - nodes[b + 1], nodes[a + 2] - nodes[b + 2]);
    }
    return sum / taken;
  }

  #colorAxes() {
    const {start, thickness} = this.scene.axes, colors = [];
    let low = Infinity, high = 0;
    for (const value of thickness) low = Math.min(low, value), high = Math.max(high, value);
    this.thicknessRange = thickness.length ? [low, high] : null;
    const scale = high > low ? 1 / (high - low) : 0;
    const put = (p) => {
      const i = 3 * Math.round((thickness[p] - low) * scale * 255);
      colors.push(ramps.viridis[i] / 255, ramps.viridis[i + 1] / 255, ramps.viridis[i + 2] / 255);
    };
    for (let l = 0; l + 1 < start.length; ++l)
      for (let p = start[l]; p + 1 < start[l + 1]; ++p) put(p), put(p + 1);
    if (this.hasAxes) this.lines.axes.object.geometry.setColors(colors);
  }

  setTheme(name) {
    const theme = this.theme = themes[name];
    this.themeName = name;
    this.renderer.setClearColor(theme.ground);
    this.uniforms.ground.value.set(theme.ground);
    this.uniforms.edgeColor.value.set(theme.edge);
    Object.assign(this.lines.crests, {color: theme.crest});
    Object.assign(this.lines.axisCase, {color: theme.axisCase});
    Object.assign(this.lines.splits, {color: theme.split});
    Object.assign(this.lines.inner, {color: theme.inner});
    Object.assign(this.lines.blocks, {color: theme.block});
    Object.assign(this.lines.chosen, {color: theme.chosen});
    Object.assign(this.lines.kept, {color: theme.chosen});
    Object.assign(this.lines.hovered, {color: theme.ink});
    this.repaint();
  }

  // ------------------------------------------------------------------ colours

  /** @param {{measure: object, low: number, high: number, ramp: string, flip: boolean} | null} coloring null: by kind */
  setColoring(coloring) {
    this.coloring = coloring;
    this.repaint();
  }

  kindOfBead(id) { return kinds[this.scene.beadById.get(id)?.kind] ?? kinds.sheet; }

  repaint() {
    const {scene, coloring} = this, tone = this.themeName ?? "light";
    const kindOf = (e) => this.kindOfBead(scene.mesh.bead[e]);
    const colorOfKind = Object.fromEntries(Object.values(kinds).map((kind) => [kind.code, rgb(kind[tone])]));
    const none = rgb(kinds.sheet[tone]);
    let colorOf = (e) => colorOfKind[kindOf(e).code];
    if (coloring) {
      const {measure: {values}, low, high, ramp, flip} = coloring, table = ramps[ramp];
      const out = [0, 0, 0];
      colorOf = (e) => {
        if (Number.isNaN(values[e])) return none;
        let t = high > low ? Math.min(1, Math.max(0, (values[e] - low) / (high - low))) : 0.5;
        if (flip) t = 1 - t;
        const i = 3 * Math.round(t * 255);
        out[0] = table[i], out[1] = table[i + 1], out[2] = table[i + 2];
        return out;
      };
    }
    this.mesh.paint(colorOf, (e) => (coloring ? 0 : kindOf(e).code));
    this.#paintSurface(colorOfKind);
    this.draw();
  }

  #paintSurface(colorOfKind) {
    const {faces} = this.scene, kindOf = (f) => this.kindOfBead(faces[f].bead).code, chosen = this.chosen;
    if (colorOfKind) this.colorOfKind = colorOfKind;
    this.surface.paint((f) => this.colorOfKind[kindOf(f)], kindOf, null,
                       chosen && ((f) => (chosen.bead ? faces[f].bead === chosen.bead : f === chosen.face)));
  }

  // ------------------------------------------------------------------ marks

  /** Elements for which `isKept` is false step back, the others are outlined; null: none steps back. */
  keep(isKept) {
    this.kept = isKept;
    const elements = [];
    for (let e = 0; isKept && e < this.scene.mesh.count && elements.length <= mostOutlined; ++e)
      if (isKept(e)) elements.push(e);
    this.lines.kept.set(elements.length <= mostOutlined ? this.mesh.outlineOf(elements) : []);
    this.#mark();
  }

  /**
   * What stands out, and nothing else: a bead by its id, a face by its index, an element by its index.
   * @param {{bead?: number, face?: number, element?: number} | null} what
   */
  choose(what) {
    this.chosen = what;
    this.lines.chosen.set(what ? this.#outline(what) : []);
    this.#mark();
    this.#paintSurface();
  }

  #mark() {
    const {mesh} = this.scene, {chosen} = this;
    const isChosen = chosen?.bead ? (e) => mesh.bead[e] === chosen.bead : null;
    this.mesh.mark(this.kept, isChosen);
    this.draw();
  }

  hover(what) {
    const key = JSON.stringify(what);
    if (key === this.hoverKey) return;
    this.hoverKey = key;
    this.lines.hovered.set(what ? this.#outline(what) : []);
    this.draw();
  }

  facesOf({bead, face}) {
    return this.scene.faces.flatMap((f, index) => ((bead ? f.bead === bead : index === face) ? [index] : []));
  }

  elementsOf(what) {
    if (what.element !== undefined) return [what.element];
    const {mesh, faces} = this.scene, out = [];
    const numbers = what.face === undefined ? null : new Set(faces[what.face].numbers);
    for (let e = 0; e < mesh.count; ++e)
      if (numbers ? numbers.has(mesh.face[e]) : mesh.bead[e] === what.bead) out.push(e);
    return out;
  }

  #outline(what) {
    const elements = this.elementsOf(what);
    if (elements.length) return this.mesh.outlineOf(elements);
    return this.facesOf(what).flatMap((f) => this.surface.outlineOf(f));
  }

  pointsOf(what) {
    const elements = this.elementsOf(what);
    if (elements.length) return this.mesh.pointsOf(elements);
    return Float32Array.from(this.facesOf(what).flatMap((f) => [...this.surface.pointsOf(f)]));
  }

  goTo(what) {
    const points = this.pointsOf(what), least = what.element === undefined ? 0 : 14 * this.#elementSize();
    if (points.length) this.rig.fit(points, {room: 0.7, least, covered: this.covered?.() ?? 0});
  }

  fit(angles = {}) {
    this.rig.fit(this.#allPoints, {room: 0.9, ...angles});
  }

  /** Angles that look along the mean normal of the panel, and a little aslant. */
  panelAngles(aslant) {
    const n = this.#meanNormal(), size = Math.hypot(...n);
    if (size < 0.05) return {azimuth: -0.9, elevation: 0.65};
    let e = n.map((value) => value / size);
    const largest = e.reduce((a, b) => (Math.abs(b) > Math.abs(a) + 1e-6 ? b : a));
    if (largest < 0) e = e.map((value) => -value);
    const steep = Math.abs(e[2]) > 0.8;
    let azimuth = steep ? -Math.PI / 2 : Math.atan2(e[1], e[0]), elevation = steep ? Math.PI / 2 * Math.sign(e[2]) : Math.asin(e[2]);
    if (aslant) azimuth += 0.3, elevation -= elevation > 0.6 ? 0.6 : -0.45;
    // Seen from above any side may be down: the long one then lies across the picture.
    if (steep && this.#heightAt(azimuth + Math.PI / 2, elevation) < 0.9 * this.#heightAt(azimuth, elevation))
      azimuth += Math.PI / 2;
    return {azimuth, elevation};
  }

  get #allPoints() { return this.hasMesh ? this.scene.mesh.nodes : this.scene.surface.points; }

  #heightAt(azimuth, elevation) { return this.rig.heightFor(this.#allPoints, azimuth, elevation); }

  /** Sum of the area vectors over the sum of the areas. */
  #meanNormal() {
    const {nodes, corners, count} = this.scene.mesh, {points} = this.scene.surface;
    const list = this.hasMesh ? nodes : points;
    const index = this.hasMesh ? corners : this.surface.geometry.index.array;
    const stride = this.hasMesh ? 4 : 3, total = this.hasMesh ? count : index.length / 3;
    const sum = [0, 0, 0];
    let area = 0;
    for (let t = 0; t < total; ++t) {
      const [a, b, c] = [0, 1, 2].map((k) => 3 * index[stride * t + k]);
      const u = [0, 1, 2].map((k) => list[b + k] - list[a + k]), v = [0, 1, 2].map((k) => list[c + k] - list[a + k]);
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      for (let k = 0; k < 3; ++k) sum[k] += n[k];
      area += Math.hypot(...n);
    }
    return sum.map((value) => value / (area || 1));
  }

  // ------------------------------------------------------------------ drawing

  setVisible(layer, on) {
    this.visible[layer] = on;
    this.draw();
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.host;
    if (!width || !height) return;
    const ratio = Math.min(devicePixelRatio || 1, 2);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.uniforms.pixelRatio.value = ratio;
    this.overlay.resize(width, height, ratio);
    this.rig.resize(width, height);
  }

  draw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.drawNow();
    });
  }

  drawNow() {
    if (!this.theme) return;
    const {visible, lines, renderer, rig} = this;
    this.mesh.object.visible = visible.mesh && this.hasMesh;
    this.surface.object.visible = visible.surface && !this.mesh.object.visible;
    this.mesh.pickable.visible = this.mesh.object.visible;
    this.surface.pickable.visible = this.surface.object.visible;
    this.uniforms.edges.value = visible.edges ? (this.coloring ? 0.5 : 0.62) : 0;
    this.uniforms.patterns.value = visible.patterns && !this.coloring ? 1 : 0;
    lines.crests.show(visible.crests);
    lines.axes.show(visible.axes), lines.axisCase.show(visible.axes);
    lines.splits.show(visible.splits), lines.inner.show(visible.splits);
    lines.blocks.show(visible.blocks);
    lines.kept.show(visible.mesh);
    const lift = Math.min(0.3 * this.#lift(), 40 * rig.pixel);
    for (const line of Object.values(lines)) line.adapt(rig.width, rig.heightInPixels, rig.camera.far, lift);
    renderer.render(this.world, rig.camera);
    this.overlay.draw(this);
    this.frames = (this.frames ?? 0) + 1;
    this.onDrawn?.();
  }

  #lift() { return this.lift ??= this.#elementSize(); }

  /** What lies under a pixel: {element} or {face}, null for nothing. */
  pick(x, y) {
    const {renderer, rig, pickTarget} = this, {camera} = rig;
    camera.setViewOffset(rig.width, rig.heightInPixels, Math.floor(x), Math.floor(y), 1, 1);
    camera.updateProjectionMatrix();
    renderer.setRenderTarget(pickTarget);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(this.pickWorld, camera);
    const bytes = new Uint8Array(4);
    renderer.readRenderTargetPixels(pickTarget, 0, 0, 1, 1, bytes);
    renderer.setRenderTarget(null);
    renderer.setClearColor(this.theme.ground, 1);
    camera.clearViewOffset();
    const number = bytes[0] + 256 * bytes[1] + 65536 * bytes[2] - 1;
    return bytes[3] === 1 ? {element: number} : bytes[3] === 2 ? {face: number} : null;
  }

  /** A PNG of what is seen, labels included. */
  picture() {
    this.drawNow();
    const copy = document.createElement("canvas");
    copy.width = this.canvas.width, copy.height = this.canvas.height;
    const context = copy.getContext("2d");
    context.drawImage(this.canvas, 0, 0);
    context.drawImage(this.overlay.canvas, 0, 0);
    return copy.toDataURL("image/png");
  }
}

export {css};
