import type { MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';

/** Kinds of area lights, as bits, that each registry's shaders have code for. Bits are only ever added. */
const known = new WeakMap<MicroShaderRegistry, number>();

/** Bits of lights with a range, and of those without, above the bits of `areaShapes`. */
const BOUNDED = 8;
const UNBOUNDED = 16;

/**
 * GLSL text of the microshader `areaFeatures`.
 * @param kinds - bits of `areaShapes`, and of lights with and without a range
 */
export const areaFeaturesChunk = (kinds: number): string =>
  `// What shaders have code for: the kinds of area lights met so far.
// Farol
#define FAROL_AREA_KINDS ${kinds} // bits: 1 rectangles, 2 discs, 4 tubes; 8 with a range, 16 without
`;

/**
 * Adds a kind of area light to the shaders, which leave out kinds that no light has.
 * @param shape - one of `areaShapes`
 */
export function needArea(registry: MicroShaderRegistry, shape: number, hasRange: boolean): void {
  const before = known.get(registry) ?? 0;
  const kinds = before | (1 << shape) | (hasRange ? BOUNDED : UNBOUNDED);
  if (kinds === before) return;
  known.set(registry, kinds);
  registry.swap('areaFeatures', parseMicroShader('areaFeatures', areaFeaturesChunk(kinds)));
}
