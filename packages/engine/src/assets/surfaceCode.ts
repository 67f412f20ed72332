import { LateCode } from '../base/LateCode';

const late = new LateCode(
  () => import('@farol/renderer/surfaces'),
  'The code of surfaces could not be fetched: see that the network is there, and open it again.',
);

/** The renderer's code of surfaces; null until `loadSurfaceCode` is done. */
export const surfaceCode = () => late.code;

/** Fetches the renderer's code of surfaces, which most scenes do without. @throws Error (as a rejection) when it cannot be fetched; try again */
export const loadSurfaceCode = () => late.load();
