import { LateCode } from '../base/LateCode';
import type { RequiredEffect } from '../core/RequiredEffect';

const late = new LateCode(
  () => import('@farol/renderer/decals'),
  'The code of decals could not be fetched: see that the network is there, and add one again.',
);

/** The renderer's code of decals; null until `loadDecalCode` is done. */
export const decalCode = () => late.code;

/**
 * Fetches the renderer's code of decals, which most scenes do not need.
 * @throws Error (as a rejection) when it cannot be fetched; try again
 */
export const loadDecalCode = () => late.load();

/** The effect that draws decals. */
export const decalsEffect: RequiredEffect = {
  get effectClass() {
    return late.code?.Decals ?? null;
  },
  load: loadDecalCode,
};
