import { expect, it } from 'vitest';
import { type LabCase, plainCase } from '../plan/LabPlan';
import type { Stage } from '../stage/Stage';
import { framesOfBuilds } from './framesOfBuilds';
import type { StageFrames } from './StageFrames';

it('asks the other build for competitors whose key ends in @against, by their own key, and none for what crashed', async () => {
  const said: string[] = [];
  const make = (_parent: HTMLElement, url = 'own'): StageFrames => ({
    async stageOf(competitor) {
      said.push(`${url}: stage of ${competitor}`);
      const say = (what: string) => async (name: string) => void said.push(`${url}: ${what} ${name}`);
      return { open: say('open'), turn: say('turn'), close: say('close') } as unknown as Stage;
    },
    setOwnScene: async () => void said.push(`${url}: own scene`),
    close: () => void said.push(`${url}: closed`),
  });
  const labCase: LabCase = {
    ...{ scene: { name: 'sponza', parameters: {} }, lights: 10, shadows: 0, overdraw: 0, width: 64, height: 36 },
    ...plainCase,
  };
  const crashes = [{ competitor: 'stock', labCase }];
  const frames = framesOfBuilds({} as HTMLElement, crashes, make);
  await frames.setOwnScene(new Uint8Array());
  const options = { signal: new AbortController().signal, longestFrame: 1 };
  for (const name of ['deferred', 'deferred@against']) {
    const stage = await frames.stageOf(name);
    await stage.open(name, labCase, options);
    await stage.turn(name, 1);
    stage.close(name);
  }
  const stage = await frames.stageOf('stock');
  await expect(stage.open('stock', { ...labCase }, options)).rejects.toThrow(/crashed or hung/);
  await stage.open('stock', { ...labCase, lights: 20 }, options);
  frames.close();
  expect(said).toEqual([
    'own: own scene',
    ...['own: stage of deferred', 'own: open deferred', 'own: turn deferred', 'own: close deferred'],
    './against/stage.html: own scene',
    ...['stage of', 'open', 'turn', 'close'].map((what) => `./against/stage.html: ${what} deferred`),
    ...['own: stage of stock', 'own: open stock'],
    ...['own: closed', './against/stage.html: closed'],
  ]);
});
