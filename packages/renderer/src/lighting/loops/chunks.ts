// The microshaders of this folder, by name.
export { default as fewLights } from './fewLights.glsl?raw';
export { default as lightLoopAll } from './lightLoopAll.glsl?raw';
export { default as lightLoopNone } from './lightLoopNone.glsl?raw';
export { default as lightOneByOne } from './lightOneByOne.glsl?raw';
