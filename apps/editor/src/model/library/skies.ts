import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';
import type { libraryNames } from './names';

type Values = Readonly<Record<string, FieldValue>>;

/** A sky with the sun or moon that belongs to it. */
export interface LibrarySky {
  /** Fields of the scene's settings. */
  readonly settings: Values;
  /** Fields of the scene's directional light, and the direction that it comes from; null to switch it off. */
  readonly sun: { readonly from: Vector3Tuple; readonly values: Values } | null;
}

const kelvin = (degrees: number): Values => ({ colourBy: 'temperature', kelvin: degrees });
const soft = { castShadow: true, shadowMapSize: 2048 };

/** Unit vector towards a sun or moon, from angles (degrees) that match the painted skies. */
const direction = (elevation: number, azimuth = -115): Vector3Tuple => {
  const [height, side] = [elevation, azimuth].map((degrees) => (degrees * Math.PI) / 180);
  return [Math.cos(height) * Math.cos(side), Math.sin(height), Math.cos(height) * Math.sin(side)];
};

/** Settings that all skies share, so that none of another sky remain. */
const plain = { background: 'sky', skyLight: true, volumetricFog: false };

/** Sky settings and light of each sky. */
export const skies: Readonly<Record<keyof typeof libraryNames.sky, LibrarySky>> = {
  'clear-day': {
    settings: { ...plain, sky: 'clear-day', environmentIntensity: 0.8 },
    sun: { from: direction(38), values: { ...soft, ...kelvin(5600), intensity: 3, shadowRadius: 2 } },
  },
  overcast: {
    settings: { ...plain, sky: 'overcast', environmentIntensity: 1 },
    sun: null,
  },
  sunset: {
    settings: { ...plain, sky: 'sunset', environmentIntensity: 0.8 },
    sun: { from: direction(4), values: { ...soft, ...kelvin(2300), intensity: 2, shadowRadius: 3 } },
  },
  'moonlit-night': {
    settings: { ...plain, sky: 'night', environmentIntensity: 1 },
    sun: { from: direction(30), values: { ...soft, ...kelvin(9000), intensity: 0.25, shadowRadius: 4 } },
  },
  'foggy-night': {
    settings: {
      ...{ ...plain, sky: 'night', environmentIntensity: 0.6, volumetricFog: true },
      ...{
        volumetricDensity: 0.04,
        volumetricAnisotropy: 0.4,
        volumetricHeight: 2,
        volumetricFalloff: 4,
        volumetricNoise: 0.3,
      },
    },
    sun: { from: direction(30), values: { ...soft, ...kelvin(9000), intensity: 0.15, shadowRadius: 4 } },
  },
  studio: {
    settings: { ...plain, sky: 'studio', environmentIntensity: 1 },
    sun: null,
  },
};
