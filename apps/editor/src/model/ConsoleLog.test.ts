import { expect, it } from 'vitest';
import { ConsoleLog } from './ConsoleLog';

it('says the same once, with its count, and keeps the last five hundred', () => {
  const log = new ConsoleLog();
  log.add('error', 'shader', 'broken', { chunk: 'a', line: 3 });
  log.add('info', 'file', 'saved');
  log.add('error', 'shader', 'broken', { chunk: 'a', line: 4 });
  log.add('error', 'component', 'broken');
  expect(log.entries.map(({ text, source, count }) => `${source} ${text} ${count}`)).toEqual([
    'file saved 1',
    'shader broken 2',
    'component broken 1',
  ]);
  expect(log.entries[1].place?.line).toBe(4);
  log.add('error', 'script', 'thrown', { script: 'Spin', line: 7 });
  expect(log.entries.at(-1)!.place).toEqual({ script: 'Spin', line: 7 });
  expect(log.count('error')).toBe(3);
  for (let i = 0; i < 600; i++) log.add('info', 'page', String(i));
  expect(log.entries.length).toBe(500);
  expect(log.entries.at(-1)!.text).toBe('599');
  log.clear();
  expect(log.entries).toEqual([]);
});
