// The microshaders of this folder, by name.
export { default as countView } from './countView.glsl?raw';
export { default as surfaceView } from './surfaceView.glsl?raw';
