import { techniques } from '@farol/renderer';
import { expect, test } from 'vitest';
import { techniqueLimits } from './techniqueLimits';

test('what is said of the techniques is what their passes do', () => {
  for (const [name, technique] of Object.entries(techniques)) {
    const { occlusion, samples, decals } = techniqueLimits(name);
    if (name === 'auto') expect([occlusion, samples, decals]).toEqual([false, false, false]);
    if (name === 'auto' || 'lazy' in technique) continue;
    const written = technique.passes().flatMap((pass) => [...pass.writes]);
    const hasGBuffer = written.includes('gbuffer');
    expect({ name, decals, samples }).toEqual({ name, decals: !hasGBuffer, samples: hasGBuffer });
    expect({ name, occlusion }).toEqual({ name, occlusion: !hasGBuffer && !written.includes('scene-depth') });
  }
});
