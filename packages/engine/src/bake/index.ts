/** Baked light as data: what is baked of a scene, and the file of it. The baker itself is `@farol/bake`. */
export type { BakeData, LightmapData, LightmappedMesh, ProbeData } from './BakeData';
export { BakedLight } from './BakedLight';
export { bakeFields } from './bakeFields';
export { bakeSignature } from './bakeSignature';
export { type BakeMesh, type BakeSources, bakeSources, isStaticWithoutLightmap } from './bakeSources';
export { dampRinging, fillBuriedProbes, probeBox } from './probeGrid';
export { loadBakeCode } from '../core/bakeCode';
export { readBake } from './readBake';
export { writeBake } from './writeBake';
