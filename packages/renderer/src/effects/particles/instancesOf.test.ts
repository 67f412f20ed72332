import { BoxGeometry } from 'three';
import { expect, test, vi } from 'vitest';
import { instancesOf } from './instancesOf';

test('a geometry that the CPU cannot read makes no mesh particles, which is said', () => {
  const warn = vi.spyOn(console, 'warn').mockReturnValue();
  const box = new BoxGeometry();
  expect(instancesOf(box).attributes.position.count).toBe(24);
  expect(warn).not.toHaveBeenCalled();
  (box.attributes.position as { array: unknown }).array = null;
  const made = instancesOf(box);
  expect([made.instanceCount, Object.keys(made.attributes)]).toEqual([0, []]);
  expect(warn.mock.calls.flat()).toEqual([expect.stringContaining('keep its arrays')]);
  warn.mockRestore();
});
