import { Color } from 'three';
import { expect, test } from 'vitest';
import { type EffectEntry, effects, loadEffects } from '.';

const entries = Object.entries<EffectEntry>(effects);

test('the numbers of an entry are properties of the effect, with its defaults', async () => {
  const classes: Record<string, new () => object> = await loadEffects();
  for (const [name, { fields = {} }] of entries) {
    const effect = new classes[name]();
    for (const { property, default: value } of Object.values(fields)) {
      const own: unknown = Reflect.get(effect, property);
      expect([name, property, own instanceof Color ? own.toArray() : own]).toEqual([name, property, value]);
    }
  }
});

test('no two entries have one name in settings, or in addresses', () => {
  const settings = entries.flatMap(([, { setting, fields = {} }]) =>
    setting ? [setting, ...Object.keys(fields)] : [],
  );
  expect(new Set(settings).size).toBe(settings.length);
  const switches = entries.flatMap(([, { setting, short }]) => short ?? setting ?? []);
  expect(new Set(switches).size).toBe(switches.length);
});
