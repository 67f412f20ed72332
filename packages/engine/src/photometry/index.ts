/** Photometry of lights: units, lamps, colour temperatures and presets; pure functions of a Light's fields. */
export {
  chromaticityOf,
  colourOfKelvin,
  HIGHEST_KELVIN,
  lightOfKelvin,
  LOWEST_KELVIN,
  luminanceOf,
} from './colourTemperature';
export { evOfCamera, evOfIlluminance, evOfLuminance, exposureOfEV } from './exposure';
export { lampEfficacies, type LampKind, lampKinds } from './lampKinds';
export { type LightPreset, lightPresets, valuesOfPreset } from './lightPresets';
export {
  type IntensityUnit,
  intensityUnits,
  type PhotometricLight,
  solidAngleOf,
  unitFactor,
  unitLabels,
  unitOfThree,
  unitsFor,
  unitSymbols,
} from './lightUnits';
export { formatIntensity, type MeasuredLight, type ShownIntensity, shownIntensity, shownUnit } from './shownIntensity';
