// Microshaders of the techniques with tiles, by name.
export { default as addPoint } from './addPoint.glsl?raw';
export { default as lightLoopTiled } from './lightLoopTiled.glsl?raw';
export { default as lightTileLists } from './lightTileLists.glsl?raw';
export { default as lightTiles } from './lightTiles.glsl?raw';
export { default as tileDepth } from './tileDepth.glsl?raw';
export { default as tileDepthBlocks } from './tileDepthBlocks.glsl?raw';
export { default as tileMask } from './tileMask.glsl?raw';
export { default as tileSummary } from './tileSummary.glsl?raw';
export { default as tiledOutput } from './tiledOutput.glsl?raw';
