import mergedCaster from './mergedCaster.glsl?raw';
import mergedCasterDepth from './mergedCasterDepth.glsl?raw';

export { CLUSTERS_PER_GROUP } from './ClusterOrder';
export { MergedCasters } from './MergedCasters';
export { mergedCaster, mergedCasterDepth };
