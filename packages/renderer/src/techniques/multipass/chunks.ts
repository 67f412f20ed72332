// The microshaders of this folder, by name.
export { default as accumulatedOutput } from './accumulatedOutput.glsl?raw';
export { default as lightLoopOne } from './lightLoopOne.glsl?raw';
