/** What components declare: their fields, how a value is checked, and what an inspector reads. */
export * from './Field';
export * from './fields';
export { checkFieldValue } from './checkFieldValue';
export { component } from './component';
export { FieldError } from './FieldError';
export { FieldOwner, sameValue } from './FieldOwner';
export { isFieldVisible } from './isFieldVisible';
