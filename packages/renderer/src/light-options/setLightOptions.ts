import type { Light, Texture } from 'three';
import { unknownName } from '../renderer/errors';
import { areaCode, shadowCode } from '../renderer/lazyCode';
import type { FarolLightData } from '../lights/lightData';
import type { LightOptions } from './LightOptions';
import { type LightOptionName, lightRules } from './lightRules';

/**
 * Sets properties of a light that three's lights lack; absent options keep their value, undefined ones get their default.
 * Everything except textures is stored as JSON at `light.userData.farol`, so it is saved and loaded with the scene, and
 * is read in each frame. Starts to fetch the code that draws such lights.
 *
 * @example
 * setLightOptions(lamp, { shape: 'tube', range: 6 });
 *
 * @throws Error for an option that does not exist, that a light of this kind has not, or of a value that it cannot
 * have;
 *   nothing has changed then
 */
export function setLightOptions(light: Light, options: LightOptions): void {
  for (const [name, value] of Object.entries(options)) check(light, name as LightOptionName, value);
  storeLightOptions(light, options);
}

/** Like `setLightOptions`, without its checks and their code: for values already checked, such as an engine's fields. */
export function storeLightOptions(light: Light, options: LightOptions): void {
  const { cookie, profile, ...values } = options;
  if ('cookie' in options) storeTexture(light, 'farolMap', cookie);
  if ('profile' in options) storeTexture(light, 'farolProfile', profile);
  if (Object.keys(values).length > 0) {
    const all = Object.entries({ ...(light.userData.farol as FarolLightData | undefined), ...values });
    light.userData.farol = Object.fromEntries(all.filter(([, value]) => value !== undefined));
  }
  if ('isRectAreaLight' in light) areaCode.ask();
  if (cookie || profile) shadowCode.ask();
}

/** Stores a texture in `userData`, not enumerable, since JSON and `clone` cannot hold textures. */
function storeTexture(light: Light, place: string, value: Texture | null = null): void {
  Object.defineProperty(light.userData, place, { value, writable: true, configurable: true });
}

function check(light: Light, name: LightOptionName, value: unknown): void {
  if (!Object.hasOwn(lightRules, name)) throw unknownName('light option', name, Object.keys(lightRules));
  const { kinds, allows, isAllowed } = lightRules[name];
  if (!kinds.some((kind) => `is${kind}` in light))
    throw new Error(`Farol: a ${light.type} has no ${name}; ${kinds.map((kind) => `a ${kind}`).join(' and ')} has.`);
  if (value !== undefined && !isAllowed(value))
    throw new RangeError(`Farol: ${name} is ${textOf(value)}; give ${allows}.`);
}

/** Short text of a value, for messages. */
const textOf = (value: unknown): string =>
  typeof value === 'object' && value !== null && !Array.isArray(value)
    ? 'an object'
    : typeof value === 'number'
      ? String(value)
      : String(JSON.stringify(value)).slice(0, 40);
