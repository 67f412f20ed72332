import { LateCode } from '../base/LateCode';

/** The renderer's code of surfaces, which most scenes do without. */
export const surfaceCode = new LateCode(
  () => import('@farol/renderer/surfaces'),
  'The code of surfaces could not be fetched: see that the network is there, and open it again.',
);
