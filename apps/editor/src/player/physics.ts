import { loadRapier } from '@farol/engine/physics';

/** The global that the player calls to get Rapier. */
(globalThis as { farolLoadRapier?: typeof loadRapier }).farolLoadRapier = loadRapier;
