// How light becomes colour: base colour times stored light, then the renderer's tone curve.
import { DoubleSide, GLSL3, RawShaderMaterial, type IUniform, type Texture } from "three";

// render/tone.cpp's curve. Its sigmoid, contrast and gain are one polynomial over the stops here, which differs by at most 0.6 of a
// byte's step and costs no power.
const tone = /* glsl */ `
vec3 toneMapped(vec3 c) {
  c = mat3(0.657133714, 0.033016029, 0.033053011,
           0.061178208, 0.685205549, 0.061178208,
           0.061794521, 0.061749583, 0.685731532) * c;
  vec3 s = clamp((log2(max(c, vec3(1e-8))) + 12.47393) / 16.499999, 0.0, 1.0);
  vec3 p = vec3(22.5367677);
  p = p * s - 50.4821160;
  p = p * s + 25.7974081;
  p = p * s + 8.54532424;
  p = p * s - 6.58272356;
  p = p * s + 1.35656810;
  p = p * s - 0.0722485920;
  p = p * s + 0.00111551660;
  c = max(p, vec3(0.0));
  float g = dot(c, vec3(0.2126, 0.7152, 0.0722));
  c = g + (c - g) * 1.18;
  c = mat3(1.19687900, -0.0528968518, -0.0529716355,
          -0.0980208811, 1.15190313, -0.0980434501,
          -0.0990297441, -0.0989611768, 1.15107367) * c;
  return clamp(c, 0.0, 1.0);
}
// With other goods searched for, what was not found steps back.
vec3 shown(vec3 c, float dim) {
  vec3 display = toneMapped(c);
  float g = dot(display, vec3(0.3, 0.59, 0.11));
  return mix(display, vec3(g * 0.55 + 0.22), dim);
}
`;

// sRGB to linear within 0.2 % (a cubic), and the light of the server's bytes.
const decode = /* glsl */ `
vec3 linearOf(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }
vec3 lightOf(vec3 byte) { return byte * byte * 4.0; }
`;

const head = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2DArray;
`;

export interface Shared {
  readonly uDim: IUniform<number>;
}

// `faint`: what is clear lets this much through.
function material(vertex: string, fragment: string, uniforms: Record<string, IUniform>, defines: Record<string, string>): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: head + decode + vertex,
    fragmentShader: head + decode + tone + fragment,
    uniforms,
    defines,
  });
}

const roomVertex = /* glsl */ `
uniform mat4 viewMatrix, projectionMatrix;
uniform vec3 cameraPosition;
in vec3 position;
in vec3 normal;
in vec2 uv;
in vec4 color;
in vec4 light;
in vec4 finish;
out vec3 vBase, vLight;
out vec2 vUv;
out float vSheen;
void main() {
  vec3 away = normalize(cameraPosition - position);
  float graze = 1.0 - clamp(abs(dot(away, normal)), 0.0, 1.0);
  float graze2 = graze * graze;
  vBase = linearOf(color.rgb);
  vLight = lightOf(light.rgb);
  vUv = uv;
  vSheen = (0.02 + graze2 * graze2 * graze * 0.7) * (1.0 - finish.x) * (1.0 - finish.y);
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}
`;
const roomFragment = /* glsl */ `
uniform sampler2D map;
uniform float uDim;
in vec3 vBase, vLight;
in vec2 vUv;
in float vSheen;
out vec4 outColor;
void main() {
  vec3 base = vBase;
#ifdef TEXTURED
  base *= linearOf(texture(map, vUv).rgb);
#endif
  vec3 c = (base + vSheen) * vLight;
#ifdef GLASS
  outColor = vec4(shown(c, uDim), 0.12 + 0.5 * min(vSheen, 1.0));
#else
  outColor = vec4(shown(c, uDim), 1.0);
#endif
}
`;

export function roomMaterial(shared: Shared, map: Texture | null, glass: boolean): RawShaderMaterial {
  const defines: Record<string, string> = {};
  if (map) defines["TEXTURED"] = "1";
  if (glass) defines["GLASS"] = "1";
  const made = material(roomVertex, roomFragment, { ...shared, map: { value: map } }, defines);
  if (glass) Object.assign(made, { transparent: true, depthWrite: false, side: DoubleSide });
  return made;
}

// Packs near the eye: merged meshes in the store frame, with their light at the vertices. The SKU's row in `skus` says where its
// label lies: (u0, v0, width, height) in page `page` of the atlas, and in which layer of the sheets, if any.
const packVertex = /* glsl */ `
uniform mat4 viewMatrix, projectionMatrix;
uniform sampler2D skus;
in vec3 position;
in vec2 uv;
in vec4 color;
in vec4 light;
in float sku;
out vec3 vBase, vLight;
out vec3 vPlace;
flat out ivec2 vWhere;
void main() {
  int row = int(sku);
  vec4 tile = texelFetch(skus, ivec2((row % 512) * 2, row / 512), 0);
  vec4 where = texelFetch(skus, ivec2((row % 512) * 2 + 1, row / 512), 0);
  vBase = linearOf(color.rgb);
  vLight = lightOf(light.rgb);
  vPlace = vec3(where.y >= 0.0 ? uv : tile.xy + uv * tile.zw, light.a);
  vWhere = color.a > 0.5 ? ivec2(int(where.x), int(where.y)) : ivec2(-1);
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}
`;
const packFragment = /* glsl */ `
uniform sampler2DArray atlas;
uniform sampler2DArray sheets;
uniform float uDim;
in vec3 vBase, vLight;
in vec3 vPlace;
flat in ivec2 vWhere;
out vec4 outColor;
void main() {
  vec3 base = vBase;
  if (vWhere.y >= 0) base *= linearOf(texture(sheets, vec3(vPlace.xy, float(vWhere.y))).rgb);
  else if (vWhere.x >= 0) base *= linearOf(texture(atlas, vec3(vPlace.xy, float(vWhere.x))).rgb);
#ifdef CLEAR
  outColor = vec4(shown(base * vLight, uDim), 0.78);
#else
  outColor = vec4(shown(base * vLight, uDim), 1.0);
#endif
}
`;

export function packMaterial(shared: Shared, uniforms: Record<string, IUniform>, clear: boolean): RawShaderMaterial {
  const made = material(packVertex, packFragment, { ...shared, ...uniforms }, clear ? { CLEAR: "1" } : {});
  if (clear) Object.assign(made, { transparent: true, depthWrite: false });
  return made;
}

// Packs farther off: pictures of them from the front, the right and above, on the sides of their box; packs that are round about
// their axis as a picture that turns with the eye. See stand_ins.ts for the rows of an instance.
const standInVertex = /* glsl */ `
uniform mat4 viewMatrix, projectionMatrix;
uniform vec3 cameraPosition;
uniform vec2 cells;      // of the picture sheet, across and down
uniform vec2 cellTexels; // of one
in vec3 corner;          // -1..1; z 0..1 from the foot up
in float side;           // 0 front, 1 right, 2 back, 3 left, 4 top
in uvec4 wordsA, wordsB, wordsC; // see stand_ins.ts
out vec3 vBase, vLight;
out vec2 vUv;
vec4 turn;
vec3 turned(vec3 v) { return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v); }
vec3 bytes(uint w) { return vec3(float(w & 255u), float((w >> 8) & 255u), float((w >> 16) & 255u)) / 255.0; }
void main() {
  vec3 place = uintBitsToFloat(wordsA.xyz);
  turn = vec4(unpackSnorm2x16(wordsA.w), unpackSnorm2x16(wordsB.x));
  vec3 size = vec3(float(wordsB.y & 65535u), float(wordsB.y >> 16), float(wordsB.z & 65535u)) * 0.0001;
  float sku = float(wordsB.z >> 16);
  float round = float(wordsC.w >> 24); // 0 box, 1 post, 2 ball
  vec3 local = vec3(corner.xy * 0.5 * size.xy, corner.z * size.z);
  float s = side;
  vec2 uv = s < 0.5 ? vec2(corner.x, corner.z) : s < 1.5 ? vec2(corner.y, corner.z) : s < 2.5 ? vec2(-corner.x, corner.z)
      : s < 3.5 ? vec2(-corner.y, corner.z) : vec2(corner.x, corner.y * 0.5 + 0.5);
  uv.x = uv.x * 0.5 + 0.5;
  vec3 at = place + turned(local);
  if (round > 0.5) {
    vec3 axis = turned(vec3(0.0, 0.0, 1.0));
    vec3 eye = cameraPosition - place;
    if (s < 0.5) {
      vec3 across = normalize(cross(axis, eye));
      vec3 up = axis;
      vec3 middle = place;
      if (round > 1.5) {
        up = normalize(cross(eye, across));
        middle += axis * size.z * 0.5 - up * size.z * 0.5;
      }
      at = middle + across * corner.x * 0.5 * max(size.x, size.y) + up * corner.z * size.z;
    } else if (s > 3.5 && round < 1.5) {
      at = place + turned(vec3(corner.xy * 0.5 * size.xy, size.z * 0.93));
    } else {
      at = place; // no such side
    }
  }
  uint light = s < 0.5 ? wordsB.w : s < 1.5 ? wordsC.x : s < 2.5 ? wordsB.w : s < 3.5 ? wordsC.y : wordsC.z;
  vLight = lightOf(bytes(light));
  vBase = linearOf(bytes(wordsC.w));
  float cell = sku * 3.0 + (s > 3.5 ? 2.0 : mod(s, 2.0));
  vec2 inset = 1.5 / cellTexels;
  vUv = (vec2(mod(cell, cells.x), floor(cell / cells.x)) + mix(inset, 1.0 - inset, uv)) / cells;
  gl_Position = projectionMatrix * viewMatrix * vec4(at, 1.0);
}
`;
const standInFragment = /* glsl */ `
uniform sampler2D pictures;
uniform float uDim;
in vec3 vBase, vLight;
in vec2 vUv;
out vec4 outColor;
void main() {
  vec3 base = vBase;
#ifdef PICTURES
  vec4 picture = texture(pictures, vUv);
  if (picture.a < 0.5) discard;
  base *= linearOf(picture.rgb / picture.a);
#endif
  outColor = vec4(shown(base * vLight, uDim), 1.0);
}
`;

export function standInMaterial(shared: Shared, uniforms: Record<string, IUniform>, pictures: boolean): RawShaderMaterial {
  return material(standInVertex, standInFragment, { ...shared, ...uniforms }, pictures ? { PICTURES: "1" } : {});
}

// Draws the pictures of the stand-ins: vertices come in clip space already.
const portraitVertex = /* glsl */ `
in vec3 position;
in vec2 uv;
in vec4 color;
in float page;
out vec3 vBase;
out vec2 vUv;
flat out int vPage;
void main() {
  vBase = color.rgb;
  vUv = uv;
  vPage = int(page);
  gl_Position = vec4(position, 1.0);
}
`;
const portraitFragment = /* glsl */ `
uniform sampler2DArray atlas;
in vec3 vBase;
in vec2 vUv;
flat in int vPage;
out vec4 outColor;
void main() {
  vec3 base = vBase;
  if (vPage >= 0) base *= texture(atlas, vec3(vUv, float(vPage))).rgb;
  outColor = vec4(base, 1.0);
}
`;

export function portraitMaterial(uniforms: Record<string, IUniform>): RawShaderMaterial {
  const made = material(portraitVertex, portraitFragment, uniforms, {});
  made.side = DoubleSide;
  return made;
}
