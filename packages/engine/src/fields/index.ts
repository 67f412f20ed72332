/** What components declare: their fields, how a value is checked, and what an inspector reads. */
export * from './Field';
export * from './fields';
export { checkFieldValue } from './checkFieldValue';
export { component, type ComponentBase } from './component';
export { FieldError } from './FieldError';
export { type FieldOwner, sameValue } from './FieldOwner';
export { isFieldVisible } from './isFieldVisible';
export { materialAssetFields } from '../assets/materialAssetFields';
export {
  type MaterialMap,
  type MaterialMapName,
  materialMapNames,
  materialMaps,
  uvFieldEndings,
} from '../assets/materialMaps';
