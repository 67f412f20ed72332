import type { Field } from '@farol/engine/fields';
import { type EffectEntry, effects } from '@farol/renderer/effects';

/** Effects of the renderer, by key. */
export const effectEntries: Readonly<Record<string, EffectEntry>> = effects;

/** Name of an effect's switch in addresses; '' for one without a switch. */
export const switchName = ({ short, setting = '' }: EffectEntry): string => short ?? setting;

/** Values of the address parameter `aa`. */
export const antialiasingNames = [
  'none',
  ...Object.keys(effects).filter((name) => effectEntries[name].group === 'antialiasing'),
];

/** Address parameters of the effects besides anti-aliasing: for each effect its switch, then its numbers. */
export const effectParameters: Readonly<Record<string, Field>> = Object.fromEntries(
  Object.values(effectEntries)
    .filter((entry) => entry.setting !== undefined)
    .flatMap((entry): [string, Field][] => {
      const { label, help = label, fields = {} } = entry;
      const visibleWhen = { field: switchName(entry), equals: [true] };
      return [
        [switchName(entry), { kind: 'boolean', default: false, label, help }],
        ...Object.entries(fields)
          .filter(([, { kind }]) => kind === 'number')
          .map(([name, field]): [string, Field] => [name, { ...field, visibleWhen }]),
      ];
    }),
);
