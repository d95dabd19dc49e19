// The rim of a set of polygons.

/**
 * Sides that only one polygon has.
 * @param {number} count polygons @param {(polygon: number, k: number) => number} corner number of a point
 * @param {number} corners of each polygon; a point repeated makes no side
 * @param {number} pointCount @param {Float32Array} points x, y, z in a row
 * @returns {number[]} x, y, z of both ends of each side
 */
export function rimOf(count, corners, corner, pointCount, points) {
  const keys = new Float64Array(count * corners);
  let used = 0;
  for (let p = 0; p < count; ++p)
    for (let k = 0; k < corners; ++k) {
      const a = corner(p, k), b = corner(p, (k + 1) % corners);
      if (a !== b) keys[used++] = Math.min(a, b) * pointCount + Math.max(a, b);
    }
  const sorted = keys.subarray(0, used).sort(), out = [];
  for (let i = 0; i < used; ++i) {
    if (sorted[i] === sorted[i - 1] || sorted[i] === sorted[i + 1]) continue;
    for (const point of [Math.floor(sorted[i] / pointCount), sorted[i] % pointCount])
      out.push(points[3 * point], points[3 * point + 1], points[3 * point + 2]);
  }
  return out;
}
