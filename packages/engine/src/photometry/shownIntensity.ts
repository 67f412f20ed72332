import {
  type IntensityUnit,
  type PhotometricLight,
  unitFactor,
  unitOfThree,
  unitsFor,
  unitSymbols,
} from './lightUnits';

/** A light with its intensity in three's unit, and the unit that the user chose. */
export interface MeasuredLight extends PhotometricLight {
  readonly intensity: number;
  /** 'auto' for the unit of three's number. */
  readonly intensityUnit: IntensityUnit | 'auto';
}

/** Unit in which the light's intensity is displayed: the chosen one if its type supports that, else three's. */
export function shownUnit(light: Omit<MeasuredLight, 'intensity'>): IntensityUnit {
  const { intensityUnit } = light;
  return intensityUnit !== 'auto' && unitsFor(light).includes(intensityUnit) ? intensityUnit : unitOfThree(light.type);
}

/** Intensity for display: amount, symbol of the unit, and the amount that equals 1 in three. */
export interface ShownIntensity {
  readonly value: number;
  /** 'cd', 'lm', 'lx', 'nt' or 'W'; '×' when the intensity is a factor of the photometric file's. */
  readonly symbol: string;
  readonly factor: number;
}

/** Intensity of a light in its display unit. */
export function shownIntensity(light: MeasuredLight): ShownIntensity {
  const unit = shownUnit(light);
  const factor = unitFactor(light, unit);
  const isFactor = light.profile && light.profileIntensity;
  return { value: light.intensity * factor, symbol: isFactor ? '×' : unitSymbols[unit], factor };
}

/** Intensity in the light's unit, rounded to four digits: '800 lm'. */
export function formatIntensity(light: MeasuredLight): string {
  const { value, symbol } = shownIntensity(light);
  return `${Number(value.toPrecision(4))} ${symbol}`;
}
