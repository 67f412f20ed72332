import { BasicShadowMap, type Light, VSMShadowMap } from 'three';
import { classifyLight } from '../../../lights/classifyLight';
import type { ShadowSlot } from '../slots/ShadowSlot';

/** Bits of what shaders can know of masks, and the definition of each in maskKinds.glsl. */
export const maskKinds = {
  maps: 1,
  cubes: 2,
  cascades: 4,
  basic: 8,
  pcf: 16,
  variance: 32,
  cookies: 64,
  unshadowed: 128,
  unbounded: 256,
  bounded: 512,
  point: 1024,
} as const;

const defines: Record<keyof typeof maskKinds, string> = {
  maps: 'FAROL_SHADOW_MAPS',
  cubes: 'FAROL_SHADOW_CUBES',
  cascades: 'FAROL_SHADOW_CASCADES',
  basic: 'FAROL_BASIC_SHADOWS',
  pcf: 'FAROL_PCF_SHADOWS',
  variance: 'FAROL_VARIANCE_SHADOWS',
  cookies: 'FAROL_LIGHT_COOKIES',
  unshadowed: 'FAROL_UNSHADOWED_MASKS',
  unbounded: 'FAROL_UNBOUNDED_MASKS',
  bounded: 'FAROL_BOUNDED_MASKS',
  point: 'FAROL_POINT_MASKS',
};

/** Which loop over lights must know of the mask of one; as in shading.glsl. */
export function maskLoopOf(light: Light): number {
  const kind = classifyLight(light);
  if (kind === 'directional' || kind === 'unbounded') return maskKinds.unbounded;
  return kind === 'point' ? maskKinds.point : maskKinds.bounded;
}

/** What shaders must know for a light. @param type of shadow maps, as `WebGLRenderer.shadowMap.type` has it */
export function maskKindsOf({ shows, isCube, cascades, cookie, light, isLeft }: ShadowSlot, type: number): number {
  let kinds = maskLoopOf(light);
  // it takes the long way then
  if (isLeft) kinds |= maskKinds.bounded;
  if (!shows && cookie === null) return kinds | maskKinds.unshadowed;
  kinds |= isCube ? maskKinds.cubes : maskKinds.maps;
  if (cascades > 0) kinds |= maskKinds.cascades;
  if (cookie !== null) kinds |= maskKinds.cookies;
  if (!shows) return kinds | maskKinds.unshadowed;
  if (type === VSMShadowMap) return kinds | maskKinds.variance;
  return kinds | (type === BasicShadowMap ? maskKinds.basic : maskKinds.pcf);
}

/** The chunk `maskKinds` for some of the kinds: code that nothing needs slows down what does. */
export function maskKindsChunk(kinds: number): string {
  const lines = ['// The kinds of shadow maps and cookies that have been met.', '// Farol'];
  for (const [name, define] of Object.entries(defines)) {
    if ((kinds & maskKinds[name as keyof typeof maskKinds]) !== 0) lines.push(`#define ${define}`);
  }
  return `${lines.join('\n')}\n`;
}
