/** What editors and players need of the physics beside `PhysicsSystem` and the components: shapes to draw, and Rapier itself. */
export { type ColliderShape, colliderShape } from './colliderShape';
export { loadRapier, type Rapier } from './loadRapier';
