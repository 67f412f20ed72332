export { VolumetricFog } from './VolumetricFog';
export { type FogShape, fogShapes, FogVolume } from './FogVolume';
export { fogQualities, type Froxels } from './froxels';
