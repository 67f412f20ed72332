/** Photometry of lights: units, lamps, colour temperatures, presets and exposure; pure functions of a Light's fields. */
export { colourOfKelvin, lightOfKelvin } from './colourTemperature';
export { evOfCamera, evOfIlluminance, evOfLuminance, exposureOfEV } from './exposure';
export { lampEfficacies, type LampKind, lampKinds } from './lampKinds';
export { type LightPreset, lightPresets, valuesOfPreset } from './lightPresets';
export { type IntensityUnit, type PhotometricLight, unitFactor, unitLabels, unitsFor } from './lightUnits';
export { formatIntensity, type MeasuredLight, type ShownIntensity, shownIntensity, shownUnit } from './shownIntensity';
