import type { FarolAttenuation, FarolLightData, LinearRGB } from '@farol/renderer/light-options';
import type { Light, Object3D, PointLight, SpotLight } from 'three';

/** Properties of a light that KHR_lights_punctual cannot hold, written to `extras.farolLight` of the light's node. */
export interface LightExtras {
  /** Intensity of the light, in place of the file's, which is chosen for physical falloff. */
  readonly intensity: number;
  /** Colour of the light, in place of the file's, whose channels are at most 1. */
  readonly color?: LinearRGB;
  /** three's `distance` (m; 0: unlimited) and `decay` of the light. */
  readonly distance?: number;
  readonly decay?: number;
  readonly penumbra?: number;
  readonly data?: FarolLightData;
}

/**
 * Extras of a light; null for a light that glTF can express.
 * @param hasOwnColour - whether the file has another colour than the light
 */
export function lightExtrasOf(light: Light, hasOwnColour = false): LightExtras | null {
  const { distance, decay, penumbra } = light as SpotLight;
  const data = light.userData.farol as FarolLightData | undefined;
  const fadesOwn = decay !== undefined && decay !== 2;
  if (!data && !fadesOwn) return null;
  const { color, intensity } = light;
  return {
    intensity,
    ...(hasOwnColour && { color: [color.r, color.g, color.b] as const }),
    ...(decay !== undefined && { distance, decay }),
    ...(penumbra !== undefined && { penumbra }),
    ...(data && { data: { ...data } }),
  };
}

/** Restores the lights of a loaded model from their extras; invalid extras are ignored. */
export function restoreLights(scene: Object3D): void {
  scene.traverse((object) => {
    const light = object as Light;
    const extras: unknown = light.userData.farolLight;
    if (light.isLight !== true || typeof extras !== 'object' || extras === null) return;
    delete light.userData.farolLight;
    restore(light, extras as Record<string, unknown>);
  });
}

function restore(light: Light, extras: Record<string, unknown>): void {
  const { intensity, color, distance, decay, penumbra } = extras;
  if (isColour(color)) light.color.setRGB(...color);
  if (isAmount(intensity)) light.intensity = intensity;
  const local = light as PointLight;
  if (local.decay !== undefined) {
    if (isAmount(distance)) local.distance = distance;
    if (isAmount(decay)) local.decay = decay;
  }
  const spot = light as SpotLight;
  if (spot.penumbra !== undefined && isAmount(penumbra)) spot.penumbra = Math.min(1, penumbra);
  if (typeof extras.data !== 'object' || extras.data === null) return;
  const data = readData(extras.data as Record<string, unknown>);
  if (Object.keys(data).length > 0) light.userData.farol = data;
}

function readData({ ambient, specular, spotExponent, attenuation }: Record<string, unknown>): FarolLightData {
  const data: FarolLightData = {};
  if (isColour(ambient)) data.ambient = ambient;
  if (isColour(specular)) data.specular = specular;
  if (isAmount(spotExponent)) data.spotExponent = spotExponent;
  const read = readAttenuation(attenuation);
  if (read) data.attenuation = read;
  return data;
}

function readAttenuation(value: unknown): FarolAttenuation | null {
  if (typeof value !== 'object' || value === null) return null;
  const { kind, near, far, constant, linear, quadratic, range } = value as Record<string, unknown>;
  if (kind === 'near-far' && isAmount(near) && isAmount(far)) return { kind, near, far };
  if (kind !== 'polynomial' || !isAmount(constant) || !isAmount(linear)) return null;
  return isAmount(quadratic) && isAmount(range) ? { kind, constant, linear, quadratic, range } : null;
}

const isAmount = (value: unknown): value is number => typeof value === 'number' && value >= 0 && value < 1e9;

const isColour = (value: unknown): value is LinearRGB =>
  Array.isArray(value) && value.length === 3 && value.every(isAmount);
