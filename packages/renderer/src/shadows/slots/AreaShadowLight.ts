import { type Light, MathUtils, PointLight, type RectAreaLight } from 'three';
import type { FarolLightData } from '../../lights/lightData';

/** Default width of a face of an area light's shadow map (texels), before it is fitted to the picture. */
const TEXELS = 1024;
const LEAST_TEXELS = 16;
const MOST_TEXELS = 8192;
/** Default normal bias (m); a bias in depth would grow with a surface's distance. */
const NORMAL_BIAS = 0.03;
/** Near plane of the map (m). */
const NEAR = 0.05;

const lightsOfAreas = new WeakMap<RectAreaLight, AreaShadowLight>();

/** The point light at the centre of an area light, from which its shadow map is drawn: three's RectAreaLight has no shadow. */
export class AreaShadowLight extends PointLight {
  readonly isAreaShadowLight = true;
  /** Radius (m) of a disc as large as the area light; sets the softness of its shadows. */
  size = 0;

  /** @param host - the area light */
  private constructor(readonly host: RectAreaLight) {
    super();
    this.castShadow = true;
    this.shadow.camera.near = NEAR;
  }

  /**
   * Shadow light of an area light, moved to the area light's position.
   * @param range - distance beyond which the light gives nothing (m), 0 for unlimited
   */
  static follow(light: RectAreaLight, range: number): AreaShadowLight {
    let stand = lightsOfAreas.get(light);
    if (stand === undefined) lightsOfAreas.set(light, (stand = new AreaShadowLight(light)));
    stand.matrixWorld.copy(light.matrixWorld);
    stand.distance = range;
    stand.layers.mask = light.layers.mask;
    stand.size = 0.5 * Math.sqrt(light.width * light.height);
    const { shadowMapSize, shadowNormalBias } = (light.userData.farol ?? {}) as FarolLightData;
    // a size of NaN (not set) becomes the default
    stand.shadow.mapSize.setScalar(MathUtils.clamp(Math.round(shadowMapSize!) || TEXELS, LEAST_TEXELS, MOST_TEXELS));
    stand.shadow.normalBias = shadowNormalBias! >= 0 ? shadowNormalBias! : NORMAL_BIAS;
    return stand;
  }

  /** Shadow light of an area light; undefined before `follow`. */
  static of(light: RectAreaLight): AreaShadowLight | undefined {
    return lightsOfAreas.get(light);
  }
}

/** Half the size of the area light that casts a map's shadows (m); 0 for another light. */
export function softSizeOf(light: Light): number {
  const stand = light as Partial<AreaShadowLight>;
  return stand.isAreaShadowLight === true ? stand.size! : 0;
}
