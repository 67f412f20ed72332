import { number } from '@farol/editing/fields';

/** Field of the seed, a parameter of every demo scene. */
export const seedField = number(1, {
  integer: true,
  min: 0,
  max: 2 ** 31 - 1,
  help: 'Another number, other paths and colours of the lights.',
});
