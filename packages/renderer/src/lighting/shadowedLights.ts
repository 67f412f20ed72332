import { VSMShadowMap, type WebGLRenderer } from 'three';
import type { ShadowedLights } from '../lights/classifyLight';

/** Kinds of lights that have shadow maps, by a WebGLRenderer's settings. */
export function shadowedLights({ shadowMap }: WebGLRenderer): ShadowedLights {
  if (!shadowMap.enabled) return 'none';
  return shadowMap.type === VSMShadowMap ? 'all-but-points' : 'all';
}
