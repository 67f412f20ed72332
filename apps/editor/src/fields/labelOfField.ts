import type { Field } from '@farol/engine/fields';

/** The label of a field: its own, else its name in words. */
export function labelOfField(name: string, field: Field): string {
  if (field.label) return field.label;
  const words = name.replaceAll(/([a-z0-9])([A-Z])/g, '$1 $2').toLowerCase();
  return words.charAt(0).toUpperCase() + words.slice(1);
}
