import { expect, it } from 'vitest';
import { lightKindNames, shadingNames } from '../plan/lightKinds';
import { loadCompetitor } from './index';

const scene = { lights: 1, shadows: 0, kind: 'points', shading: 'own' } as const;

it('Farol and three take what they can, and say what they cannot', async () => {
  const refusals = async (name: string) => {
    const competitor = await loadCompetitor(name);
    const kinds = lightKindNames.filter((kind) => competitor.refuses({ ...scene, kind }) !== null);
    return [...kinds, ...shadingNames.filter((shading) => competitor.refuses({ ...scene, shading }) !== null)];
  };
  expect(await refusals('deferred')).toEqual([]);
  expect(await refusals('auto')).toEqual([]);
  expect(await refusals('multipass')).toEqual(lightKindNames.slice(1).concat('gouraud' as never));
  const rivals = lightKindNames.slice(1).concat('gouraud' as never);
  for (const name of ['playcanvas', 'babylon']) expect(await refusals(name)).toEqual(rivals);
});
