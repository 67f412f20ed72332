import { LateCode } from '../base/LateCode';
import type { RequiredEffect } from '../core/RequiredEffect';

/** The renderer's code of decals, which most scenes do not need. */
export const decalCode = new LateCode(
  () => import('@farol/renderer/decals'),
  'The code of decals could not be fetched: see that the network is there, and add one again.',
);

/** The effect that draws decals. */
export const decalsEffect: RequiredEffect = {
  get effectClass() {
    return decalCode.code?.Decals ?? null;
  },
  load: () => decalCode.load(),
};
