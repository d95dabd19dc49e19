// Looks at the panel: a parallel projection that turns about the vertical, moves and zooms; all of it by mouse, touch and
// keyboard.
import {OrthographicCamera, Vector3} from "three";

const steepest = Math.PI / 2;
const still = matchMedia("(prefers-reduced-motion: reduce)");

export const views = {
  panel: {name: "Panel", key: "0"},
  iso: {name: "Iso", key: "1", azimuth: -Math.PI / 4, elevation: 0.6155},
  top: {name: "Top", key: "2", azimuth: -Math.PI / 2, elevation: steepest},
  bottom: {name: "Bottom", key: "3", azimuth: -Math.PI / 2, elevation: -steepest},
  front: {name: "Front", key: "4", azimuth: -Math.PI / 2, elevation: 0},
  back: {name: "Back", key: "5", azimuth: Math.PI / 2, elevation: 0},
  left: {name: "Left", key: "6", azimuth: Math.PI, elevation: 0},
  right: {name: "Right", key: "7", azimuth: 0, elevation: 0},
};

/** Directions of the picture for angles: to the right, up, to the eye. */
export function frameOf(azimuth, elevation) {
  const ca = Math.cos(azimuth), sa = Math.sin(azimuth), ce = Math.cos(elevation), se = Math.sin(elevation);
  return {right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], eye: [ce * ca, ce * sa, se]};
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export class CameraRig {
  /**
   * @param {HTMLElement} element takes the mouse and the keys
   * @param {number} radius of the whole panel
   * @param {() => void} changed called after every move
   */
  constructor(element, radius, changed) {
    this.element = element;
    this.radius = Math.max(radius, 1e-6);
    this.changed = changed;
    this.camera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
    /** The state: middle of the picture, angles, height of the picture in mm. */
    this.state = {target: [0, 0, 0], azimuth: -1.1, elevation: 0.9, height: 2 * this.radius};
    this.width = this.heightInPixels = 1;
    this.flight = 0;
    this.#listen();
  }

  resize(width, height) {
    this.width = Math.max(1, width), this.heightInPixels = Math.max(1, height);
    this.update();
  }

  /** Length of a pixel, mm. */
  get pixel() { return this.state.height / this.heightInPixels; }

  frame() { return frameOf(this.state.azimuth, this.state.elevation); }

  /** Pixels from the upper left corner. */
  project(p) {
    const {right, up} = this.frame(), {target} = this.state;
    const d = [p[0] - target[0], p[1] - target[1], p[2] - target[2]];
    return [this.width / 2 + dot(d, right) / this.pixel, this.heightInPixels / 2 - dot(d, up) / this.pixel];
  }

  update() {
    const {target, height} = this.state, {up, eye} = this.frame(), far = 3 * this.radius;
    const half = height / 2, aspect = this.width / this.heightInPixels;
    const c = this.camera;
    c.left = -half * aspect, c.right = half * aspect, c.top = half, c.bottom = -half;
    // The distance to the plane through the panel's middle stays, so that nothing is cut off when zoomed in far aside.
    const depth = far - dot(target, eye);
    c.near = 0, c.far = 2 * far;
    c.position.set(target[0] + eye[0] * depth, target[1] + eye[1] * depth, target[2] + eye[2] * depth);
    c.up.set(...up);
    c.lookAt(new Vector3(...target));
    if (Math.abs(depth) < 1e-9) c.lookAt(target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]);
    c.updateProjectionMatrix();
    c.updateMatrixWorld();
    this.changed();
  }

  /** Goes there within a quarter of a second. */
  flyTo(goal, instantly = false) {
    const from = structuredClone(this.state), to = {...from, ...goal};
    const turn = to.azimuth - from.azimuth;
    to.azimuth = from.azimuth + Math.atan2(Math.sin(turn), Math.cos(turn));
    const token = ++this.flight;
    if (instantly || still.matches || document.hidden) {
      this.state = to;
      this.update();
      return;
    }
    const start = performance.now();
    const step = (now) => {
      if (token !== this.flight) return;
      const t = Math.min(1, Math.max(0, (now - start) / 280)), s = t * t * (3 - 2 * t);
      const mix = (a, b) => a + (b - a) * s;
      this.state = {
        target: from.target.map((value, k) => mix(value, to.target[k])),
        azimuth: mix(from.azimuth, to.azimuth),
        elevation: mix(from.elevation, to.elevation),
        height: Math.exp(mix(Math.log(from.height), Math.log(to.height))),
      };
      this.update();
      if (t < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  /** Extent of points (x, y, z in a row) along the axes of the picture at some angles. */
  #extent(points, azimuth, elevation) {
    const axes = Object.values(frameOf(azimuth, elevation));
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i + 2 < points.length; i += 3)
      for (let k = 0; k < 3; ++k) {
        const a = axes[k], value = points[i] * a[0] + points[i + 1] * a[1] + points[i + 2] * a[2];
        if (value < low[k]) low[k] = value;
        if (value > high[k]) high[k] = value;
      }
    return {axes, low, high};
  }

  #height({low, high}, width = this.width) {
    return Math.max(high[1] - low[1], (high[0] - low[0]) * this.heightInPixels / Math.max(1, width));
  }

  /** Height of the picture, mm, that shows all points. */
  heightFor(points, azimuth, elevation) { return this.#height(this.#extent(points, azimuth, elevation)); }

  /**
   * All points in the picture, seen at the angles given or as now. `room`: the share of the picture that they take;
   * `least`: mm; `covered`: pixels at the left that are not to be seen.
   */
  fit(points, {azimuth = this.state.azimuth, elevation = this.state.elevation, room = 0.9, least = 0, covered = 0, instantly} = {}) {
    if (points.length < 3) return;
    const extent = this.#extent(points, azimuth, elevation), {axes, low, high} = extent;
    const height = Math.max(this.#height(extent, this.width - covered) / room, least, 1e-6 * this.radius);
    const aside = covered / 2 * height / this.heightInPixels;
    const middle = low.map((value, k) => (value + high[k]) / 2 - (k === 0 ? aside : 0));
    const target = [0, 1, 2].map((c) => axes.reduce((sum, a, k) => sum + a[c] * middle[k], 0));
    this.flyTo({target, azimuth, elevation, height}, instantly);
  }

  turn(right, down) {
    const s = this.state;
    ++this.flight;
    s.azimuth -= right;
    s.elevation = Math.min(steepest, Math.max(-steepest, s.elevation + down));
    this.update();
  }

  /** In pixels. */
  move(right, down) {
    const {right: r, up} = this.frame(), s = this.state, pixel = this.pixel;
    ++this.flight;
    s.target = s.target.map((value, k) => value - r[k] * right * pixel + up[k] * down * pixel);
    this.update();
  }

  /** By a factor, keeping what lies under the pixel. */
  zoom(factor, x = this.width / 2, y = this.heightInPixels / 2) {
    const s = this.state, before = this.pixel;
    ++this.flight;
    s.height = Math.min(20 * this.radius, Math.max(1e-4 * this.radius, s.height * factor));
    const shift = before - this.pixel;
    const {right, up} = this.frame();
    const dx = (x - this.width / 2) * shift, dy = (this.heightInPixels / 2 - y) * shift;
    s.target = s.target.map((value, k) => value + right[k] * dx + up[k] * dy);
    this.update();
  }

  #listen() {
    const {element} = this, pointers = new Map();
    element.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      element.setPointerCapture(event.pointerId);
    });
    element.addEventListener("pointermove", (event) => {
      const last = pointers.get(event.pointerId);
      if (!last) return;
      const dx = event.clientX - last[0], dy = event.clientY - last[1];
      if (pointers.size === 2) {
        const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
        const span = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]);
        this.zoom(Math.max(1, span(last)) / Math.max(1, span([event.clientX, event.clientY])));
        this.move(dx / 2, dy / 2);
      } else if (event.buttons & 6 || event.shiftKey || event.ctrlKey) {
        this.move(dx, dy);
      } else {
        this.turn(dx * 0.008, dy * 0.008);
      }
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    for (const name of ["pointerup", "pointercancel"])
      element.addEventListener(name, (event) => pointers.delete(event.pointerId));
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("wheel", (event) => {
      event.preventDefault();
      const box = element.getBoundingClientRect(), lines = event.deltaMode === 1 ? 16 : 1;
      this.zoom(Math.exp(Math.max(-240, Math.min(240, event.deltaY * lines)) * 0.0015), event.clientX - box.left,
                event.clientY - box.top);
    }, {passive: false});
    element.addEventListener("keydown", (event) => this.#key(event));
  }

  #key(event) {
    const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
    const arrow = arrows[event.key];
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    if (arrow && event.shiftKey) this.move(-40 * arrow[0], -40 * arrow[1]);
    else if (arrow) this.turn(0.1 * arrow[0], 0.1 * arrow[1]);
    else if (event.key === "+" || event.key === "=") this.zoom(0.8);
    else if (event.key === "-") this.zoom(1.25);
    else return;
    event.preventDefault();
  }
}
