// How light becomes colour: base colour times stored light, then the renderer's film curve. Colours stay sRGB-encoded all the way.
//
// The curve comes from the server with the goods (render/tone.h: FilmTable). It is taken at the vertices, for three greys of the
// texture (0.3, 0.6 and 0.95 of white) in the light that is there; the points of the picture take the cubic through these: 2.5 bytes RMS
// from the exact curve over random colours and light, at a tenth of its cost a point, which is what WebGL without a GPU is slow at.
import { DoubleSide, GLSL3, RawShaderMaterial, type IUniform, type Texture } from "three";
import { PackedError } from "../store/packed";

const atVertex = /* glsl */ `
uniform vec3 uResponse[RESPONSES];
// The cubic's coefficients (of x, x^2, x^3) in light so bright.
vec3 responseIn(float light) {
  float at = min(sqrt(light) * RESPONSES_PER_ROOT, float(RESPONSES) - 1.001);
  int low = int(at);
  return mix(uResponse[low], uResponse[low + 1], at - float(low));
}
// Of the server's light bytes, whose square times four is the light: its colour as a factor of encoded colours, and its brightness.
vec4 hueOf(vec3 byte) {
  float root = sqrt(dot(byte * byte, vec3(0.2126, 0.7152, 0.0722)));
  vec3 x = byte / max(root, 3.2e-3);
  // x^(2 / 2.2) as Pade has it about 1: three powers would take as long as the rest of the vertex.
  vec3 hue = ((5.55372 * x + 6.34711) * x + 0.09917) / ((0.09917 * x + 6.34711) * x + 5.55372);
  return vec4(hue, root * root * 4.0);
}
`;

const atPoint = /* glsl */ `
// With other goods searched for, what was not found steps back.
vec3 shown(vec3 encoded, vec3 response, float dim) {
  vec3 c = encoded * (response.x + encoded * (response.y + encoded * response.z));
  if (dim > 0.0) c = mix(c, vec3(dot(c, vec3(0.2126, 0.7152, 0.0722)) * 0.55 + 0.22), dim);
  return c;
}
`;

const head = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2DArray;
`;

// Of the server's section "film": the film curve, sRGB-encoded, at quarters of a stop from 2^-13 on; 1 is a white sheet in the light
// that the store is exposed for.
const film = { values: 69, firstStop: -13, stepsPerStop: 4 };
const brightest = 4; // times that light: what a byte of 255 stands for
const responses = 129; // evenly over the root of the light
const greys = [-3.77124, -1.65042, -0.16811] as const; // stops of 0.3, 0.6 and 0.95 of white, encoded
// The cubic through what three greys become: its coefficients for each of them.
const throughGreys = [
  [9.74358974, -26.4957265, 17.09401709],
  [-4.52380952, 19.84126984, -15.87301587],
  [0.83285136, -4.1642568, 4.626952],
] as const;

export interface Shared {
  readonly uDim: IUniform<number>;
  readonly uResponse: IUniform<Float32Array>;
}

export function newShared(): Shared {
  return { uDim: { value: 0 }, uResponse: { value: new Float32Array(responses * 3) } };
}

export function setFilm(shared: Shared, curve: Float32Array): void {
  if (curve.length !== film.values) throw new PackedError(`a film curve of ${curve.length} values`);
  shared.uResponse.value = responsesOf(curve);
}

function filmAt(curve: Float32Array, stops: number): number {
  const at = Math.min(Math.max((stops - film.firstStop) * film.stepsPerStop, 0), film.values - 1.001);
  const low = Math.floor(at);
  return curve[low]! + (curve[low + 1]! - curve[low]!) * (at - low);
}

// The cubic's coefficients of x, x^2 and x^3, in light so bright: three numbers.
export function responseIn(curve: Float32Array, light: number): readonly [number, number, number] {
  const stops = Math.log2(Math.max(light, 1e-6));
  const seen = greys.map((grey) => filmAt(curve, stops + grey));
  const of = (power: 0 | 1 | 2): number => throughGreys.reduce((sum, through, i) => sum + through[power] * seen[i]!, 0);
  return [of(0), of(1), of(2)];
}

// For the shaders, which look them up: a vertex takes less time so, and so does compiling.
function responsesOf(curve: Float32Array): Float32Array {
  const table = new Float32Array(responses * 3);
  for (let i = 0; i < responses; i++) table.set(responseIn(curve, brightest * (i / (responses - 1)) ** 2), i * 3);
  return table;
}

export function material(vertex: string, fragment: string, uniforms: Record<string, IUniform>, defines: Record<string, string>): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: head + atVertex + vertex,
    fragmentShader: head + atPoint + fragment,
    uniforms,
    defines: { ...defines, RESPONSES: `${responses}`, RESPONSES_PER_ROOT: ((responses - 1) / Math.sqrt(brightest)).toFixed(1) },
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
out vec3 vBase, vResponse;
out vec2 vUv;
out float vSheen;
void main() {
  float graze = 1.0 - abs(dot(normalize(cameraPosition - position), normal));
  vec4 hue = hueOf(light.rgb);
  vBase = color.rgb * hue.rgb;
  vResponse = responseIn(hue.a);
  vUv = uv;
  vSheen = pow(clamp(graze, 0.0, 1.0), 5.0) * (1.0 - finish.x) * 0.25 * min(hue.a, 1.0);
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}
`;
const roomFragment = /* glsl */ `
uniform sampler2D map;
uniform float uDim;
in vec3 vBase, vResponse;
in vec2 vUv;
in float vSheen;
out vec4 outColor;
void main() {
  vec3 base = vBase;
#ifdef TEXTURED
  base *= texture(map, vUv).rgb;
#endif
  vec3 c = shown(base, vResponse, uDim) + vSheen;
#ifdef GLASS
  outColor = vec4(c, 0.12 + vSheen);
#else
  outColor = vec4(c, 1.0);
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
out vec3 vBase, vResponse;
out vec2 vPlace;
flat out ivec2 vWhere;
void main() {
  int row = int(sku);
  vec4 tile = texelFetch(skus, ivec2((row % 512) * 2, row / 512), 0);
  vec4 where = texelFetch(skus, ivec2((row % 512) * 2 + 1, row / 512), 0);
  vec4 hue = hueOf(light.rgb);
  vBase = color.rgb * hue.rgb;
  vResponse = responseIn(hue.a);
  vPlace = where.y >= 0.0 ? uv : tile.xy + uv * tile.zw;
  vWhere = color.a > 0.5 ? ivec2(int(where.x), int(where.y)) : ivec2(-1);
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}
`;
const packFragment = /* glsl */ `
uniform sampler2DArray atlas;
uniform sampler2DArray sheets;
uniform float uDim;
in vec3 vBase, vResponse;
in vec2 vPlace;
flat in ivec2 vWhere;
out vec4 outColor;
void main() {
  vec3 base = vBase;
  if (vWhere.y >= 0) base *= texture(sheets, vec3(vPlace, float(vWhere.y))).rgb;
  else if (vWhere.x >= 0) base *= texture(atlas, vec3(vPlace, float(vWhere.x))).rgb;
#ifdef CLEAR
  outColor = vec4(shown(base, vResponse, uDim), 0.78);
#else
  outColor = vec4(shown(base, vResponse, uDim), 1.0);
#endif
}
`;

export function packMaterial(shared: Shared, uniforms: Record<string, IUniform>, clear: boolean): RawShaderMaterial {
  const made = material(packVertex, packFragment, { ...shared, ...uniforms }, clear ? { CLEAR: "1" } : {});
  if (clear) Object.assign(made, { transparent: true, depthWrite: false });
  return made;
}

// Packs farther off: pictures of them on the sides of their box. What is round about an upright axis has a picture that turns with
// the eye: its corners lie `across` metres aside.
const standInVertex = /* glsl */ `
uniform mat4 viewMatrix, projectionMatrix;
uniform vec3 cameraPosition;
in vec3 position;
in vec2 uv;
in vec4 color;
in vec4 light;
in float across;
out vec3 vBase, vResponse;
out vec2 vUv;
out float vPlain; // 1: it has no picture
void main() {
  vPlain = 1.0 - color.a;
  vec2 eye = cameraPosition.xy - position.xy;
  vec3 at = position;
  at.xy += vec2(-eye.y, eye.x) * (across / max(length(eye), 1e-3));
  vec4 hue = hueOf(light.rgb);
#ifdef PLAIN
  vBase = color.rgb * (0.85 + 0.15 * min(hue.a, 1.0)); // figures in colours: hardly touched by the light
#else
  vBase = color.rgb * hue.rgb;
#endif
  vResponse = responseIn(hue.a);
  vUv = uv;
  gl_Position = projectionMatrix * viewMatrix * vec4(at, 1.0);
}
`;
const standInFragment = /* glsl */ `
uniform sampler2D pictures;
uniform float uDim;
in vec3 vBase, vResponse;
in vec2 vUv;
in float vPlain;
out vec4 outColor;
void main() {
  vec3 base = vBase;
#ifdef PLAIN
  outColor = vec4(base, 1.0);
  return;
#endif
#ifdef PICTURES
  vec4 picture = texture(pictures, vUv);
#ifdef CUT
  if (picture.a < 0.5) discard;
#endif
  base *= vPlain > 0.5 ? vec3(1.0) : picture.rgb / max(picture.a, 0.01);
#endif
  outColor = vec4(shown(base, vResponse, uDim), 1.0);
}
`;

// `wear`: nothing yet; pictures; pictures that are cut out; or the colours as they are.
export function standInMaterial(shared: Shared, uniforms: Record<string, IUniform>, wear: readonly ("PICTURES" | "CUT" | "PLAIN")[]): RawShaderMaterial {
  return material(standInVertex, standInFragment, { ...shared, ...uniforms }, Object.fromEntries(wear.map((name) => [name, "1"])));
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
