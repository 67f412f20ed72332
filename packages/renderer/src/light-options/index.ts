// Options of lights beyond three.js.
export type { AreaLightShape, FarolAttenuation, FarolLightData, LinearRGB } from '../lights/lightData';
export type { LightOptions } from './LightOptions';
export { setLightOptions, storeLightOptions } from './setLightOptions';
