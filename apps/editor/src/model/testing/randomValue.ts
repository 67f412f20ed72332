import type { Field, FieldValue } from '@farol/engine/fields';
import type { EditorDocument } from '../EditorDocument';
import { importedTextures } from './randomAssetCommand';
import { below, objectsOf, pick, type Random } from './random';

/** Random times for keys of a curve, ascending. */
const randomTimes = (random: Random): number[] =>
  Array.from({ length: 1 + below(random, 6) }, () => below(random, 11) / 10).toSorted((a, b) => a - b);

export function randomValue(random: Random, field: Field, document: EditorDocument): FieldValue {
  const between = (min = -20, max = 20): number => min + random() * (Math.min(max, min + 1000) - min);
  switch (field.kind) {
    case 'number':
      return field.integer ? Math.ceil(between(field.min, field.max)) : between(field.min, field.max);
    case 'angle':
      return between(field.min, field.max);
    case 'boolean':
      return random() < 0.5;
    case 'string':
      return `text ${below(random, 100)}`;
    case 'choice':
      return pick(random, field.options);
    case 'vector3':
      return [between(field.min, field.max), between(field.min, field.max), between(field.min, field.max)];
    case 'euler':
      return [between(-4, 4), between(-4, 4), between(-4, 4)];
    case 'colour':
      return [random(), random(), random() * 3];
    case 'curve':
      return randomTimes(random).map((time) => [time, between(field.min, field.max)] as const);
    case 'gradient':
      return randomTimes(random).map(
        (time, i) =>
          [time, i > 0 && random() < 0.4 ? null : ([random(), random(), random() * 3] as const), random()] as const,
      );
    case 'asset': {
      const names = document.assets.list(field.assetType).filter((name) => name !== 'dragon' && !name.includes('/'));
      const imported = field.assetType === 'texture' && random() < 0.3 ? importedTextures(document) : [];
      const choices = imported.length > 0 ? imported : names.slice(0, 6);
      return choices.length === 0 || random() < 0.2 ? null : pick(random, choices);
    }
    case 'custom':
      return field.default;
    case 'object':
      return random() < 0.3 ? null : pick(random, objectsOf(document.scene)).id;
  }
}
