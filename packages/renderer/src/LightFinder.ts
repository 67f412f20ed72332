import type { Camera, Object3D, WebGLRenderer } from 'three';
import { collectLights, type FoundLights } from './collectLights';
import { shadowCode } from './late';
import type { ShadowMaps } from './shadows/ShadowMaps';

/** Lights with a shadow or an image that three has texture units for; more go without until Farol draws them. */
const FEW_MASKS = 4;

type ShadowCode = NonNullable<(typeof shadowCode)['code']>;

/** Finds the lights of a frame, and asks for what masks them when one casts a shadow or throws an image. */
export class LightFinder {
  readonly found: FoundLights = { all: [], count: 0, nested: [], rest: [], seeksMasks: true, masks: 0 };
  /** What three goes on drawing itself. */
  readonly left = { shadows: false, cookies: true };
  /** Null until a scene has asked for what masks lights, and its code is there. */
  shadows: ShadowMaps | null = null;
  /** Whether the last scene has what masks lights; not looked at once `shadows` are there. */
  asksForShadows = false;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly makeShadows: (code: ShadowCode) => ShadowMaps,
  ) {}

  /**
   * @param layers whether lights reach only objects of their layers, which takes masks too
   * @param update brings the world matrices of the scene up to date. Default false
   */
  find(scene: Object3D, camera: Camera, layers: boolean, update = false): void {
    const { found, left } = this;
    left.cookies = this.shadows === null;
    left.shadows = left.cookies && this.webgl.shadowMap.enabled;
    collectLights(scene, camera, left, found, update);
    this.asksForShadows = found.masks > 0 || layers;
    if (this.shadows !== null || !this.asksForShadows) return;
    if (shadowCode.code === null) {
      shadowCode.ask();
      if (found.masks <= FEW_MASKS) return;
    } else {
      this.shadows = this.makeShadows(shadowCode.code);
      found.seeksMasks = false;
    }
    left.shadows = left.cookies = false;
    collectLights(scene, camera, left, found);
  }

  /** Frees the shadow maps; a scene may ask for them again. */
  dispose(): void {
    this.shadows?.dispose();
    this.shadows = null;
    this.found.seeksMasks = true;
  }
}
