import type { RequiredEffect } from '../core/RequiredEffect';

type DecalCode = typeof import('@farol/renderer/decals');

let code: DecalCode | null = null;
let loading: Promise<void> | null = null;

/** The renderer's code of decals; null until `loadDecalCode` is done. */
export const decalCode = (): DecalCode | null => code;

/** Fetches the renderer's code of decals, which most scenes do without. @throws Error when it cannot be fetched; try again */
export async function loadDecalCode(): Promise<void> {
  loading ??= import('@farol/renderer/decals').then(
    (module) => void (code = module),
    (cause: unknown) => {
      loading = null;
      throw new Error('The code of decals could not be fetched: see that the network is there, and add one again.', {
        cause,
      });
    },
  );
  return loading;
}

/** The effect that draws decals. */
export const decalsEffect: RequiredEffect = {
  get effectClass() {
    return code?.Decals ?? null;
  },
  load: loadDecalCode,
};
