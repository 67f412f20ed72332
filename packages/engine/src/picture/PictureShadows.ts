import type { FarolRenderer } from '@farol/renderer';
import { BasicShadowMap, PCFShadowMap, type ShadowMapType, VSMShadowMap } from 'three';
import type { SceneSettings } from '../settings/SceneSettings';

type ShadowKind = SceneSettings['shadowKind'];

const types: Readonly<Record<Exclude<ShadowKind, 'none'>, ShadowMapType>> = {
  hard: BasicShadowMap,
  soft: PCFShadowMap,
  variance: VSMShadowMap,
};

/** Has a renderer draw shadows of the kind and with the cascades that a scene asks for. */
export class PictureShadows {
  /** What the renderer has taken; a scene that asks for the same leaves alone what its host has set. */
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
