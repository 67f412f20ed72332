import { expect, it } from 'vitest';
import { ConsoleLog } from './ConsoleLog';
import { Notices } from './Notices';
import { readableText } from './readableText';

const make = (): { log: ConsoleLog; notices: Notices } => {
  const log = new ConsoleLog();
  return { log, notices: new Notices(log) };
};

it('says the same once, and counts it', () => {
  const { log, notices } = make();
  const first = notices.show('info', 'Saved');
  notices.show('info', 'Opened');
  const again = notices.show('info', 'Saved');
  expect(again).toBe(first);
  expect(notices.current.map(({ text, count }) => [text, count])).toEqual([
    ['Opened', 1],
    ['Saved', 2],
  ]);
  expect(log.entries.map(({ text, count }) => [text, count])).toEqual([
    ['Opened', 1],
    ['Saved', 2],
  ]);
  // a repeated message counts from 1 again after its notice was removed
  notices.remove(first);
  notices.show('info', 'Saved');
  expect(notices.current.at(-1)).toMatchObject({ text: 'Saved', count: 1 });
});

it('shows the latest three, and never drops what lasts for them', () => {
  const { notices } = make();
  notices.show('error', 'The device was lost', 'picture', { lasts: true });
  for (let i = 0; i < 9; i++) notices.show('info', `Message ${i}`);
  expect(notices.current.map(({ text }) => text)).toEqual([
    ...['The device was lost', 'Message 6', 'Message 7', 'Message 8'],
  ]);
});

it('shows no broken bytes', () => {
  const { log, notices } = make();
  notices.show('error', 'a\u0000\u0001\ufffd\ufffd\ud800b\u202egnp.exe: \\u{0}\\u{fffd} is no scene');
  expect(notices.current[0].text).toBe('a…b…gnp.exe: … is no scene');
  expect(log.entries[0].text).toBe('a…b…gnp.exe: … is no scene');
  expect(readableText('Añadido 😀\n\tfin')).toBe('Añadido 😀\n\tfin');
});

it('shows no more of a message than can be read', () => {
  const { log, notices } = make();
  notices.show('error', `${'x'.repeat(1_000_000)} is not there`);
  expect(notices.current[0].text.length).toBeLessThan(2100);
  expect(log.entries[0].text.length).toBeLessThan(2100);
});
