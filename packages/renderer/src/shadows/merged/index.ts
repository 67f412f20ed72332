import mergedCaster from './mergedCaster.glsl?raw';
import mergedCasterDepth from './mergedCasterDepth.glsl?raw';

export { MergedCasters, type MergedCaster } from './MergedCasters';
export { mergedCaster, mergedCasterDepth };
