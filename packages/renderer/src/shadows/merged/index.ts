import mergedCaster from './mergedCaster.glsl?raw';
import mergedCasterDepth from './mergedCasterDepth.glsl?raw';

export { CLUSTERS_PER_GROUP, MergedCasters, type MergedCaster } from './MergedCasters';
export { mergedCaster, mergedCasterDepth };
