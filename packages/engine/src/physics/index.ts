import { loadRapier as load } from './loadRapier';

/**
 * Entry for editors and players: collider shapes to draw, and Rapier itself, beside `PhysicsSystem` and the components.
 */
export { type ColliderShape, colliderShape } from './colliderShape';

/**
 * Rapier's module, initialised. Its declarations stay its own: a host need not compile them.
 * @throws Error (as a rejection) when it cannot be fetched
 */
export const loadRapier: () => Promise<object> = load;
