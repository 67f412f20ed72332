import { loadRapier as load } from './loadRapier';

/**
 * Entry for editors and players: collider shapes to draw, and Rapier itself, besides `PhysicsSystem` and the
 * components.
 */
export { type ColliderShape, colliderShape } from './colliderShape';

/**
 * Fetches Rapier's module, initialised; typed as object, so that hosts need not compile Rapier's declarations.
 * @throws Error (as a rejection) when it cannot be fetched
 */
export const loadRapier: () => Promise<object> = load;
