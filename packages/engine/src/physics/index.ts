import { loadRapier as load } from './loadRapier';

/** What editors and players need of the physics beside `PhysicsSystem` and the components: shapes to draw, and Rapier itself. */
export { type ColliderShape, colliderShape } from './colliderShape';

/**
 * Rapier's module, initialised. Its declarations stay its own: a host need not compile them.
 * @throws Error (as a rejection) when it cannot be fetched
 */
export const loadRapier: () => Promise<object> = load;
