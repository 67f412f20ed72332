import { MicroShaderRegistry } from '@farol/renderer/microshaders';
import { growthOf } from '@farol/tools/workOf';
import { expect, it } from 'vitest';
import { MicroShaderOverrides } from './MicroShaderOverrides';

it('takes hundreds that need one another in and out by work that grows with their square at most', async () => {
  const growth = await growthOf(100, (count) => {
    const overrides = new MicroShaderOverrides(new MicroShaderRegistry() as never);
    const texts = Array.from({ length: count }, (_, i): [string, string] => [
      `c${i}`,
      i % (count / 4) === 0 ? 'float a;' : `#include "c${i - 1}"\nfloat a;`,
    ]);
    return () => {
      expect(overrides.apply(new Map(texts))).toEqual([]);
      expect(overrides.apply(new Map())).toEqual([]);
      expect(overrides.apply(new Map(texts.toReversed()))).toEqual([]);
      expect(overrides.apply(new Map())).toEqual([]);
      expect(overrides.registry.names()).toEqual([]);
    };
  });
  expect(growth).toBeLessThan(17);
});
