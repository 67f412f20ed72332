export { IntensityEditor } from './IntensityEditor';
export { TemperatureEditor } from './TemperatureEditor';
