import { expect, it } from 'vitest';
import { checkBakeOptions } from './checkOptions';

it('has defaults, and names what is out of its bounds', () => {
  expect(checkBakeOptions({})).toMatchObject({
    size: 1024,
    bounces: 3,
    samples: 256,
    indirectScale: 0.5,
    padding: 4,
    seed: 1,
    sky: 'none',
  });
  expect(() => checkBakeOptions({ size: 100 })).toThrow('size must be a multiple of 16, and is 100.');
  expect(() => checkBakeOptions({ indirectScale: 0.3 as 0.5 })).toThrow('indirectScale must be 1, 0.5 or 0.25');
  expect(() => checkBakeOptions({ bounces: 17 })).toThrow('bounces must be 0 to 16, and is 17.');
  expect(() => checkBakeOptions({ samples: 1.5 })).toThrow('samples must be a whole number, and is 1.5.');
  expect(() => checkBakeOptions({ texelsPerMetre: NaN })).toThrow(RangeError);
  expect(() => checkBakeOptions({ probes: Float32Array.of(1, 2) })).toThrow(
    'probes must be three numbers for each point.',
  );
});
