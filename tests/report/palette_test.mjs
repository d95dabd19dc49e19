// Colours of the report as people see them who lack one kind of cone: node --test palette_test.mjs. Matrices for full loss of
// one kind by Machado, Oliveira and Fernandes (2009), distances in CIE L*a*b* (1976), where 10 is told apart side by side.
import assert from "node:assert/strict";
import {test} from "node:test";
import {kinds, ramps, rgb} from "../../viewer/src/palette.js";

const visions = {
  normal: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const toXyz = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]], white = [0.9505, 1, 1.089];
const times = (matrix, v) => matrix.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);

function lab(color, vision) {
  const seen = times(visions[vision], color.map((c) => linear(c / 255))).map((c) => Math.min(1, Math.max(0, c)));
  const [x, y, z] = times(toXyz, seen).map((c, i) => c / white[i]).map((t) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

for (const vision of Object.keys(visions)) {
  test(`kinds are told apart: ${vision}`, () => {
    for (const ground of ["light", "dark"]) {
      const names = Object.keys(kinds), seen = names.map((name) => lab(rgb(kinds[name][ground]), vision));
      for (let i = 0; i < names.length; ++i)
        for (let k = 0; k < i; ++k)
          assert.ok(Math.hypot(...seen[i].map((c, j) => c - seen[k][j])) > 10, `${names[i]} and ${names[k]} on ${ground} ground`);
    }
  });

  test(`ramps grow lighter from end to end: ${vision}`, () => {
    for (const [name, table] of Object.entries(ramps)) {
      const lightness = (i) => lab([...table.slice(3 * i, 3 * i + 3)], vision)[0];
      for (let i = 15; i < 256; i += 15) assert.ok(lightness(i) > lightness(i - 15), `${name} at step ${i}`);
      assert.ok(lightness(255) - lightness(0) > 40, name);
    }
  });
}
