import type { Camera, Object3D, WebGLRenderer } from 'three';
import { collectLights, type FoundLights } from './collectLights';
import { areaCode, shadowCode } from './lazyCode';
import type { AreaLights } from '../lights/lightData';
import { threeChunks } from '../three/ThreeChunks';
import type { ShadowMaps } from '../shadows/ShadowMaps';

/** Lights with a shadow or an image that three has texture units for; more go without until Farol draws them. */
const FEW_MASKS = 4;

/** Vectors of three's lit shaders but for lights, and of a spot light. */
const UNIFORMS = 100;
const UNIFORMS_PER_LIGHT = 7;

type ShadowCode = typeof import('../shadows');
type AreaCode = typeof import('../lighting/area-lights');

/** Finds the lights of a frame, and fetches the code of shadow maps when one casts a shadow or throws a cookie. */
export class LightFinder {
  readonly found: FoundLights = {
    all: [],
    count: 0,
    nested: [],
    rest: [],
    seeksMasks: true,
    masks: 0,
    left: 0,
    hasArea: false,
  };
  /** Which lights three goes on drawing: those with shadows, those with cookies, area lights, or all of them. */
  readonly left = { shadows: false, cookies: true, areas: true, all: false };
  /** Null until a scene has an area light, and their code is there. */
  areas: AreaLights | null = null;
  /** Null until a scene needs shadow maps, cookies or light layers, and their code is there. */
  shadows: ShadowMaps | null = null;
  private warned = false;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly makeShadows: (code: ShadowCode) => ShadowMaps,
    private readonly makeAreas: (code: AreaCode) => AreaLights,
  ) {}

  /**
   * @param layers - whether lights reach only objects of their layers
   * @param update - brings the world matrices of the scene up to date. Default false
   * @param byThree - whether three is to draw all lights. Default false
   */
  find(scene: Object3D, camera: Camera, layers: boolean, update = false, byThree = false): void {
    const { found, left } = this;
    left.cookies = this.shadows === null;
    left.all = byThree || threeChunks.lights;
    left.shadows = (left.cookies || threeChunks.shadows) && this.webgl.shadowMap.enabled;
    collectLights(scene, camera, left, found, update);
    if (left.all && this.exceedThree()) {
      left.all = false;
      collectLights(scene, camera, left, found);
    }
    if (found.hasArea && !left.all && left.areas) {
      this.areas = areaCode.use(this.makeAreas);
      left.areas = this.areas === null;
      if (!left.areas) collectLights(scene, camera, left, found);
    }
    if (this.shadows !== null || !(found.masks > 0 || layers) || left.all) return;
    this.shadows = shadowCode.use(this.makeShadows);
    if (this.shadows !== null) found.seeksMasks = false;
    else if (found.masks <= FEW_MASKS) return;
    left.cookies = false;
    left.shadows = threeChunks.shadows && this.webgl.shadowMap.enabled;
    collectLights(scene, camera, left, found);
  }

  /** Frees the shadow maps, and what area lights need; a scene may ask for them again. */
  dispose(): void {
    this.shadows?.dispose();
    this.shadows = null;
    this.areas?.dispose();
    this.areas = null;
    this.left.areas = true;
    this.found.seeksMasks = true;
  }

  /** Whether the lights are more than three's shaders have uniforms for, which is told once. */
  private exceedThree(): boolean {
    const most = Math.floor((this.webgl.capabilities.maxFragmentUniforms - UNIFORMS) / UNIFORMS_PER_LIGHT);
    if (this.found.left <= most) return false;
    if (!this.warned) {
      this.warned = true;
      console.warn(
        `Farol: a changed lights chunk, or an onBeforeCompile without #include <lights_fragment_begin>, leaves three to draw ${this.found.left} lights; it can draw ${most}. These materials are drawn without lights.`,
      );
    }
    return true;
  }
}
