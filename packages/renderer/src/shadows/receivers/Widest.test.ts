import { expect, it } from 'vitest';
import { Widest } from './Widest';

/**
 * One frame: boxes are numbers here, and each that is greater than all before widens.
 * @returns number of widening boxes that were not listed
 */
function frame(widest: Widest, boxes: readonly number[]): number {
  let most = -Infinity;
  let others = 0;
  for (let i = 0; i < widest.count; i++) {
    const at = widest.list[i];
    if (boxes[at] > most) {
      most = boxes[at];
      widest.keep(at);
    }
  }
  boxes.forEach((size, at) => {
    if (size <= most) return;
    most = size;
    others++;
    widest.find(at);
  });
  widest.end();
  expect(most).toBe(Math.max(...boxes));
  return others;
}

it('Widest lists the one that counts first, and forgets those that do not', () => {
  const widest = new Widest();
  const boxes = Array.from({ length: 200 }, (_, i) => i);
  expect(frame(widest, boxes)).toBe(200);
  expect(widest.count).toBe(48);
  expect(widest.list[0]).toBe(199);
  expect(frame(widest, boxes)).toBe(0);
  expect([...widest.list.subarray(0, widest.count)]).toEqual([199]);
  boxes[7] = 500;
  expect(frame(widest, boxes)).toBe(1);
  expect(frame(widest, boxes)).toBe(0);
  expect([...widest.list.subarray(0, widest.count)]).toEqual([7]);
});
