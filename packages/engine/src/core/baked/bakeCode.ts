import { LateCode } from '../../base/LateCode';

/** The code that lights scenes by baked light, which most scenes do not need. */
export const bakeCode = new LateCode(
  () => import('./ShownBake'),
  'The code of baked light could not be fetched: see that the network is there, and open it again.',
);

/**
 * Fetches the code that displays baked light, which most scenes do not need.
 * @throws Error (as a rejection) when it cannot be fetched; the next call tries again
 */
export const loadBakeCode = () => bakeCode.load();
