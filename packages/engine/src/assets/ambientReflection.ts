import { Color, type Material, type WebGLProgramParametersWithUniforms } from 'three';

/** Chunk before which ambient, environment and lightmap light are computed, and after which they are summed. */
const AFTER = '#include <aomap_fragment>';

const reflections = new WeakMap<Material, Color>();

function reflect(this: Material, shader: WebGLProgramParametersWithUniforms): void {
  shader.uniforms.ambientReflection = { value: reflections.get(this) };
  // the renderer's shaders read the reflectance of ambient light as FAROL_AMBIENT_FACTOR
  shader.fragmentShader = `uniform vec3 ambientReflection;\n#define FAROL_AMBIENT_FACTOR ambientReflection\n${shader.fragmentShader.replace(
    AFTER,
    `${AFTER}\n\treflectedLight.indirectDiffuse *= ambientReflection;`,
  )}`;
}

/** Whether the material reflects ambient light in another colour than other light. */
export const hasAmbientReflection = (material: Material): boolean => material.onBeforeCompile === reflect;

/**
 * Sets a material's reflectance of ambient light (the thesis's ambient reflection; linear colour), a factor of three's
 * ambient light and of the ambient colours of lights. White equals three, and costs nothing.
 */
export function setAmbientReflection(material: Material, [r, g, b]: readonly [number, number, number]): void {
  if (r === 1 && g === 1 && b === 1) {
    if (hasAmbientReflection(material)) Reflect.deleteProperty(material, 'onBeforeCompile');
    return;
  }
  const colour = reflections.get(material) ?? new Color();
  colour.setRGB(r, g, b);
  reflections.set(material, colour);
  material.onBeforeCompile = reflect;
}
