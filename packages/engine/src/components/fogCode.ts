import { LateCode } from '../base/LateCode';

const late = new LateCode(
  () => import('@farol/renderer/volumetric-fog'),
  'The code of fog could not be fetched: see that the network is there, and add one again.',
);

/** The renderer's code of fog; null until `loadFogCode` is done. */
export const fogCode = () => late.code;

/**
 * Fetches the renderer's code of fog, which most scenes do not need.
 * @throws Error (as a rejection) when it cannot be fetched; try again
 */
export const loadFogCode = () => late.load();
