// Reads the data that the report carries: packed numbers become typed arrays.
import {unzlibSync} from "fflate";

/** @param {string} text base64 */
function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** zlib stream to bytes: by the browser where it can. */
async function inflated(bytes) {
  if (typeof DecompressionStream === "undefined") return unzlibSync(bytes);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Text packed by the program: base64 of zlib of UTF-8. */
export async function unpackedText(text) {
  return new TextDecoder().decode(await inflated(bytesOf(text)));
}

/** Rows of whole numbers, see report/packed_numbers.h. */
export async function unpacked({rows, stride, bytes, differences, text}) {
  const planes = await inflated(bytesOf(text));
  const values = new Int32Array(rows * stride);
  for (let column = 0; column < stride; ++column) {
    const base = column * bytes * rows;
    let before = 0;
    for (let row = 0, at = column; row < rows; ++row, at += stride) {
      let code = 0;
      for (let b = bytes - 1; b >= 0; --b) code = (code << 8) | planes[base + b * rows + row];
      const value = (code >>> 1) ^ -(code & 1);
      before = differences ? (before + value) | 0 : value;
      values[at] = before;
    }
  }
  return values;
}

/** Whole steps to lengths; relative to the middle of the panel, where numbers of single precision do. */
function scaled(steps, step, middle) {
  const out = new Float32Array(steps.length);
  for (let i = 0; i < steps.length; ++i) out[i] = steps[i] * step - middle[i % 3];
  return out;
}

/** Adds up counts: where each piece begins. */
function starts(counts) {
  const out = new Uint32Array(counts.length + 1);
  for (let i = 0; i < counts.length; ++i) out[i + 1] = out[i] + counts[i];
  return out;
}

async function linesOf(raw, place) {
  const [counts, beads, kinds, points] = await Promise.all(
      [raw.counts, raw.beads, raw.kinds, raw.points].map(unpacked));
  return {start: starts(counts), beads, kinds, points: place(points)};
}

async function surfaceOf(raw, place) {
  const [pointCounts, triangleCounts, points, triangles] = await Promise.all(
      [raw.point_counts, raw.triangle_counts, raw.points, raw.triangles].map(unpacked));
  return {pointStart: starts(pointCounts), triangleStart: starts(triangleCounts), points: place(points), triangles};
}

async function measureOf(raw) {
  const [steps, failing] = await Promise.all([raw.values, raw.failing].map(unpacked));
  const values = new Float32Array(steps.length);
  const scale = (raw.high - raw.low) / 65535;
  for (let i = 0; i < steps.length; ++i) values[i] = steps[i] < 0 ? NaN : raw.low + steps[i] * scale;
  return {...raw, values, failing};
}

async function meshOf(raw, place) {
  const [nodes, corners, runs] = await Promise.all([raw.nodes, raw.corners, raw.runs].map(unpacked));
  const count = corners.length / 4;
  const face = new Int32Array(count), bead = new Int32Array(count);
  for (let r = 0, e = 0; r < runs.length; r += 3)
    for (let k = 0; k < runs[r + 2]; ++k, ++e) face[e] = runs[r], bead[e] = runs[r + 1];
  return {count, nodes: place(nodes), corners, face, bead, measures: await Promise.all(raw.measures.map(measureOf))};
}

/** Largest coordinates of the points of the scene, in steps: half of it is the middle. */
function middleOf(step, ...points) {
  const high = [0, 0, 0];
  for (const list of points)
    for (let i = 0; i < list.length; ++i) if (list[i] > high[i % 3]) high[i % 3] = list[i];
  return high.map((value) => value * step / 2);
}

/** Everything of the page's data, ready to draw. Points are relative to `middle`. */
export async function readScene(raw) {
  const [nodes, points] = await Promise.all([unpacked(raw.mesh.nodes), unpacked(raw.surface.points)]);
  const middle = middleOf(raw.step, nodes, points);
  const place = (steps) => scaled(steps, raw.step, middle);
  const [surface, mesh, crests, axes, blocks, thickness] = await Promise.all([
    surfaceOf(raw.surface, place), meshOf(raw.mesh, place), linesOf(raw.crests, place), linesOf(raw.axes, place),
    linesOf(raw.blocks, place), unpacked(raw.axes.thickness)]);
  axes.thickness = Float32Array.from(thickness, (value) => value * raw.step);
  blocks.count = raw.blocks.count;
  const beadById = new Map(raw.beads.map((bead) => [bead.id, bead]));
  for (const bead of raw.beads) bead.at = bead.point.map((value, k) => value - raw.origin[k] - middle[k]);
  const faceByNumber = new Map();
  raw.faces.forEach((face, index) => face.numbers.forEach((number) => faceByNumber.set(number, index)));
  return {...raw, middle, surface, mesh, crests, axes, blocks, beadById, faceByNumber};
}
