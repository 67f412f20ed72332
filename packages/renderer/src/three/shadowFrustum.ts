import { Frustum, type LightShadow } from 'three';

interface FrustumOfShadow {
  readonly _frustum: Frustum;
}

/** Name of the frustum of a LightShadow, by which three leaves casters out. */
export const SHADOW_FRUSTUM = '_frustum';

export function copyShadowFrustum(from: LightShadow, to: LightShadow): void {
  (to as unknown as FrustumOfShadow)._frustum.copy((from as unknown as FrustumOfShadow)._frustum);
}
