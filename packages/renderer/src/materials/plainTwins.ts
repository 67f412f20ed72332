import { BackSide, FrontSide } from 'three';
import type { TwinKind } from './TwinKind';

/** Unchanged twin of an unlit material, for effects to adapt. */
export const plainWhole: TwinKind = { key: 'plain', chunks: () => [], patch: () => undefined };

/** Back and front of an unlit transparent double-sided material, so that the host's `side` need not be switched. */
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
