import { describe, expect, it } from 'vitest';
import { findClaims } from './findClaims';

describe('findClaims', () => {
  it('reads the comparison, what comes before it, and the line', () => {
    const text =
      '// f\r\n//? f(vec2(0.0), 1.0) == 2.0\r\n  //? float a = f(1.0); vec2 b = vec2(a); b == vec2(1.0)\r\nfloat f() { return a == b ? 1.0 : 0.0; }';
    expect(findClaims(text)).toEqual([
      { line: 2, text: 'f(vec2(0.0), 1.0) == 2.0', setup: '', left: 'f(vec2(0.0), 1.0)', right: '2.0' },
      {
        line: 3,
        text: 'float a = f(1.0); vec2 b = vec2(a); b == vec2(1.0)',
        setup: 'float a = f(1.0); vec2 b = vec2(a);',
        left: 'b',
        right: 'vec2(1.0)',
      },
    ]);
  });

  it('refuses a claim that compares nothing, with its line', () => {
    expect(() => findClaims('// f\n//? f(1.0) = 2.0')).toThrow(/Line 2: the claim "f\(1\.0\) = 2\.0"/);
  });
});
