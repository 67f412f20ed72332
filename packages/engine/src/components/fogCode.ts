import { LateCode } from '../base/LateCode';

/** The renderer's code of fog, which most scenes do not need. */
export const fogCode = new LateCode(
  () => import('@farol/renderer/volumetric-fog'),
  'The code of fog could not be fetched: see that the network is there, and add one again.',
);
