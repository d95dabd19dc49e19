// The shaders of mesh and surface. One pass draws fill, element edges and patterns, so that a panel of any size is one draw
// call; a second set writes what lies under a pixel.

const common = `
precision highp float;
precision highp int;
`;

/** Bits of the fourth byte of a tint: kind in the lower, state in the upper. */
export const states = {plain: 0, dimmed: 1, chosen: 2};
export const stateByte = (state, kind) => state * 16 + kind;

export const meshVertex = `${common}
in vec4 tint;
in vec4 sides;
flat out vec4 vTint;
out vec4 vSides;
out vec3 vPlace;
void main() {
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  vTint = tint;
  vSides = sides;
  vPlace = place.xyz;
  gl_Position = projectionMatrix * place;
}`;

export const surfaceVertex = `${common}
in vec4 tint;
flat out vec4 vTint;
out vec3 vNormal;
out vec3 vPlace;
void main() {
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  vTint = tint;
  vNormal = normalMatrix * normal;
  vPlace = place.xyz;
  gl_Position = projectionMatrix * place;
}`;

const shading = `
uniform vec3 ground;
uniform float patterns;
uniform float pixelRatio;
flat in vec4 vTint;
in vec3 vPlace;
out vec4 color;

// Strokes and dots in the picture's plane: kinds can be told without colour.
float pattern(int kind) {
  vec2 p = gl_FragCoord.xy / pixelRatio;
  if (kind == 1) return smoothstep(0.7, 1.3, abs(mod(p.y, 7.0) - 3.5));
  if (kind == 2) return smoothstep(0.7, 1.3, abs(mod(p.x + p.y, 9.0) - 4.5) * 0.7071);
  if (kind == 3) return smoothstep(1.2, 1.9, length(mod(p, 7.0) - 3.5));
  return 1.0;
}

vec3 lit(vec3 base, vec3 n) {
  bool back = n.z < 0.0;
  if (back) n = -n;
  float key = max(dot(n, normalize(vec3(-0.45, 0.6, 0.75))), 0.0);
  float fill = max(dot(n, normalize(vec3(0.7, -0.3, 0.5))), 0.0);
  float light = 0.46 + 0.50 * key + 0.14 * fill;
  return base * light * (back ? 0.80 : 1.0);
}

vec3 painted(vec3 n) {
  int code = int(vTint.a * 255.0 + 0.5), kind = code & 15, state = code >> 4;
  vec3 base = vTint.rgb;
  if (patterns > 0.0) base *= mix(1.0, mix(0.72, 1.0, pattern(kind)), patterns);
  if (state == 1) base = mix(vec3(dot(base, vec3(0.3, 0.59, 0.11))), ground, 0.5);
  if (state == 1) base = mix(base, ground, 0.35);
  if (state == 2) base = mix(base, vec3(1.0), 0.22);
  return lit(base, n);
}
`;

export const meshFragment = `${common}${shading}
uniform float edges;
uniform vec3 edgeColor;
in vec4 vSides;
void main() {
  vec3 n = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  vec3 c = painted(n);
  // Distance to the four sides in pixels; where elements are a few pixels small the lines fade to a faint tone.
  vec4 width = fwidth(vSides);
  vec4 away = vSides / max(width, vec4(1e-6));
  float nearest = min(min(away.x, away.y), min(away.z, away.w));
  float small = max(max(width.x, width.y), max(width.z, width.w)) * pixelRatio;
  float line = 1.0 - smoothstep(0.35 * pixelRatio, 0.35 * pixelRatio + 0.9, nearest);
  float fade = 1.0 - smoothstep(0.05, 0.42, small);
  float tone = mix(0.16, line, fade);
  // Dark elements have light edges.
  vec3 ink = dot(c, vec3(0.3, 0.59, 0.11)) < 0.3 ? mix(c, vec3(1.0), 0.45) : edgeColor;
  color = vec4(mix(c, ink, edges * tone), 1.0);
}`;

export const surfaceFragment = `${common}${shading}
in vec3 vNormal;
void main() {
  vec3 n = length(vNormal) > 0.0 ? normalize(vNormal) : normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  vec3 flat_ = cross(dFdx(vPlace), dFdy(vPlace));
  if (dot(n, flat_) < 0.0) n = -n;
  color = vec4(painted(n), 1.0);
}`;

/** Number of what is drawn, from 1, in three bytes; the fourth tells mesh (1) from surface (2) by \`layer\`. */
export const pickMeshVertex = `${common}
flat out int vNumber;
void main() {
  vNumber = (gl_VertexID >> 2) + 1;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

export const pickSurfaceVertex = `${common}
in float face;
flat out int vNumber;
void main() {
  vNumber = int(face) + 1;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

export const pickFragment = `${common}
uniform float layer;
flat in int vNumber;
out vec4 color;
void main() {
  color = vec4(float(vNumber & 255), float((vNumber >> 8) & 255), float((vNumber >> 16) & 255), layer) / 255.0;
}`;
