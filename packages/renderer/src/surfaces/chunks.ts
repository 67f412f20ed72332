export { default as surfaceData } from './surfaceData.glsl?raw';
export { default as surfaceNoise } from './surfaceNoise.glsl?raw';
