// The microshaders of this folder, by name.
export { default as ggx } from './ggx.glsl?raw';
export { default as shadePlain } from './shadePlain.glsl?raw';
export { default as shadeSurface } from './shadeSurface.glsl?raw';
export { default as shadeThree } from './shadeThree.glsl?raw';
export { default as shadeToon } from './shadeToon.glsl?raw';
export { default as shading } from './shading.glsl?raw';
