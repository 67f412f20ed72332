import { techniques } from '@farol/renderer';
import type { Technique } from '@farol/renderer/authoring';
import { expect, test } from 'vitest';
import { techniqueLimits } from './techniqueLimits';

test('what is said of the techniques is what their passes do', async () => {
  for (const [name, technique] of Object.entries<Technique>(techniques)) {
    const { occlusion, samples, decals } = techniqueLimits(techniques, name);
    if (name === 'auto') {
      expect([occlusion, samples, decals]).toEqual([false, false, false]);
      continue;
    }
    await technique.lazy?.load();
    const written = technique.passes().flatMap((pass) => [...pass.writes]);
    const hasGBuffer = written.includes('gbuffer');
    // the depth of 'inferred' is of half the size
    const hasDepth = hasGBuffer || (written.includes('scene-depth') && name !== 'inferred');
    expect({ name, decals, samples }).toEqual({ name, decals: !hasGBuffer, samples: hasGBuffer });
    expect({ name, occlusion }).toEqual({ name, occlusion: !hasDepth });
  }
});

test('of a technique that is not there nothing is said', () => {
  for (const name of ['', 'of a plugin that is gone', 'constructor'])
    expect(techniqueLimits(techniques, name)).toEqual({ occlusion: false, samples: false, decals: false });
});
