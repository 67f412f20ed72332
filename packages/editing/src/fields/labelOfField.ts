import { t } from '../language/translate';

/** The English label of a field: the declared one, else its name in words, 'castShadow' as 'Cast shadow'. */
export function englishLabelOfField(name: string, field: { readonly label?: string }): string {
  if (field.label) return field.label;
  const words = name.replaceAll(/([a-z0-9])([A-Z])/g, '$1 $2').toLowerCase();
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** The label of a field, in the current language. */
export function labelOfField(name: string, field: { readonly label?: string }): string {
  return t(englishLabelOfField(name, field));
}
