import { expect, test } from 'vitest';
import { draggedAsset, setDraggedAsset } from './dragAsset';

/** A DataTransfer as a browser provides during a drag. */
function transferOf(text?: string): DataTransfer {
  const data = new Map<string, string>(text === undefined ? [] : [['application/x-farol-asset', text]]);
  return {
    setData: (type: string, value: string) => void data.set(type, value),
    getData: (type: string) => data.get(type) ?? '',
  } as unknown as DataTransfer;
}

test('an asset that is dragged comes as it was given', () => {
  const transfer = transferOf();
  setDraggedAsset(transfer, { kind: 'mesh', name: 'Props/a.ply' }, ['Props/a.ply', 'b.ply']);
  expect(draggedAsset(transfer)).toEqual({ kind: 'mesh', name: 'Props/a.ply', names: ['Props/a.ply', 'b.ply'] });
  expect(draggedAsset(transferOf('{"kind":"mesh","name":"a"}'))).toEqual({ kind: 'mesh', name: 'a' });
});

test.each([
  '{',
  'null',
  '[]',
  '5',
  '{"kind":"mesh"}',
  '{"kind":5,"name":"a"}',
  '{"kind":"mesh","name":"a","names":5}',
  '{"kind":"mesh","name":"a","names":[{}]}',
])('what another page drags as one is none: %s', (text) => {
  expect(draggedAsset(transferOf(text))).toBeNull();
});
