import { workOf } from '@farol/tools/workOf';
import { expect, test } from 'vitest';
import { Dialogs } from '../model/Dialogs';
import { askForHosts } from './askForHosts';

test('hosts and names are listed short, and few of very many, by work that grows with them alone', async () => {
  const dialogs = new Dialogs();
  const long = 'x'.repeat(100_000);
  const many = Array.from({ length: 6000 }, (_, i) => ({
    asset: `${i} ${i < 9 ? long : ''}`,
    url: '',
    origin: `https://${i < 9 ? long : ''}${i % 3000}.test`,
  }));
  let answer: Promise<boolean>;
  const work = await workOf(() => void (answer = askForHosts(dialogs, 'scene.farol', many)));
  expect(work).toBeLessThan(3 * many.length);
  const request = dialogs.current as unknown as { problems: { path: string; problem: string }[] };
  expect(request.problems).toHaveLength(31);
  expect(request.problems.at(-1)).toEqual({ path: '', problem: '… and 2,979 more' });
  expect(request.problems[20]).toEqual({ path: 'https://20.test', problem: '20 , 3020 ' });
  for (const { path, problem } of request.problems) expect(path.length + problem.length).toBeLessThan(400);
  dialogs.close(true);
  expect(await answer!).toBe(true);
});
