import type { MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';

/** Light shapes, as bits of `areaShapes`, that each registry's shaders have code for. Bits are only ever added. */
const known = new WeakMap<MicroShaderRegistry, number>();

/**
 * GLSL text of the microshader `areaFeatures`.
 * @param shapes - bits of `areaShapes`
 */
export const areaFeaturesChunk = (shapes: number): string =>
  `// What shaders have code for: the shapes of area lights met so far.
// Farol
#define FAROL_AREA_SHAPES ${shapes} // bits: 1 rectangles, 2 discs, 4 tubes
`;

/** Adds a shape to the shaders, which leave out shapes that no light has. @param shape - one of `areaShapes` */
export function needShape(registry: MicroShaderRegistry, shape: number): void {
  const before = known.get(registry) ?? 0;
  const shapes = before | (1 << shape);
  if (shapes === before) return;
  known.set(registry, shapes);
  registry.swap('areaFeatures', parseMicroShader('areaFeatures', areaFeaturesChunk(shapes)));
}
