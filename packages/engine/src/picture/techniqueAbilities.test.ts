import { techniques } from '@farol/renderer';
import type { Technique } from '@farol/renderer/authoring';
import { expect, test } from 'vitest';
import { techniqueAbilities } from './techniqueAbilities';

test('what is said of the techniques is what their passes do', async () => {
  for (const [name, technique] of Object.entries<Technique>(techniques)) {
    const { depth, samples, gbuffer } = techniqueAbilities(techniques, name);
    if (name === 'auto') {
      expect([depth, samples, gbuffer]).toEqual([true, true, true]);
      continue;
    }
    await technique.lazy?.load();
    const written = technique.passes().flatMap((pass) => [...pass.writes]);
    const hasGBuffer = written.includes('gbuffer');
    // the depth of 'inferred' has half the resolution
    const hasDepth = hasGBuffer || (written.includes('scene-depth') && name !== 'inferred');
    expect({ name, gbuffer, samples, depth }).toEqual({
      name,
      gbuffer: hasGBuffer,
      samples: !hasGBuffer,
      depth: hasDepth,
    });
  }
});

test('a technique that is not there is taken to be able to do all', () => {
  for (const name of ['', 'of a plugin that is gone', 'constructor'])
    expect(techniqueAbilities(techniques, name)).toEqual({ depth: true, samples: true, gbuffer: true });
});
