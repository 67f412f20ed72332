import { fieldInUnit, t } from '@farol/editing';
import { Light, type ParticleEmitter } from '@farol/engine';
import { type Field, isFieldVisible, type NumberField, variantOfField } from '@farol/engine/fields';

/** A component that lights the scene: a Light, or a ParticleEmitter whose particles are lights. */
export type LightSource = Light | ParticleEmitter;

/** Kind of a light as rows name it: the type of a Light, or 'particles'. */
export const kindOf = (source: LightSource): string => (source instanceof Light ? source.type : 'particles');

/** A kind in the language that is shown. */
export const kindLabel = (kind: string): string => (kind === 'particles' ? t('particles') : t(kind));

const isShown = (source: LightSource, name: string): boolean =>
  isFieldVisible(source.fields, name, (other) => source.getAuthored(other));

/** Name of the field of a light that a column edits; null where the light has none. */
export const columnFields = {
  colour: (source: LightSource) => (source instanceof Light ? 'diffuse' : null),
  intensity: (source: LightSource) => (source instanceof Light ? 'intensity' : 'lightIntensity'),
  range: (source: LightSource) => {
    const names = source instanceof Light ? ['areaRange', 'range', 'far'] : ['lightRange'];
    if (source instanceof Light && ['ambient', 'hemisphere', 'directional'].includes(source.type)) return null;
    return names.find((name) => isShown(source, name)) ?? null;
  },
  shadow: (source: LightSource) => (source instanceof Light && isShown(source, 'castShadow') ? 'castShadow' : null),
} as const;

/** A column whose cells edit a field. */
export type FieldColumn = keyof typeof columnFields;

/** The number field behind a cell, with the label and the unit that it has for this light. */
export function shownField(source: LightSource, name: string): NumberField {
  const get = (other: string) => source.getAuthored(other);
  const variant = variantOfField(source.fields[name] as Field, get);
  return fieldInUnit(variant, (other) => [get(other)]) as NumberField;
}

/** Colour temperature of a light as its row shows it, such as '2,700 K'; '' for a light whose colour is set by hand. */
export function temperatureText(source: LightSource): string {
  const name = ['temperature', 'kelvin'].find((each) => Object.hasOwn(source.fields, each) && isShown(source, each));
  return name === undefined ? '' : t('{count} K', { count: Number(source.getAuthored(name)) });
}

/** Id of the object that is a light's group; null for none. */
export const groupOf = (source: LightSource): string | null => (source instanceof Light ? source.group : null);
