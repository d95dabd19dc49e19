// The elements of the mesh: four vertices each, in the order of the elements, drawn in one call.
import {BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, ShaderMaterial} from "three";
import {rimOf} from "./outline.js";
import {meshFragment, meshVertex, pickFragment, pickMeshVertex, stateByte, states} from "./shaders.js";

/** 255 for the sides that a corner does not touch: quads by (u, v, 1-u, 1-v), triangles by their heights. */
const quadSides = [[0, 0, 255, 255], [255, 0, 0, 255], [255, 255, 0, 0], [0, 255, 255, 0]];
const triangleSides = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [0, 0, 255, 255]];

function geometryOf(mesh) {
  const {count, corners, nodes} = mesh;
  const positions = new Float32Array(12 * count), sides = new Uint8Array(16 * count);
  const index = new Uint32Array(6 * count);
  for (let e = 0; e < count; ++e) {
    const isTriangle = corners[4 * e + 3] === corners[4 * e + 2];
    for (let k = 0; k < 4; ++k) {
      const node = 3 * corners[4 * e + k], at = 4 * e + k;
      positions[3 * at] = nodes[node], positions[3 * at + 1] = nodes[node + 1], positions[3 * at + 2] = nodes[node + 2];
      sides.set((isTriangle ? triangleSides : quadSides)[k], 4 * at);
    }
    const a = 4 * e;
    index.set(isTriangle ? [a, a + 1, a + 2, a, a, a] : [a, a + 1, a + 2, a, a + 2, a + 3], 6 * e);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("sides", new BufferAttribute(sides, 4, true));
  geometry.setAttribute("tint", new BufferAttribute(new Uint8Array(16 * count), 4, true));
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.computeBoundingSphere();
  return geometry;
}

export class MeshLayer {
  constructor(mesh, uniforms) {
    this.mesh = mesh;
    this.geometry = geometryOf(mesh);
    const offset = {polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1};
    this.object = new Mesh(this.geometry, new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: meshVertex, fragmentShader: meshFragment, uniforms, side: DoubleSide, ...offset}));
    this.pickable = new Mesh(this.geometry, new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: pickMeshVertex, fragmentShader: pickFragment, uniforms: {layer: {value: 1}},
      side: DoubleSide, blending: 0}));
    this.object.frustumCulled = this.pickable.frustumCulled = false;
    this.state = new Uint8Array(mesh.count);
  }

  /** @param {(element: number) => [number, number, number]} colorOf @param {(element: number) => number} kindOf */
  paint(colorOf, kindOf) {
    const tint = this.geometry.attributes.tint, bytes = tint.array;
    for (let e = 0; e < this.mesh.count; ++e) {
      const [r, g, b] = colorOf(e), a = stateByte(this.state[e], kindOf(e));
      for (let k = 16 * e; k < 16 * e + 16; k += 4) bytes[k] = r, bytes[k + 1] = g, bytes[k + 2] = b, bytes[k + 3] = a;
    }
    tint.needsUpdate = true;
  }

  /** Elements that `isKept` says no to are dimmed; those of `chosen` stand out. */
  mark(isKept, isChosen) {
    const tint = this.geometry.attributes.tint, bytes = tint.array;
    for (let e = 0; e < this.mesh.count; ++e) {
      const state = isChosen?.(e) ? states.chosen : isKept && !isKept(e) ? states.dimmed : states.plain;
      if (this.state[e] === state) continue;
      this.state[e] = state;
      for (let k = 16 * e + 3; k < 16 * e + 16; k += 4) bytes[k] = stateByte(state, bytes[k] & 15);
    }
    tint.needsUpdate = true;
  }

  /** Coordinates of the corners of elements, x, y, z in a row. */
  pointsOf(elements) {
    const {corners, nodes} = this.mesh, out = new Float32Array(12 * elements.length);
    elements.forEach((e, i) => {
      for (let k = 0; k < 4; ++k)
        for (let c = 0; c < 3; ++c) out[12 * i + 3 * k + c] = nodes[3 * corners[4 * e + k] + c];
    });
    return out;
  }

  /** Ends of the sides that only one of the elements has: their outline. */
  outlineOf(elements) {
    const {corners, nodes} = this.mesh;
    return rimOf(elements.length, 4, (i, k) => corners[4 * elements[i] + k], nodes.length / 3, nodes);
  }
}
