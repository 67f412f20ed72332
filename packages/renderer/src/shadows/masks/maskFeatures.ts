import { BasicShadowMap, type Light, VSMShadowMap } from 'three';
import { classifyLight } from '../../lights/classifyLight';
import { softSizeOf } from '../slots/AreaShadowLight';
import type { ShadowSlot } from '../slots/ShadowSlot';

/**
 * Features of shadows and cookies that shaders can have code for, as bits. `defines` has their macros in maskFeatures.glsl;
 * `basic`, `pcf` and `variance` are bits of FAROL_SHADOW_LOOKUPS; `images` needs samplers.
 */
export const maskFeatures = {
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
  profiles: 2048,
  soft: 4096,
  images: 8192,
} as const;

const defines: Record<Exclude<keyof typeof maskFeatures, 'basic' | 'pcf' | 'variance' | 'images'>, string> = {
  maps: 'FAROL_SHADOW_MAPS',
  cubes: 'FAROL_SHADOW_CUBES',
  cascades: 'FAROL_SHADOW_CASCADES',
  cookies: 'FAROL_LIGHT_COOKIES',
  unshadowed: 'FAROL_UNSHADOWED_MASKS',
  unbounded: 'FAROL_UNBOUNDED_MASKS',
  bounded: 'FAROL_BOUNDED_MASKS',
  point: 'FAROL_POINT_MASKS',
  profiles: 'FAROL_LIGHT_PROFILES',
  soft: 'FAROL_SOFT_SHADOWS',
};

/**
 * Feature bit of the loop in shading.glsl that shades a kind of light: only loops whose bit is set read shadows and cookies.
 */
export function maskLoopOf(light: Light): number {
  const kind = classifyLight(light);
  if (kind === 'directional' || kind === 'unbounded') return maskFeatures.unbounded;
  return kind === 'point' ? maskFeatures.point : maskFeatures.bounded;
}

/**
 * Shader features that a light needs, as bits of `maskFeatures`.
 * @param type - of maps, as `WebGLRenderer.shadowMap.type`
 */
export function maskFeaturesOf(
  { hasShadow, isCube, cascades, cookie, profile, light, hasLeftMap }: ShadowSlot,
  type: number,
): number {
  // the shaders of area lights sample masks themselves, not in the loops of `maskLoopOf`
  if (softSizeOf(light) > 0) return maskFeatures.cubes | maskFeatures.soft | (hasShadow ? 0 : maskFeatures.unshadowed);
  let features = maskLoopOf(light);
  // a point light that moved since its map was drawn is shaded in the loop of other lights with a range
  if (hasLeftMap) features |= maskFeatures.bounded;
  if (profile !== null) features |= maskFeatures.profiles;
  if (!hasShadow && cookie === null) return features | maskFeatures.unshadowed;
  features |= isCube ? maskFeatures.cubes : maskFeatures.maps;
  if (cascades > 0) features |= maskFeatures.cascades;
  if (cookie !== null) features |= maskFeatures.cookies;
  // samplers are needed besides the code for copies: only what lights project beyond the number of samplers is copied
  if (cookie !== null && !cookie.isCube) features |= maskFeatures.images;
  if (!hasShadow) return features | maskFeatures.unshadowed;
  if (type === VSMShadowMap) return features | maskFeatures.variance;
  return features | (type === BasicShadowMap ? maskFeatures.basic : maskFeatures.pcf);
}

/** Text of the chunk `maskFeatures` for the given features only, since code for unused ones would slow shaders down. */
export function maskFeaturesChunk(features: number): string {
  const lines = ['// Shadow maps, cookies and profiles that shaders have code for: those used so far.', '// Farol'];
  const { basic, pcf, variance } = maskFeatures;
  lines.push(`#define FAROL_SHADOW_LOOKUPS ${(features & (basic | pcf | variance)) / basic}`);
  for (const [name, define] of Object.entries(defines)) {
    if ((features & maskFeatures[name as keyof typeof maskFeatures]) !== 0) lines.push(`#define ${define}`);
  }
  return `${lines.join('\n')}\n`;
}
