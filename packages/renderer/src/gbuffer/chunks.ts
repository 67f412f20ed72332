// The microshaders of this folder, by name.
export { default as gbufferTextures } from './gbufferTextures.glsl?raw';
export { default as surfaceFlags } from './surfaceFlags.glsl?raw';
export { default as gbufferRead } from './gbufferRead.glsl?raw';
export { default as gbufferWrite } from './gbufferWrite.glsl?raw';
export { default as octahedralNormal } from './octahedralNormal.glsl?raw';
export { default as roundToHalf } from './roundToHalf.glsl?raw';
export { default as storedDistance } from './storedDistance.glsl?raw';
