/** Declarations of fields: kinds, values, validation, and descriptions for inspectors. */
export * from './Field';
export * from './fields';
export { allowedBy, checkFieldValue, describeValue, isFieldValue, MOST_KEYS } from './checkFieldValue';
export { FieldError } from './FieldError';
export { isFieldVisible } from './isFieldVisible';
export { colourKeys, curveAt, fullKeys, gradientAt, joinKeys, opacityKeys } from './keys';
export { isTriple, sameValue } from './sameValue';
export { variantOfField } from './variantOfField';
