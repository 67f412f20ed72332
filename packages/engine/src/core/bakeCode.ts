import type { ShownBake } from '../bake/ShownBake';

let code: typeof ShownBake | null = null;
let loading: Promise<void> | null = null;

/** What lights scenes by baked light; null until `loadBakeCode` is done. */
export const bakeCode = (): typeof ShownBake | null => code;

/** Fetches what lights scenes by baked light, which most scenes do without. @throws Error (as a rejection) when it cannot be fetched; try again */
export async function loadBakeCode(): Promise<void> {
  loading ??= import('../bake/ShownBake').then(
    (module) => void (code = module.ShownBake),
    (cause: unknown) => {
      loading = null;
      throw new Error(
        'The code of baked light could not be fetched: see that the network is there, and open it again.',
        {
          cause,
        },
      );
    },
  );
  return loading;
}
