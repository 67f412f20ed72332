import {
  type IntensityUnit,
  type PhotometricLight,
  unitFactor,
  unitOfThree,
  unitsFor,
  unitSymbols,
} from './lightUnits';

/** A light with its intensity: three's number, and the unit that it was given in. */
export interface MeasuredLight extends PhotometricLight {
  readonly intensity: number;
  /** 'auto' for the unit of three's number. */
  readonly intensityUnit: IntensityUnit | 'auto';
}

/** Unit that the light's intensity is shown in: the one it was given in, where its type has that. */
export function shownUnit(light: Omit<MeasuredLight, 'intensity'>): IntensityUnit {
  const { intensityUnit } = light;
  return intensityUnit !== 'auto' && unitsFor(light).includes(intensityUnit) ? intensityUnit : unitOfThree(light.type);
}

/** Intensity as shown: its amount, its unit's symbol, and the amount that is 1 of three's number. */
export interface ShownIntensity {
  readonly value: number;
  /** 'cd', 'lm', 'lx', 'nt' or 'W'; '×' of a light that is as bright as its photometric file says, times its intensity. */
  readonly symbol: string;
  readonly factor: number;
}

/** Intensity of a light in the unit that it was given in. */
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
