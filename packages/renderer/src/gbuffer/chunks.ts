// The microshaders of this folder, by name.
export { gbufferTexturesChunk as gbufferTextures } from './gbufferNames';
export { surfaceFlagsChunk as surfaceFlags } from './surfaceFlags';
export { default as gbufferRead } from './gbufferRead.glsl?raw';
export { default as gbufferWrite } from './gbufferWrite.glsl?raw';
export { default as octahedralNormal } from './octahedralNormal.glsl?raw';
export { default as roundToHalf } from './roundToHalf.glsl?raw';
export { default as storedDistance } from './storedDistance.glsl?raw';
