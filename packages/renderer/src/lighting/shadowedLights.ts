import { VSMShadowMap, type WebGLRenderer } from 'three';
import type { ShadowedLights } from '../lights/classifyLight';

/** Lights that get shadow maps by the settings of a WebGLRenderer. */
export function shadowedLights({ shadowMap }: WebGLRenderer): ShadowedLights {
  if (!shadowMap.enabled) return 'none';
  return shadowMap.type === VSMShadowMap ? 'all-but-points' : 'all';
}
