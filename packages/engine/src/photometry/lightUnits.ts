import type { FieldValue } from '@farol/editing/fields';
import { type LampKind, lampEfficacies } from './lampKinds';

/** Units of a light's intensity. */
export const intensityUnits = ['candela', 'lumen', 'lux', 'nits', 'watt'] as const;
/** Names of the units of a light's intensity. */
export type IntensityUnit = (typeof intensityUnits)[number];

/** Names of the units with their symbols. */
export const unitLabels: Readonly<Record<IntensityUnit, string>> = {
  candela: 'Candela (cd)',
  lumen: 'Lumen (lm)',
  lux: 'Lux (lx)',
  nits: 'Nits (cd/m²)',
  watt: 'Watt (W)',
};

/** Unit symbols; lux of point and spot lights is measured at 1 m. */
export const unitSymbols: Readonly<Record<IntensityUnit, string>> = {
  candela: 'cd',
  lumen: 'lm',
  lux: 'lx',
  nits: 'nt',
  watt: 'W',
};

/** Fields of a Light that its photometry depends on; angles in radians, lengths in metres. */
export interface PhotometricLight {
  readonly type: string;
  /** Angle from a spot's axis to the edge of its cone. */
  readonly cutoff: number;
  /** Part of a spot's cone in which its edge is soft, 0 to 1. */
  readonly penumbra: number;
  /** Above 0: the intensity of a spot is this power of the cosine to its axis, in place of the penumbra. */
  readonly exponent: number;
  readonly width: number;
  readonly height: number;
  /** Kind of lamp, which gives the lumens per watt. */
  readonly lamp: LampKind;
  /** Photometric profile (IES), by which intensity varies with direction; null for none. */
  readonly profile?: FieldValue;
  readonly profileIntensity?: boolean;
  /** Solid angle (sr) of a profile: its flux divided by its largest intensity; null until the profile is loaded. */
  readonly profileSolidAngle?: number | null;
}

/** Unit of a three light's `intensity`: candela, nits for area lights, lux for directional and hemisphere lights. */
export function unitOfThree(type: string): IntensityUnit {
  if (type === 'point' || type === 'spot') return 'candela';
  return isArea(type) ? 'nits' : 'lux';
}

const isArea = (type: string): boolean => type === 'rectangle' || type === 'disc' || type === 'tube';

/** Units in which a light's intensity can be given, three's unit first. */
export function unitsFor(light: Omit<PhotometricLight, 'lamp'>): readonly IntensityUnit[] {
  const { type, profile, profileIntensity, profileSolidAngle } = light;
  // the cone of a spot removes an unknown part of the profile's flux
  if (profile && (type === 'spot' || profileIntensity || !profileSolidAngle)) return ['candela'];
  if (type === 'point' || type === 'spot') return ['candela', 'lumen', 'lux', 'watt'];
  return isArea(type) ? ['nits', 'lumen', 'candela', 'watt'] : ['lux'];
}

/**
 * Solid angle (sr) of a point or spot light: its luminous flux (lm) divided by its intensity (cd). A spot's edge is
 * three's: `smoothstep` of the cosine, from that of the cone to that of the cone less its penumbra. Its integral over
 * the sphere is that of a hard cone at the mean of both cosines, since a smoothstep is half of its interval.
 */
export function solidAngleOf(light: PhotometricLight): number {
  const { type, cutoff, penumbra, exponent, profile, profileSolidAngle } = light;
  if (type !== 'spot') return (profile && profileSolidAngle) || 4 * Math.PI;
  const edge = Math.cos(cutoff);
  if (exponent > 0) return (2 * Math.PI * (1 - edge ** (exponent + 1))) / (exponent + 1);
  return 2 * Math.PI * (1 - (edge + Math.cos(cutoff * (1 - penumbra))) / 2);
}

/** Emitting area (m²): the front of a rectangle or disc (an ellipse), the lateral surface of a tube. */
function shiningArea({ type, width, height }: PhotometricLight): number {
  return width * height * (type === 'disc' ? Math.PI / 4 : type === 'tube' ? Math.PI : 1);
}

/** Area (m²) of a shape seen from its front, or of a tube seen from the side. */
function seenArea(light: PhotometricLight): number {
  return light.type === 'tube' ? light.width * light.height : shiningArea(light);
}

/**
 * Amount in `unit` that equals an intensity of 1 in three: `shown = intensity × unitFactor(light, unit)`. Rectangles,
 * discs and tubes are Lambertian: flux = luminance × area × π.
 * @see IES Lighting Handbook, 10th edition, chapter 5, for the quantities and their relations
 */
export function unitFactor(light: PhotometricLight, unit: IntensityUnit): number {
  if (unit === unitOfThree(light.type) || !unitsFor(light).includes(unit)) return 1;
  if (unit === 'lux') return 1;
  if (unit === 'candela') return seenArea(light);
  const flux = isArea(light.type) ? Math.PI * shiningArea(light) : solidAngleOf(light);
  return unit === 'watt' ? flux / lampEfficacies[light.lamp] : flux;
}
