import { loadRapier } from '@farol/engine/physics';

/** Gives Rapier to the player, which calls this global. */
(globalThis as { farolLoadRapier?: typeof loadRapier }).farolLoadRapier = loadRapier;
