import { needsPackage } from '../base/needsPackage';

/** Rapier's module, initialised. */
export type Rapier = typeof import('@dimforge/rapier3d-compat');

/** Required Rapier version, without the patch number. */
const RAPIER = '0.21.';

let loading: Promise<Rapier> | null = null;

/**
 * Fetches Rapier with its WebAssembly, once.
 * @throws Error (as a rejection) when it cannot be fetched; the next call tries again
 */
export function loadRapier(): Promise<Rapier> {
  loading ??= needsPackage('@dimforge/rapier3d-compat', 'Physics needs', import('@dimforge/rapier3d-compat')).then(
    async (rapier) => {
      await rapier.init();
      // npm may have resolved the version of another dependency, such as 0.12 of @types/three
      if (!rapier.version().startsWith(RAPIER)) {
        throw new Error(
          `Physics needs @dimforge/rapier3d-compat ${RAPIER}x; ${rapier.version()} is loaded. Install it: npm install @dimforge/rapier3d-compat@${RAPIER}0`,
        );
      }
      return rapier;
    },
    (error: unknown) => {
      loading = null;
      throw error;
    },
  );
  return loading;
}
