// How robots and moved goods are drawn: base colour times the ambient cube that is given, through the renderer's film curve.
import type { IUniform, RawShaderMaterial } from "three";
import { material, type Shared } from "../stage/shading";

const vertex = /* glsl */ `
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
uniform vec3 cube[6];
in vec3 position;
in vec3 normal;
in vec4 color;
#ifdef LABELLED
in vec2 uv;
in float page;
#endif
out vec3 vBase, vResponse;
out vec2 vPlace;
flat out int vPage;
void main() {
  vec3 n = normalize(mat3(modelMatrix) * normal);
  vec3 x = n.x >= 0.0 ? cube[0] : cube[1];
  vec3 y = n.y >= 0.0 ? cube[2] : cube[3];
  vec3 z = n.z >= 0.0 ? cube[4] : cube[5];
  vec4 hue = hueOf(sqrt(n.x * n.x * x * x + n.y * n.y * y * y + n.z * n.z * z * z));
  vBase = color.rgb * hue.rgb;
  vResponse = responseIn(hue.a);
  vPlace = vec2(0.0);
  vPage = -1;
#ifdef LABELLED
  vPlace = uv;
  if (color.a > 0.5) vPage = int(page);
#endif
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
}
`;
const fragment = /* glsl */ `
#ifdef LABELLED
uniform sampler2DArray atlas;
#endif
uniform float uDim;
in vec3 vBase, vResponse;
in vec2 vPlace;
flat in int vPage;
out vec4 outColor;
void main() {
  vec3 base = vBase;
#ifdef LABELLED
  if (vPage >= 0) base *= texture(atlas, vec3(vPlace, float(vPage))).rgb;
#endif
#ifdef CLEAR
  outColor = vec4(shown(base, vResponse, uDim), 0.78);
#else
  outColor = vec4(shown(base, vResponse, uDim), 1.0);
#endif
}
`;

export type Wear = "LABELLED" | "CLEAR";

export function actorMaterial(shared: Shared, uniforms: Record<string, IUniform>, wear: readonly Wear[] = []): RawShaderMaterial {
  const made = material(vertex, fragment, { ...shared, ...uniforms }, Object.fromEntries(wear.map((name) => [name, "1"])));
  if (wear.includes("CLEAR")) Object.assign(made, { transparent: true, depthWrite: false });
  return made;
}
