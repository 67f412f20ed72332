import { loadRapier } from '@farol/engine/physics';

/** Global function that the player calls to load Rapier. */
(globalThis as { farolLoadRapier?: typeof loadRapier }).farolLoadRapier = loadRapier;
