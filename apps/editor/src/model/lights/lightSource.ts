import { numberDisplay, t } from '@farol/editing';
import { Light, type ParticleEmitter } from '@farol/engine';
import { isFieldVisible, type NumberField, type Vector3Tuple } from '@farol/engine/fields';
import { shownIntensity } from '@farol/engine/photometry';

/** A component that lights the scene: a Light, or a ParticleEmitter whose particles are lights. */
export type LightSource = Light | ParticleEmitter;

/** Kind of a light as rows name it: the type of a Light, or 'particles'. */
export const kindOf = (source: LightSource): string => (source instanceof Light ? source.type : 'particles');

/** Name of a kind, in the user's language. */
export const kindLabel = (kind: string): string => (kind === 'particles' ? t('particles') : t(kind));

const isShown = (source: LightSource, name: string): boolean =>
  isFieldVisible(source.fields, name, (other) => source.getAuthored(other));

/** Name of the light's field that each column edits; null when the light has no such field. */
export const columnFields = {
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

/** A number as its cell shows it. */
export interface ShownNumber {
  readonly value: number;
  readonly unit?: string;
  readonly min?: number;
  readonly max?: number;
  readonly step: number;
  /** Converts from the shown unit to the field's. */
  fromShown(shown: number): number;
}

/** A light's intensity or range in its own unit; null when it has none. */
export function shownNumber(source: LightSource, column: 'intensity' | 'range'): ShownNumber | null {
  const name = columnFields[column](source);
  if (name === null) return null;
  if (source instanceof Light && name === 'intensity') {
    const { value, symbol, factor } = shownIntensity(source);
    return { value, unit: symbol, min: 0, step: value / 100 || 1, fromShown: (shown) => shown / factor };
  }
  const { toShown, ...shown } = numberDisplay(source.fields[name] as NumberField);
  return { ...shown, value: toShown(source.getAuthored(name) as number) };
}

/** Linear colour of a light, including its temperature; null for particles, which have colours of their own. */
export const colourOf = (source: LightSource): Vector3Tuple | null => (source instanceof Light ? source.colour : null);

/** Colour temperature of a light, such as '2,700 K'; '' for a light with a chosen colour. */
export const temperatureText = (source: LightSource): string =>
  source instanceof Light && source.colourBy === 'temperature' ? t('{count} K', { count: source.kelvin }) : '';

/** Number of the renderer's lights that a source makes: an emitter makes one every `lightEvery` particles. */
export const lightCount = (source: LightSource): number =>
  source instanceof Light ? 1 : Math.ceil(source.capacity / source.lightEvery);
