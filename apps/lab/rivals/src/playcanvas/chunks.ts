/**
 * Replacements, by a documented interface, for parts of PlayCanvas's shaders whose formulas differ from three's, with
 * the same work per light.
 */
import {
  type GraphicsDevice,
  SEMANTIC_ATTR10,
  SEMANTIC_ATTR11,
  SEMANTIC_ATTR12,
  SEMANTIC_ATTR14,
  SEMANTIC_ATTR15,
  SHADERLANGUAGE_GLSL,
  ShaderChunks,
} from 'playcanvas';

/** Falloff 1 / d², windowed like three's and that of KHR_lights_punctual. */
const falloff = `
float getFalloffWindow(float lightRadius, vec3 lightDir) {
  float squared = dot(lightDir, lightDir) / (lightRadius * lightRadius);
  return square(saturate(1.0 - squared * squared));
}
float getFalloffInvSquared(float lightRadius, vec3 lightDir) {
  return getFalloffWindow(lightRadius, lightDir) / max(dot(lightDir, lightDir), 0.01);
}`;

/** Normal map with factors for x and y; the tangent frame that PlayCanvas derives has its bitangent along -v. */
const normalMap = `
#ifdef STD_NORMAL_TEXTURE
  uniform vec2 farol_normalScale;
#endif
void getNormal() {
#ifdef STD_NORMAL_TEXTURE
  vec3 normalMap = {STD_NORMAL_TEXTURE_DECODE}(texture2DBias({STD_NORMAL_TEXTURE_NAME}, {STD_NORMAL_TEXTURE_UV}, {STD_TEXTURE_BIAS}));
  normalMap.xy *= farol_normalScale;
  dNormalW = normalize(dTBN * normalMap);
#else
  dNormalW = dVertexNormalW;
#endif
}`;

const instancing = `
attribute vec4 instance_line1;
attribute vec4 instance_line2;
attribute vec4 instance_line3;
attribute vec4 instance_line4;
attribute vec3 instance_colour;
varying vec3 vInstanceColour;
mat4 getModelMatrix() {
  vInstanceColour = instance_colour;
  return matrix_model * mat4(instance_line1, instance_line2, instance_line3, instance_line4);
}`;

/** Attributes of instances with colours, by name in the shader. */
export const instanceAttributes = {
  instance_line1: SEMANTIC_ATTR11,
  instance_line2: SEMANTIC_ATTR12,
  instance_line3: SEMANTIC_ATTR14,
  instance_line4: SEMANTIC_ATTR15,
  instance_colour: SEMANTIC_ATTR10,
} as const;

/** Chunks of a material whose instances have colours. */
export const instanceColourChunks = {
  transformInstancingVS: instancing,
  litUserDeclarationPS: 'varying vec3 vInstanceColour;',
} as const;

/** PlayCanvas's chunk, multiplied by the instance's colour: diffuse for lit materials, emission for others. */
export function multiplyByInstanceColour(device: GraphicsDevice, chunk: 'diffusePS' | 'emissivePS'): string {
  const source = ShaderChunks.get(device, SHADERLANGUAGE_GLSL).get(chunk);
  const [name, end] = [chunk === 'diffusePS' ? 'dAlbedo' : 'dEmission', source.lastIndexOf('}')];
  return `${source.slice(0, end)}  ${name} *= vInstanceColour;\n}`;
}

/** Replaces falloff, highlights and sRGB curve by three's. @throws Error when a chunk differs from PlayCanvas 2.23's */
export function agreeWithThree(device: GraphicsDevice): void {
  const chunks = ShaderChunks.get(device, SHADERLANGUAGE_GLSL);
  const replace = (name: string, from: string, to: string): void => {
    const source = chunks.get(name);
    if (!source?.includes(from)) throw new Error(`PlayCanvas’s shader chunk ${name} has changed: update chunks.ts.`);
    chunks.set(name, source.replace(from, to));
  };
  chunks.set('falloffInvSquaredPS', falloff);
  chunks.set('normalMapPS', normalMap);
  // light colours are divided by π, since PlayCanvas's diffuse term is not
  replace('lightSpecularGGXPS', 'return D * G;', 'return D * G * PI;');
  // Smith's visibility term with alpha², where PlayCanvas has alpha⁴
  replace('lightSpecularGGXPS', 'float alpha2 = alpha * alpha;', 'float alpha2 = alpha;');
  // Schlick's Fresnel term goes up to 1, as in three
  replace('fresnelSchlickPS', 'max(vec3(glossSq * specIntensity), specularity)', 'vec3(1.0)');
  replace(
    'gammaPS',
    'return pow(color + 0.0000001, vec3(1.0 / 2.2));',
    'return mix(color * 12.92, 1.055 * pow(color + 0.0000001, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), color));',
  );
}
