// The microshaders of this folder, by name.
export { default as lightTiles } from './lightTiles.glsl?raw';
export { default as tileDepth } from './tileDepth.glsl?raw';
export { default as tileDepthBlocks } from './tileDepthBlocks.glsl?raw';
export { default as tileMask } from './tileMask.glsl?raw';
export { default as tileSummary } from './tileSummary.glsl?raw';
