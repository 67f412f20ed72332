export { AmbientOcclusion } from './AmbientOcclusion';
