import type { DirectionalLight, HemisphereLight, Light, PointLight, RectAreaLight, SpotLight } from 'three';
import { type AreaRadii, type FarolLightData, lightRange } from './lightData';

const NO_DATA: FarolLightData = {};

type AnyLight = Partial<Pick<PointLight, 'isPointLight'>> &
  Partial<Pick<SpotLight, 'isSpotLight'>> &
  Partial<Pick<DirectionalLight, 'isDirectionalLight'>> &
  Partial<Pick<HemisphereLight, 'isHemisphereLight'>> &
  Partial<Pick<RectAreaLight, 'isRectAreaLight'>> & {
    readonly isAmbientLight?: boolean;
    readonly isLightField?: boolean;
  };

/**
 * Class of a light, which decides its record, volume and loop.
 *
 * | class | is |
 * |---|---|
 * | ambient, hemisphere | summed into four colours, no record |
 * | directional | over every pixel |
 * | unbounded | a point or spot light without a range: over every pixel |
 * | point | a point light with a range, without `userData.farol`; plain if it has no mask either |
 * | extended-point | a point light with a range and `userData.farol` |
 * | spot | a spot light with a range |
 * | area | a RectAreaLight: a rectangle, a disc or a tube |
 * | field | a LightField: many point and spot lights, whose records the GPU writes |
 * | other | left to three: probes |
 */
export type LightClass =
  | 'ambient'
  | 'hemisphere'
  | 'directional'
  | 'unbounded'
  | 'point'
  | 'extended-point'
  | 'spot'
  | 'area'
  | 'field'
  | 'other';

export function classifyLight(light: Light): LightClass {
  const { isPointLight, isSpotLight } = light as AnyLight;
  const isLocal = isPointLight === true || isSpotLight === true;
  return isLocal && lightRange(light as PointLight) === 0 ? 'unbounded' : classWithRange(light);
}

/** Class of a light; point and spot lights as if they had a range. */
function classWithRange(light: Light): LightClass {
  if ((light as AnyLight).isPointLight === true) return light.userData.farol === undefined ? 'point' : 'extended-point';
  const { isSpotLight, isDirectionalLight, isHemisphereLight, isAmbientLight, isLightField } = light as AnyLight;
  if (isSpotLight === true) return 'spot';
  if (isDirectionalLight === true) return 'directional';
  if (isHemisphereLight === true) return 'hemisphere';
  if (isAreaLight(light)) return 'area';
  if (isLightField === true) return 'field';
  return isAmbientLight === true ? 'ambient' : 'other';
}

/** True for a RectAreaLight, whatever its shape. */
export function isAreaLight(light: Light): light is RectAreaLight {
  return (light as AnyLight).isRectAreaLight === true;
}

/** True for a light that projects an image: a spot light with a `map`, or a point light with one set by `setLightOptions`. */
export function hasCookie(light: Light): boolean {
  return (light as AnyLight).isSpotLight === true
    ? (light as SpotLight).map !== null
    : (light.userData.farolMap ?? null) !== null;
}

/** True for a light with a photometric profile, set by `setLightOptions`. */
export function hasProfile(light: Light): boolean {
  return (light.userData.farolProfile ?? null) !== null;
}

/** Kinds of lights that three's light loop draws in place of Farol's. */
export interface LeftToThree {
  /** Whether lights that cast shadows are drawn by three. */
  shadows: boolean;
  /** Whether spot lights with a map are drawn by three. */
  cookies: boolean;
  /** Whether area lights are drawn by three. */
  areas: boolean;
  /** Whether all lights are drawn by three: a material in the scene has a shader without Farol's light loop. */
  all: boolean;
}

/**
 * True for the lights that Farol keeps in its own table: they never change a program. All other lights are left to
 * three.js: probes, and the kinds in `left` until the code for them is loaded.
 */
export function isManagedLight(light: Light, left: LeftToThree): boolean {
  // three has no code for light fields
  if ((light as AnyLight).isLightField === true) return true;
  if (left.all) return false;
  const { isPointLight, isSpotLight, isDirectionalLight, isHemisphereLight, isAmbientLight } = light as AnyLight;
  if (isAmbientLight === true || isHemisphereLight === true) return true;
  if (isDirectionalLight !== true && isPointLight !== true && isSpotLight !== true)
    return !left.areas && isAreaLight(light);
  return !(left.shadows && light.castShadow) && !(left.cookies && isSpotLight === true && hasCookie(light));
}

/** Kinds of shadow-casting lights that have shadow maps; with variance shadow maps, point and area lights have none. */
export type ShadowedLights = 'none' | 'all' | 'all-but-points';

/** True for a light that has a shadow map. */
export function hasShadowMap(light: Light, shadowed: ShadowedLights): boolean {
  if (!light.castShadow || shadowed === 'none') return false;
  return shadowed === 'all' || ((light as AnyLight).isPointLight !== true && !isAreaLight(light));
}

/** Scene data that may mask the lights of a frame. */
export interface MaskSettings {
  readonly shadows: ShadowedLights;
  /** Finds lights that do not reach all objects; null if all lights do. */
  readonly layers: { separates(light: Light): boolean } | null;
  /** Radii of area lights; null until their code is loaded: three.js draws area lights until then. Default null. */
  readonly areas?: AreaRadii | null;
}

/** True for a directional, point or spot light that a shadow map, an image, a profile or layers may darken. */
export function mayBeMasked(light: Light, masks: MaskSettings): boolean {
  return (
    hasShadowMap(light, masks.shadows) ||
    hasCookie(light) ||
    hasProfile(light) ||
    masks.layers?.separates(light) === true
  );
}

/** True if a directional, point or spot light gives nothing to any surface. */
function isBlackLight(light: Light): boolean {
  if (light.intensity === 0) return true;
  const { r, g, b } = light.color;
  if (r !== 0 || g !== 0 || b !== 0) return false;
  const { ambient, specular } = (light.userData.farol as FarolLightData | undefined) ?? NO_DATA;
  return ambient === undefined && specular === undefined;
}

/** Facts about a light in this frame; one object, reused for each light. */
export class LightFacts {
  kind: LightClass = 'other';
  /** Distance (m) beyond which the light gives nothing; 0 for a light without a range. */
  range = 0;
  /** Whether a shadow map, an image, a profile or layers may darken the light. */
  isMasked = false;
  private readonly warned = new WeakSet<Light>();

  /**
   * Reads the facts of a light.
   * @returns false for a light to leave out: black, or with a value that is no finite number, of which it warns once
   */
  classify(light: Light, masks: MaskSettings): boolean {
    if (!hasFiniteValues(light)) {
      this.warn(light);
      return false;
    }
    const kind = (this.kind = classWithRange(light));
    this.range = 0;
    this.isMasked = false;
    if (kind === 'ambient' || kind === 'hemisphere' || kind === 'field') return true;
    if (isBlackLight(light)) return false;
    this.isMasked = mayBeMasked(light, masks);
    if (kind === 'directional') return true;
    const range = kind === 'area' ? masks.areas!.radiusOf(light as RectAreaLight) : lightRange(light as PointLight);
    if (range === 0 && kind !== 'area') this.kind = 'unbounded';
    this.range = range;
    return range >= 0;
  }

  private warn(light: Light): void {
    if (this.warned.has(light)) return;
    this.warned.add(light);
    console.warn(
      `Farol: ${light.type} "${light.name || light.uuid}" is left out: its position, colour or another value is not a finite number; set one.`,
    );
  }
}

/** True if all values of a light are finite; any other would turn pixels to NaN. */
function hasFiniteValues(light: Light): boolean {
  const { elements } = light.matrixWorld;
  const { r, g, b } = light.color;
  let sum = elements[12] + elements[13] + elements[14] + r + g + b + light.intensity;
  const { decay, angle, penumbra, width, height, groundColor, target } = light as SpotLight &
    RectAreaLight &
    HemisphereLight;
  if (decay !== undefined) sum += decay;
  if (angle !== undefined) sum += angle + penumbra;
  if (width !== undefined) sum += width + height + elements[1] + elements[4];
  if (groundColor !== undefined) sum += groundColor.r + groundColor.g + groundColor.b;
  if (target !== undefined) for (let i = 12; i < 15; i++) sum += target.matrixWorld.elements[i];
  return Number.isFinite(sum);
}
