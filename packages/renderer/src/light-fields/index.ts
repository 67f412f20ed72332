export type { LightArray } from './LightArray';
export { LightField, type LightFieldOptions } from './LightField';
export type { LightTextures } from './LightTextures';
