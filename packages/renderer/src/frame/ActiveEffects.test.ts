import { RGBAFormat, UnsignedByteType } from 'three';
import { expect, it } from 'vitest';
import { activeEffects, refuseConflicts } from './ActiveEffects';
import type { FarolEffect } from './FarolEffect';

const effect = (name: string, parts: Partial<FarolEffect> = {}): FarolEffect => ({
  name,
  bytes: 0,
  dispose() {},
  ...parts,
});
const attachment = (name: string) => ({ name, format: RGBAFormat, type: UnsignedByteType, bytes: 4 });

it.each([
  ['draw "transparent" in place of the technique', { replaces: 'transparent' }],
  ['add the attachment "glow" to the G-buffer', { attachments: [attachment('glow')] }],
  ['move the camera', { movesCamera: true }],
] as const)('refuses two effects that %s, by both their names', (claim, parts) => {
  const first = effect('first', parts);
  const second = effect('second', parts);
  expect(() => refuseConflicts([first, effect('other'), second])).toThrow(
    `Farol: the effects "first" and "second" both ${claim}; leave one of them out.`,
  );
  expect(() => refuseConflicts([first, effect('other')])).not.toThrow();
});

class Fade {
  readonly name = 'fade';
  dispose() {}
}

it.each([
  ['an effect without a list', new Fade()],
  ['a class', [Fade]],
  ['a name', ['fade']],
  ['null', null],
  ['a list of null', [null]],
])('refuses %s in one sentence', (_, given) => {
  expect(() => refuseConflicts(given as unknown as FarolEffect[])).toThrow(
    'Farol: effects is not a list of effects; give one, such as [new TAA()].',
  );
});

it('gathers what all effects ask for, in their order, as far as the device has room', () => {
  const adapt = (kind: never) => kind;
  const list = [
    effect('a', { attachments: [attachment('one')], adapt }),
    effect('b', { needsSurfaces: true }),
    effect('c', { attachments: [attachment('two'), attachment('three')], adapt }),
  ];
  const { adapters, attachments, needsSurfaces } = activeEffects(list, 2);
  expect(adapters).toEqual([list[0], list[2]]);
  expect(attachments.map(({ name }) => name)).toEqual(['one', 'two']);
  expect(needsSurfaces).toBe(true);
  expect(activeEffects([list[1]], 0).attachments).toEqual([]);
});
