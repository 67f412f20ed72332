/** What components declare: their fields, how a value is checked, and what an inspector reads. */
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
