import type { Field } from './Field';

/** Cache of variants, by field, then by the value of the field that selects the variant. */
const made = new WeakMap<Field, Map<unknown, Field>>();

/**
 * A field with the label and unit for the present value of the field that selects them, cached per value.
 * @param get - reads the value of a field by its name
 */
export function variantOfField(field: Field, get: (field: string) => unknown): Field {
  const { variants } = field;
  if (!variants) return field;
  const key = get(variants.field);
  const variant = typeof key === 'string' && Object.hasOwn(variants.of, key) ? variants.of[key] : undefined;
  if (!variant) return field;
  let known = made.get(field);
  if (!known) made.set(field, (known = new Map<unknown, Field>()));
  let shown = known.get(key);
  if (!shown) known.set(key, (shown = { ...field, ...variant } as Field));
  return shown;
}
