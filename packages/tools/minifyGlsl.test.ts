import { expect, it } from 'vitest';
import { minifiedGlsl } from './minifyGlsl.mjs';

it('drops comments and blanks, and keeps every line in its place', () => {
  const text = `// What it is for.
//? farol_twice(1.0) == 2.0
#include "common"

#define FOR_EACH(i) \\
  for (int i = 0; i < 4; i++)
/* two
   lines */
float farol_twice( const in float x ) { // doubles
  return 2.0 * x;
}
`;
  expect(minifiedGlsl(text)).toBe(
    [
      '',
      '',
      '#include "common"',
      '',
      '#define FOR_EACH(i) \\',
      'for(int i=0;i<4;i++)',
      '',
      '',
      'float farol_twice(float x){',
      'return 2.0*x;',
      '}',
    ].join('\n'),
  );
});

it('keeps what would change its meaning', () => {
  expect(minifiedGlsl('a = b - -c;')).toBe('a=b - -c;');
  expect(minifiedGlsl('a = b + +c;')).toBe('a=b + +c;');
  expect(minifiedGlsl('//#define kept')).toBe('//#define kept');
  expect(minifiedGlsl('#define A (x) // why')).toBe('#define A (x)');
});
