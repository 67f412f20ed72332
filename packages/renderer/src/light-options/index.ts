// What lights can have that three.js has not.
export type { AreaLightShape, FarolAttenuation, FarolLightData, LinearRGB } from '../lights/lightData';
export type { LightOptions } from './LightOptions';
export { setLightOptions, storeLightOptions } from './setLightOptions';
