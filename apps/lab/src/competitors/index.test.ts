import { describe, expect, it } from 'vitest';
import { competitorNames } from './competitorNames';
import { competitors, loadCompetitor } from './index';

describe('competitors', () => {
  it('are those that the page names, in words of the same kind', async () => {
    expect(Object.keys(competitors).sort()).toEqual(Object.keys(competitorNames).sort());
    for (const [name, words] of Object.entries(competitorNames)) {
      if (name === 'three-webgpu') continue; // its code needs a browser
      expect(await loadCompetitor(name)).toMatchObject({ name, ...words });
    }
  });

  it('names those there are when one is unknown', async () => {
    await expect(loadCompetitor('unity')).rejects.toThrow(/no competitor ‘unity’: choose one of auto, forward/);
    await expect(loadCompetitor('toString')).rejects.toThrow('no competitor');
  });
});
