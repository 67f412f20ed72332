import type { FarolRenderer } from '@farol/renderer';
import { BasicShadowMap, PCFShadowMap, type ShadowMapType, VSMShadowMap } from 'three';
import type { SceneSettings } from '../settings/SceneSettings';

type ShadowKind = SceneSettings['shadowKind'];

const types: Readonly<Record<Exclude<ShadowKind, 'none'>, ShadowMapType>> = {
  hard: BasicShadowMap,
  soft: PCFShadowMap,
  variance: VSMShadowMap,
};

/** Applies a scene's shadow kind and number of cascades to a renderer. */
export class PictureShadows {
  /** Shadow kind last applied to the WebGLRenderer; not applied again, so a host's own setting survives. */
  private kind: ShadowKind = 'soft';
  private cascades = 1;
  private wasEnabled = true;

  constructor(private readonly farol: FarolRenderer) {}

  follow({ shadowKind, shadowCascades }: SceneSettings): void {
    if (shadowCascades !== this.cascades) this.farol.shadowCascades = this.cascades = shadowCascades;
    if (shadowKind === this.kind) return;
    const { shadowMap } = this.farol.webgl;
    if (this.kind === 'none') shadowMap.enabled = this.wasEnabled;
    if (shadowKind === 'none') {
      this.wasEnabled = shadowMap.enabled;
      shadowMap.enabled = false;
    } else shadowMap.type = types[shadowKind];
    this.kind = shadowKind;
  }
}
