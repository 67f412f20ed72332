/** Baked light as data: its sources in a scene, and its file. The baker itself is `@farol/bake`. */
export type { BakeData, LightmapData, LightmappedMesh, ProbeData } from '../assets/bake/BakeData';
export { BakedLight } from '../assets/bake/BakedLight';
export { bakeFields } from '../settings/bakeFields';
export { bakeSignature } from './bakeSignature';
export { type BakeMesh, type BakeSources, bakeSources, isStaticWithoutLightmap } from './bakeSources';
export { dampRinging, fillBuriedProbes, probeBox } from './probeGrid';
export { loadBakeCode } from '../core/baked/bakeCode';
export { readBake } from '../assets/bake/readBake';
export { writeBake } from '../assets/bake/writeBake';
