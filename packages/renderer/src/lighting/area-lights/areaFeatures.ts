import type { MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';
import { areaShapes } from './areaRecord';

const defines = {
  rectangle: 'FAROL_AREA_RECTANGLES',
  disc: 'FAROL_AREA_DISCS',
  tube: 'FAROL_AREA_TUBES',
} as const satisfies Record<keyof typeof areaShapes, string>;

/** Shapes that the shaders of each registry have code for, as bits by `areaShapes`. They grow, and never shrink. */
const known = new WeakMap<MicroShaderRegistry, number>();

/** Text of the chunk `areaFeatures`. @param shapes - bits, by `areaShapes` */
export function areaFeaturesChunk(shapes: number): string {
  const lines = ['// What shaders have code for: the shapes of area lights met so far.', '// Farol'];
  for (const [shape, bit] of Object.entries(areaShapes)) {
    if ((shapes & (1 << bit)) !== 0) lines.push(`#define ${defines[shape as keyof typeof areaShapes]}`);
  }
  return `${lines.join('\n')}\n`;
}

/** Adds a shape to the shaders, which leave out shapes that no light has. @param shape - one of `areaShapes` */
export function needShape(registry: MicroShaderRegistry, shape: number): void {
  const before = known.get(registry) ?? 0;
  const shapes = before | (1 << shape);
  if (shapes === before) return;
  known.set(registry, shapes);
  registry.swap('areaFeatures', parseMicroShader('areaFeatures', areaFeaturesChunk(shapes)));
}
