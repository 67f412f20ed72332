import { number } from '@farol/editing/fields';

/** The seed that every scene has as a parameter. */
export const seedField = number(1, {
  integer: true,
  min: 0,
  max: 2 ** 31 - 1,
  help: 'Another number, other paths and colours of the lights.',
});
