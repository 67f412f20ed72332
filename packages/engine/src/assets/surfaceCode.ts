type SurfaceCode = typeof import('@farol/renderer/surfaces');

let code: SurfaceCode | null = null;
let loading: Promise<SurfaceCode> | null = null;

/** The renderer's code of surfaces; null until `loadSurfaceCode` is done. */
export const surfaceCode = (): SurfaceCode | null => code;

/** Fetches the renderer's code of surfaces, which most scenes do without. @throws Error when it cannot be fetched; try again */
export function loadSurfaceCode(): Promise<SurfaceCode> {
  loading ??= import('@farol/renderer/surfaces').then(
    (module) => (code = module),
    (cause: unknown) => {
      loading = null;
      throw new Error('The code of surfaces could not be fetched: see that the network is there, and open it again.', {
        cause,
      });
    },
  );
  return loading;
}
