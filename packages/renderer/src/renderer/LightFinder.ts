import type { Camera, Object3D, WebGLRenderer } from 'three';
import { FoundLights } from '../lights/FoundLights';
import { collectLights } from './collectLights';
import { areaCode, shadowCode } from './lazyCode';
import type { AreaLightTable } from '../lighting/area-lights/AreaLightTable';
import { threeChunks } from '../three/ThreeChunks';
import type { ShadowMaps } from '../shadows/ShadowMaps';

/** Maximum number of lights with shadow maps or images, which take texture units, left to three until code is loaded. */
const FEW_MASKS = 4;

/** Number of uniform vectors of three's lit shaders without lights, and number that one spot light adds. */
const UNIFORMS = 100;
const UNIFORMS_PER_LIGHT = 7;

type ShadowCode = typeof import('../shadows');
type AreaCode = typeof import('../lighting/area-lights');

/** Finds the lights of a frame, and fetches the code of shadow maps when one casts a shadow or projects an image. */
export class LightFinder {
  readonly found = new FoundLights();
  /** Kinds of lights left to three: lights with shadows, lights with cookies, area lights, or all. */
  readonly left = { shadows: false, cookies: true, areas: true, all: false };
  /** Area lights; null until a scene has one and their code is loaded. */
  areas: AreaLightTable | null = null;
  /** Shadow maps; null until a scene needs maps, cookies or light layers, and their code is loaded. */
  shadows: ShadowMaps | null = null;
  private warned = false;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly makeShadows: (code: ShadowCode) => ShadowMaps,
    private readonly makeAreas: (code: AreaCode) => AreaLightTable,
  ) {}

  /**
   * @param layers - whether lights reach only objects of their layers
   * @param update - whether to update the world matrices of the scene. Default false
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

  /** Frees the shadow maps and area lights; a later frame that needs them creates them again. */
  dispose(): void {
    this.shadows?.dispose();
    this.shadows = null;
    this.areas?.dispose();
    this.areas = null;
    this.left.areas = true;
    this.found.seeksMasks = true;
  }

  /** Whether three's shaders have too few uniforms for the lights; warns once. */
  private exceedThree(): boolean {
    const most = Math.floor((this.webgl.capabilities.maxFragmentUniforms - UNIFORMS) / UNIFORMS_PER_LIGHT);
    if (this.found.left <= most) return false;
    if (!this.warned) {
      this.warned = true;
      console.warn(
        `Farol: materials whose onBeforeCompile removes or changes #include <lights_fragment_begin> are unlit: only three can light them, and its shaders hold ${most} of the ${this.found.left} lights; keep that line.`,
      );
    }
    return true;
  }
}
