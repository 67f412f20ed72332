import type { MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';

/** Kinds of area lights, as bits, that each registry's shaders have code for; bits are never removed. */
const known = new WeakMap<MicroShaderRegistry, number>();

/** Bits for lights with a range, and for lights without, above the bits of `areaShapes`. */
const BOUNDED = 8;
const UNBOUNDED = 16;

/**
 * GLSL text of the microshader `areaFeatures`.
 * @param kinds - bits of `areaShapes`, `BOUNDED` and the bit of lights without a range
 */
export const areaFeaturesChunk = (kinds: number): string =>
  `// Kinds of area lights that shaders have code for: those used so far.
// Farol
#define FAROL_AREA_KINDS ${kinds} // bits: 1 rectangles, 2 discs, 4 tubes; 8 with a range, 16 without
`;

/** Adds code for a kind of area light to the shaders, which only have kinds in use. @param shape - one of `areaShapes` */
export function needArea(registry: MicroShaderRegistry, shape: number, hasRange: boolean): void {
  const before = known.get(registry) ?? 0;
  const kinds = before | (1 << shape) | (hasRange ? BOUNDED : UNBOUNDED);
  if (kinds === before) return;
  known.set(registry, kinds);
  registry.swap('areaFeatures', parseMicroShader('areaFeatures', areaFeaturesChunk(kinds)));
}
