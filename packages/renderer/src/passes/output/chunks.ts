// The microshaders of this folder, by name.
export { default as background } from './background.glsl?raw';
export { default as deferredOutput } from './deferredOutput.glsl?raw';
export { default as heatMap } from './heatMap.glsl?raw';
export { default as heatScale } from './heatScale.glsl?raw';
export { default as media } from './media.glsl?raw';
export { default as output } from './output.glsl?raw';
