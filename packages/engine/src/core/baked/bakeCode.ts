import { LateCode } from '../../base/LateCode';

const late = new LateCode(
  () => import('./ShownBake'),
  'The code of baked light could not be fetched: see that the network is there, and open it again.',
);

/** Class that displays baked light; null until `loadBakeCode` is done. */
export const bakeCode = () => late.code?.ShownBake ?? null;

/**
 * Fetches the code that displays baked light, which most scenes do not need.
 * @throws Error (as a rejection) when it cannot be fetched; try again
 */
export const loadBakeCode = () => late.load();
