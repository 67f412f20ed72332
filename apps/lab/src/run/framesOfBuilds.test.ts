import { expect, it } from 'vitest';
import type { Stage } from '../stage/Stage';
import { framesOfBuilds } from './framesOfBuilds';
import type { StageFrames } from './StageFrames';

it('asks the other build for competitors whose key ends in @against, by their own key', async () => {
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
  const frames = framesOfBuilds({} as HTMLElement, make);
  await frames.setOwnScene(new Uint8Array());
  const options = { signal: new AbortController().signal, longestFrame: 1 };
  for (const name of ['deferred', 'deferred@against']) {
    const stage = await frames.stageOf(name);
    await stage.open(name, {} as never, options);
    await stage.turn(name, 1);
    stage.close(name);
  }
  frames.close();
  expect(said).toEqual([
    'own: own scene',
    ...['own: stage of deferred', 'own: open deferred', 'own: turn deferred', 'own: close deferred'],
    './against/stage.html: own scene',
    ...['stage of', 'open', 'turn', 'close'].map((what) => `./against/stage.html: ${what} deferred`),
    ...['own: closed', './against/stage.html: closed'],
  ]);
});
