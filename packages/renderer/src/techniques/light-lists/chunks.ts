// The microshaders of this folder, by name: fetched with the techniques that have light lists.
export { default as addOther } from './addOther.glsl?raw';
export { default as lightLoopClustered } from './lightLoopClustered.glsl?raw';
export * from './tiledChunks';
