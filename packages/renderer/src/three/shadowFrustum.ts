import { Frustum, type LightShadow } from 'three';

interface FrustumOfShadow {
  readonly _frustum: Frustum;
}

/** Name of LightShadow's private frustum, by which three culls casters. */
export const SHADOW_FRUSTUM = '_frustum';

export function copyShadowFrustum(from: LightShadow, to: LightShadow): void {
  (to as unknown as FrustumOfShadow)._frustum.copy((from as unknown as FrustumOfShadow)._frustum);
}
