// The faces of the panel as the reader's facets, shaded smoothly within each face.
import {BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, ShaderMaterial} from "three";
import {rimOf} from "./outline.js";
import {pickFragment, pickSurfaceVertex, stateByte, states, surfaceFragment, surfaceVertex} from "./shaders.js";

function geometryOf(surface) {
  const {pointStart, triangleStart, points, triangles} = surface;
  const face = new Float32Array(points.length / 3), index = new Uint32Array(triangles.length);
  for (let f = 0; f + 1 < pointStart.length; ++f) {
    face.fill(f, pointStart[f], pointStart[f + 1]);
    for (let i = 3 * triangleStart[f]; i < 3 * triangleStart[f + 1]; ++i) index[i] = triangles[i] + pointStart[f];
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setAttribute("face", new BufferAttribute(face, 1));
  geometry.setAttribute("tint", new BufferAttribute(new Uint8Array(4 * face.length), 4, true));
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.computeVertexNormals();
  geometry.computeBoundingSphere();
  return geometry;
}

export class SurfaceLayer {
  constructor(surface, uniforms) {
    this.surface = surface;
    this.geometry = geometryOf(surface);
    const offset = {polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2};
    this.object = new Mesh(this.geometry, new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: surfaceVertex, fragmentShader: surfaceFragment, uniforms, side: DoubleSide,
      ...offset}));
    this.pickable = new Mesh(this.geometry, new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: pickSurfaceVertex, fragmentShader: pickFragment, uniforms: {layer: {value: 2}},
      side: DoubleSide, blending: 0}));
    this.object.frustumCulled = this.pickable.frustumCulled = false;
  }

  get faceCount() { return this.surface.pointStart.length - 1; }

  /** @param {(face: number) => [number, number, number]} colorOf; kinds and states by face too */
  paint(colorOf, kindOf, isKept, isChosen) {
    const {pointStart} = this.surface, tint = this.geometry.attributes.tint;
    for (let f = 0; f < this.faceCount; ++f) {
      const state = isChosen?.(f) ? states.chosen : isKept && !isKept(f) ? states.dimmed : states.plain;
      const [r, g, b] = colorOf(f), a = stateByte(state, kindOf(f));
      for (let p = pointStart[f]; p < pointStart[f + 1]; ++p) tint.array.set([r, g, b, a], 4 * p);
    }
    tint.needsUpdate = true;
  }

  pointsOf(face) {
    const {pointStart, points} = this.surface;
    return points.subarray(3 * pointStart[face], 3 * pointStart[face + 1]);
  }

  /** Ends of the free sides of the facets of a face. */
  outlineOf(face) {
    const {triangleStart, points} = this.surface, index = this.geometry.index.array, first = triangleStart[face];
    return rimOf(triangleStart[face + 1] - first, 3, (t, k) => index[3 * (first + t) + k], points.length / 3, points);
  }
}
