/** Ascending times of keys; two may be equal. */
const timesOf = (random: () => number): number[] =>
  Array.from({ length: 1 + Math.floor(random() * 6) }, () => Math.round(random() * 20) / 20).toSorted((a, b) => a - b);

import type { Field, FieldValue, GradientKey } from '@farol/editing/fields';

/** A value that a field allows, other than its default wherever that is possible; for tests. */
export function randomFieldValue(field: Field, random: () => number, assetNames: readonly string[] = []): FieldValue {
  const between = (min = -100, max = min + 200): number => {
    const value = min + random() * (max - min);
    return 'integer' in field && field.integer ? Math.round(value) : value;
  };
  switch (field.kind) {
    case 'number':
    case 'angle':
      return between(field.min, field.max);
    case 'boolean':
      return !field.default;
    case 'string':
      return `text ${Math.floor(random() * 1e6)}`;
    case 'choice':
      return field.options[Math.floor(random() * field.options.length)];
    case 'vector3':
      return [between(field.min, field.max), between(field.min, field.max), between(field.min, field.max)];
    case 'euler':
      return [between(-3, 3), between(-3, 3), between(-3, 3)];
    case 'colour':
      return [random() * 2, random(), random()];
    case 'curve':
      return timesOf(random).map((time) => [time, between(field.min, field.max)] as const);
    case 'gradient':
      return timesOf(random).map((time, i): GradientKey => {
        const colour = [random() * 2, random(), random()] as const;
        // the first key has both colour and opacity, so that the gradient has at least one of each
        const which = i === 0 ? 0 : random();
        return [time, which > 0.7 ? null : colour, which > 0.4 && which < 0.7 ? null : random()];
      });
    case 'asset':
      return assetNames.length > 0 ? assetNames[Math.floor(random() * assetNames.length)] : null;
    case 'object':
      return null;
    case 'custom':
      return field.default;
  }
}
