import { describe, expect, test, vi } from 'vitest';
import { guardLoops } from './guardLoops';
import { LOOP_LIMIT, loopCheck } from './loopCheck';

/** Number of clock readings after which a loop counts as endless in this test. */
const LOOKS = 50;

const run = (body: string, check: () => void, declare = 'function'): unknown =>
  // oxlint-disable-next-line no-implied-eval -- as the page runs scripts
  new Function('$check', `"use strict";let $passes=0;return (${declare} (){${guardLoops(body)}})()`)(check);

/**
 * Runs a text with an endless loop. @returns number of clock readings until it was stopped
 * @returns how often the clock was looked at before it was ended
 */
function looksOf(body: string): number {
  let looks = 0;
  const check = (): void => {
    if (++looks > LOOKS) throw new Error('endless');
  };
  expect(() => run(body, check)).toThrow('endless');
  return looks;
}

const ENDLESS_ITERATOR = 'const all = { [Symbol.iterator]: () => ({ next: () => ({ done: false, value: 1 }) }) };';

describe('a loop without an end is ended', () => {
  const forms: Record<string, string> = {
    'for (;;)': 'for (;;);',
    'for (;;) {}': 'for (;;) {}',
    'for with a condition': 'let i = 0; for (i = 0; i >= 0; i++) i = i % 10;',
    'for that counts without a bound': 'for (let i = 0; ; i++) {}',
    'for that counts to Infinity': 'for (let i = 0; i < Infinity; i += 2) { const a = i * 2; }',
    'for that counts down': 'for (let i = 10 - 1; i < 10; i--) {}',
    'for whose body turns its counter back': 'for (let i = 0; i < 10; i++) { i = 0; }',
    'for whose body takes its counter from a list': 'for (let i = 0; i < 10; i++) { [i] = [0]; }',
    'for whose counter stands still': 'for (let i = 0; i < 10; i += 0) {}',
    'for whose counter is a function’s, too': 'for (let i = 0; i < 10; i++) { (() => (i = 0))(); }',
    'for with a counter of BigInt': 'for (let i = 0n; i >= 0n; i++) {}',
    while: 'while (true);',
    'while {}': 'while (true) {}',
    do: 'do ; while (true);',
    'do {}': 'do { } while (true)',
    'for of': `${ENDLESS_ITERATOR} let s = 0; for (const a of all) s += a;`,
    'for of with nothing': `${ENDLESS_ITERATOR} for (const a of all);`,
    'for of {}': `${ENDLESS_ITERATOR} for (const a of all) {}`,
    'for of with an if': `${ENDLESS_ITERATOR} for (const a of all) if (a) continue; else break;`,
    'for of in a for of': `${ENDLESS_ITERATOR} for (const a of all) for (const b of [1]) if (b) continue;`,
    'a generator': 'function* all() { while (true) yield 1; } [...all()];',
    'for in, again and again':
      'const o = { a: 1 }; function f() { for (const k in o) f2(k); } function f2() {} f(); while (1) f();',
    'with a label':
      'outer: for (let i = 0; i < 2; i++) { while (true) continue outer; i--; } outer: while (true) { for (;;) continue outer; }',
    'loops in a switch': 'switch (1) { case 1: for (;;) {} }',
    'that catches what ends it':
      'let n = 0; while (n < 3) { try { while (true) {} } catch { n++; } } throw new Error("endless");',
    'that is deep':
      'for (let a = 0; a < 1e9; a++) { for (let b = 0; b < 100; b++) { for (let c = 0; c < 100; c++) {} } }',
    'of functions that call themselves': 'function f(n) { for (const k of [1, 2]) if (n > 0) f(n - 1); } f(60);',
  };
  test.each(Object.entries(forms))('%s', (_name, body) => void expect(looksOf(body)).toBeGreaterThan(LOOKS));

  test.each(['for (const a of endless()) await a;', 'for await (const a of endless()) ;', 'while (true) await null;'])(
    'of promises: %s',
    async (body) => {
      const text = `function* endless() { let i = 0; while (i < 1e12) yield i++; } ${body}`;
      let looks = 0;
      const check = (): void => {
        if (++looks > LOOKS) throw new Error('endless');
      };
      await expect(run(text, check, 'async function')).rejects.toThrow('endless');
    },
  );
});

test.each([
  'const out = []; for (let i = 0; i < 5; i++) { if (i === 1) continue; if (i === 4) break; out.push(i); } return out;',
  'let s = 0; for (let i = 0; i < 5000; i++) { s += i; } return s;',
  'let s = 0; for (let i = 5000 - 1; i >= 0; i--) { s = s * 3 % 1000 + i; } return s;',
  'let s = 0; for (let i = 0, n = 4000; i <= n; i += 3) { s += i; } return s;',
  'let s = 0; for (let i = 0.5; i < 3000; i++) { s += i; } return s;',
  'let s = 0; for (let i = 0 / 0; i < 3000; i++) { s += 1; } return s;',
  'let s = 0; for (let i = 0; ; i++) { if (i > 3000) break; s += i; } return s;',
  'let s = 0; for (let i = 0; s += 2, i < 3000; i++, s++) { s += 1; } return s;',
  'const f = []; for (let i = 0; i < 3; i++) { f.push(() => i); } return f.map((g) => g());',
  'const f = []; for (let i = 0; i < 3; i++) { f.push({ get() { return i; } }); } return f.map((g) => g.get());',
  'const out = []; outer: for (let i = 0; i < 4; i++) { for (let j = 0; j < 4; j++) { if (j === 2) continue outer; if (i === 3) break outer; out.push(i * 10 + j); } } return out;',
  'let s = 0; for (let i = 0; i < 2000; i++) { for (let i = 0; i < 3; i++) { s += i; } } return s;',
  'if (false) for (const a of [1]) if (a) return 1; else return 2; else return 3;',
  'let s = 0; if (true) for (let i = 0; i < 2000; i++) { s++; } else s = -1; return s;',
  'const out = []; for (const k in { a: 1, b: 2 }) out.push(k); return out;',
  'let out = ""; for (const c of "abc") if (c !== "b") out += c; else out += "-"; return out;',
  'const a = [5, 6, 7]; for (let i = 0; i < a.length; i++) { a[i] = a[i] * 2; } return a;',
  'const a = []; for (let i = 0; i < 3; i++) { const [b, c] = [i, 2]; a.push(b * c); } return a;',
  'let n = 0; do n++; while (n < 700); return n;',
  'let n = 0; for (let i = 0; i < 3; i++) { switch (i) { case 1: continue; case 2: break; default: n += 10; } n++; } return n;',
  'const text = `${(() => { let s = 0; for (let i = 0; i < 3; i++) { s += i; } return s; })()}`; return text;',
])('loops that end do what they did: %s', (body) => {
  // oxlint-disable-next-line no-implied-eval -- what it is compared with
  const plain: unknown = new Function(`"use strict";${body}`)();
  expect(run(body, () => {})).toEqual(plain);
});

test('lines stay where they are', () => {
  const text = 'for (\n  let i = 0; // from\n  i < 3;\n  i++\n) {\n  x();\n}\nfor (const a of b)\n  c();\n';
  const lines = guardLoops(text).split('\n');
  expect(lines).toHaveLength(text.split('\n').length);
  expect(lines[5]).toBe('  x();');
  expect(lines[8]).toBe('  c();');
});

test('promises that never let the page have its turn are ended', async () => {
  let now = 1;
  const clock = vi.spyOn(performance, 'now').mockImplementation(() => (now += 10));
  await expect(run('while (true) await null;', loopCheck, 'async function')).rejects.toThrow(
    'A loop has gone on for 2 s',
  );
  expect(now).toBeGreaterThan(LOOP_LIMIT);
  clock.mockRestore();
  // a task of the page resets the count; its message may arrive after a timer
  await vi.waitFor(() => run('for (let i = 0; i < 1e5; i++) await null;', loopCheck, 'async function'));
});
