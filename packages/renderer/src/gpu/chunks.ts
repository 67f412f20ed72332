// The microshaders of this folder, by name.
export { default as depthMode } from './depthMode.glsl?raw';
export { default as depthOnly } from './depthOnly.glsl?raw';
export { default as farthest } from './farthest.glsl?raw';
export { default as fullscreen } from './fullscreen.glsl?raw';
export { default as unproject } from './unproject.glsl?raw';
export { default as viewport } from './viewport.glsl?raw';
export { default as readPixel } from './readPixel.glsl?raw';
