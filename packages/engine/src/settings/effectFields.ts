import { boolean, type BooleanField, type ColourField, type FieldTable, type NumberField } from '@farol/editing/fields';
import { type EffectEntry, type EffectName, effects } from '@farol/renderer/effects';

type Entry = (typeof effects)[EffectName];
type SwitchOf<E> = E extends { readonly setting: infer Name extends string } ? Name : never;
type FieldOf<E, Kind> = E extends { readonly fields: infer Fields }
  ? { [Name in keyof Fields]: Fields[Name] extends { readonly kind: Kind } ? Name : never }[keyof Fields]
  : never;

/** Effects of the renderer for menus, by key. */
export const effectEntries: Readonly<Record<string, EffectEntry>> = effects;

function makeFields(): FieldTable {
  const table: Record<string, BooleanField | ColourField | NumberField> = {};
  for (const { label, help = label, setting, fields = {} } of Object.values(effectEntries)) {
    if (setting === undefined) continue;
    table[setting] = boolean(false, { label, help });
    for (const name of Object.keys(fields)) {
      table[name] = { ...fields[name], visibleWhen: { field: setting, equals: [true] } };
    }
  }
  return table;
}

/** Settings for effects of the renderer: for each effect a switch, then its numbers and colours. */
export const effectFields = makeFields() as Readonly<
  Record<SwitchOf<Entry>, BooleanField> &
    Record<FieldOf<Entry, 'number'>, NumberField> &
    Record<FieldOf<Entry, 'colour'>, ColourField>
>;

/** Keys of the anti-aliasing effects. */
export const antialiasingEffects = Object.keys(effects).filter(
  (name) => effectEntries[name].group === 'antialiasing',
) as { [Name in EffectName]: (typeof effects)[Name] extends { group: 'antialiasing' } ? Name : never }[EffectName][];
