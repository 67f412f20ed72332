import { expect, test } from 'vitest';
import { withSteps } from './countSteps.mjs';
import { growthOf, workOf } from './workOf.mjs';

/** A function of one number, of JavaScript that counts its steps. */
const counting = (body: string): ((count: number) => unknown) =>
  // oxlint-disable-next-line no-implied-eval -- it is code that is tested
  new Function('count', withSteps(body)) as (count: number) => unknown;

test.each([
  ['for (let i = 0; i < count; i++);', 7],
  ['for (let i = 0; i < count; i++) { if (i > 2) continue; }', 7],
  ['let i = count; while (i > 0) i--;', 7],
  ['let i = count; do i--; while (i > 0);', 7],
  ['for (const key in { a: 1, b: 2 }) if (key === "a") continue;', 2],
  ['const f = () => 1; for (let i = 0; i < count; i++) f();', 14],
  ['const f = () => ({ a: 1 }); if (f().a !== 1) throw new Error();', 1],
  ['class A { constructor() {} get a() { return 1; } } const a = new A(); if (a.a) a.a;', 3],
  ['function* f() { yield 1; yield 2; } let it = f(); it.next(); it.next();', 1],
])('calls and passes of a loop are steps: %s', async (body, steps) => {
  const run = counting(body);
  expect(await workOf(() => void run(7))).toBe(steps);
});

test.each([
  ['new Array(count).fill(1).indexOf(1, 20)', 100 + 1],
  ['new Array(count).includes(1)', 100],
  ['new Array(count).splice(90, 4)', 10],
  ['[...new Array(count)]', 101],
  ['new Set(new Array(count))', 101],
  ['[...new Map([[1, 2]])]', 4],
  ['new Array(...new Array(count))', 101],
  ['const [first] = new Array(count); first', 1],
  ['"x".repeat(count).indexOf("y", 10)', 190],
  ['JSON.stringify("x".repeat(count - 2))', 198],
])('built-in functions have a step for each 64 elements: %s', async (body, elements) => {
  const run = counting(`(() => { ${body}; })();`);
  expect(await workOf(() => void run(100))).toBe(1 + elements / 64);
});

test('built-in functions are as before afterwards, also after an error', async () => {
  const before = [Array.prototype.indexOf, JSON.stringify, Object.getPrototypeOf([][Symbol.iterator]()).next];
  await expect(workOf(() => Promise.reject(new Error('wrong')))).rejects.toThrow('wrong');
  await expect(workOf(() => {})).rejects.toThrow('No work was counted');
  expect([Array.prototype.indexOf, JSON.stringify, Object.getPrototypeOf([][Symbol.iterator]()).next]).toEqual(before);
});

test('growth tells work that grows with a number from work that grows with its square', async () => {
  const growth = (body: string) => {
    const run = counting(body);
    return growthOf(500, (count) => () => run(count));
  };
  expect(await growth('let sum = 0; for (let i = 0; i < count; i++) sum += i;')).toBe(4);
  const list = 'Array.from({ length: count }, (_, i) => i)';
  expect(await growth(`${list}.filter((each) => ${list}.includes(each));`)).toBeGreaterThan(10);
  expect(await growth(`const list = ${list}; while (list.length > 0) list.splice(0, 1);`)).toBeGreaterThan(10);
});
