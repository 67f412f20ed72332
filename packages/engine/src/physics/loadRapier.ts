/** Rapier's module, initialised. */
export type Rapier = typeof import('@dimforge/rapier3d-compat');

let loading: Promise<Rapier> | null = null;

/** Fetches Rapier with its WebAssembly, once. @throws Error (as a rejection) when it cannot be fetched; the next call tries again */
export function loadRapier(): Promise<Rapier> {
  loading ??= import('@dimforge/rapier3d-compat').then(
    async (rapier) => {
      await rapier.init();
      return rapier;
    },
    (error: unknown) => {
      loading = null;
      throw error;
    },
  );
  return loading;
}
