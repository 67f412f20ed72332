/** What components declare: their fields, how a value is checked, and what an inspector reads. */
export { surfaceMaps, surfaceValueFields } from '../assets/uniformFields';
export * from './Field';
export * from './fields';
export { checkFieldValue, MOST_KEYS } from './checkFieldValue';
export { component, type ComponentBase } from './component';
export { FieldError } from './FieldError';
export { colourKeys, curveAt, fullKeys, gradientAt, joinKeys, opacityKeys } from './keys';
export { type FieldOwner, isTriple, sameValue } from './FieldOwner';
export { isFieldVisible } from './isFieldVisible';
export { variantOfField } from './variantOfField';
export { materialAssetFields } from '../assets/materialAssetFields';
export {
  type MaterialMap,
  type MaterialMapName,
  materialMapNames,
  materialMaps,
  uvFieldEndings,
} from '../assets/materialMaps';
