import { BackSide, FrontSide } from 'three';
import type { TwinKind } from './TwinKind';

/** An unlit material as it is, for effects that draw it otherwise. */
export const plainWhole: TwinKind = { key: 'plain', chunks: () => [], patch: () => undefined };

/** The two halves of an unlit transparent double-sided material, so that its side need not be switched on the host's. */
export const plainBack: TwinKind = {
  key: 'back',
  chunks: () => [],
  properties: { side: BackSide },
  patch: () => undefined,
};
export const plainFront: TwinKind = {
  key: 'front',
  chunks: () => [],
  properties: { side: FrontSide },
  patch: () => undefined,
};
