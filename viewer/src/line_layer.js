// Lines of a width in pixels: crest lines, medial axes, sides of blocks, outlines. Drawn a little before the mesh, whose
// elements cut the corners of what they stand for; among each other in the order of `order`, since the caps of short pieces
// would pierce each other by depth.
import {Color} from "three";
import {LineMaterial} from "three/addons/lines/LineMaterial.js";
import {LineSegments2} from "three/addons/lines/LineSegments2.js";
import {LineSegmentsGeometry} from "three/addons/lines/LineSegmentsGeometry.js";

/** Ends of the pieces of polylines that `take` says yes to. */
export function segmentsOf(lines, take = () => true) {
  const out = [], {start, points} = lines;
  for (let l = 0; l + 1 < start.length; ++l) {
    if (!take(l)) continue;
    for (let p = start[l]; p + 1 < start[l + 1]; ++p)
      for (let i = 3 * p; i < 3 * p + 6; ++i) out.push(points[i]);
  }
  return out;
}

export class LineLayer {
  /** @param {number[]} ends x, y, z of both ends of every piece @param colors r, g, b in 0..1 of both ends, or none */
  constructor(ends, {color = "#000000", width = 2, dash = 0, forward = 1, colors = null, order = 1} = {}) {
    this.material = new LineMaterial({color, linewidth: width, dashed: dash > 0, dashSize: dash, gapSize: dash * 0.8,
                                      vertexColors: colors !== null, worldUnits: false,
                                      depthWrite: false});
    this.forward = {value: 0};
    this.order = forward;
    this.material.onBeforeCompile = (shader) => {
      shader.uniforms.forward = this.forward;
      shader.vertexShader = "uniform float forward;\n" +
          shader.vertexShader.replace("gl_Position = clip;", "gl_Position = clip;\ngl_Position.z -= forward * clip.w;");
    };
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    this.set(ends, colors);
  }

  set(ends, colors = null) {
    this.object.geometry.dispose();
    this.isEmpty = ends.length === 0;
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(this.isEmpty ? [0, 0, 0, 0, 0, 0] : ends);
    if (colors) geometry.setColors(colors);
    this.object.geometry = geometry;
    if (this.material.dashed) this.object.computeLineDistances();
    this.show(this.wanted ?? true);
  }

  show(wanted) {
    this.wanted = wanted;
    this.object.visible = wanted && !this.isEmpty;
  }

  set color(value) { this.material.color = new Color(value); }

  /** `depth` of the whole picture, `lift` mm by which the line stands before what it lies on. */
  adapt(width, height, depth, lift) {
    this.material.resolution.set(width, height);
    this.forward.value = this.order * lift / depth * 2;
  }
}
