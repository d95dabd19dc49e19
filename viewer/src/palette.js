// Colours that are told apart with any colour vision: Okabe and Ito (2008) for kinds, viridis and cividis for measures.

/** Kinds of regions: the code that the shader's patterns know, and the colours on light and dark ground. */
export const kinds = {
  sheet: {code: 0, name: "sheet", light: "#dfe4ea", dark: "#566070"},
  I: {code: 1, name: "I bead", light: "#4ea3dc", dark: "#3f95d0"},
  generic: {code: 2, name: "generic bead", light: "#eda52a", dark: "#d9921a"},
  annular: {code: 3, name: "annular bead", light: "#1fa981", dark: "#159a74"},
};

const viridis = ["#440154", "#482475", "#414487", "#355f8d", "#2a788e", "#21918c", "#22a884", "#44bf70", "#7ad151",
                 "#bddf26", "#fde725"];
const cividis = ["#00224e", "#123570", "#3b496c", "#575d6d", "#707173", "#8a8678", "#a59c74", "#c3b369", "#e1cc55",
                 "#fee838"];

/** @returns {[number, number, number]} 0 to 255 */
export function rgb(hex) {
  const value = parseInt(hex.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/** The darkest part of the ramps is left out: a mesh of good elements is no black plate, its edges stay to be seen. */
const darkest = 0.3;

/** Colours of 256 steps between the stops. */
function ramp(stops) {
  const table = new Uint8Array(256 * 3);
  for (let i = 0; i < 256; ++i) {
    const at = (darkest + (1 - darkest) * i / 255) * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
    const a = rgb(stops[k]), b = rgb(stops[k + 1]);
    for (let c = 0; c < 3; ++c) table[3 * i + c] = Math.round(a[c] + (b[c] - a[c]) * (at - k));
  }
  return table;
}

export const ramps = {viridis: ramp(viridis), cividis: ramp(cividis)};

export function css(table, t) {
  const i = 3 * Math.round(Math.min(1, Math.max(0, t)) * 255);
  return `rgb(${table[i]} ${table[i + 1]} ${table[i + 2]})`;
}
