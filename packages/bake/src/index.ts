export type { Bake, BakedLightmap, BakedMesh } from './Bake';
export type { BakeOptions, Sky, TraceOptions } from './BakeOptions';
export type { BakeProgress } from './BakeProgress';
export { bakeLightmaps } from './bakeLightmaps';
export { bakeProbes, type BakeProbesOptions } from './bakeProbes';
export type { BakedProbes } from './probes/BakedProbes';
export { restoreBake, type RestoreOptions, type SavedBake } from './restoreBake';
