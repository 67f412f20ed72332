/** Declaration of components' fields: kinds, checks of values, and descriptions for inspectors. */
export { surfaceMaps, surfaceValueFields } from './assets/uniformFields';
export * from '@farol/editing/fields';
export { component, type ComponentBase } from './core/Component';
export type { FieldOwner } from './fields/FieldOwner';
export { materialAssetFields } from './assets/materialAssetFields';
export {
  type MaterialMap,
  type MaterialMapName,
  materialMapNames,
  materialMaps,
  uvFieldEndings,
} from './assets/materialMaps';
