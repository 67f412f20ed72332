import type { GameObject, Scene } from '../core/SceneGraph';
import type { ColliderPart, RigidBodyPart } from './PhysicsParts';

/** What of a scene takes part in its physics, in the order of its tree. */
export interface SceneParts {
  /** Objects that are bodies, each with its RigidBody; null for colliders without one. */
  readonly bodies: Map<GameObject, RigidBodyPart | null>;
  /** Colliders, each with the object whose body it belongs to. */
  readonly colliders: Map<ColliderPart, GameObject>;
}

export function findParts(scene: Scene): SceneParts {
  const parts: SceneParts = { bodies: new Map(), colliders: new Map() };
  for (const root of scene.roots) visit(root, null, parts);
  return parts;
}

function visit(object: GameObject, above: GameObject | null, parts: SceneParts): void {
  if (!object.active) return;
  let owner = above;
  for (const component of object.components) {
    if (!component.enabled || component.typeName !== 'RigidBody') continue;
    parts.bodies.set(object, component as RigidBodyPart);
    owner = object;
  }
  for (const component of object.components) {
    if (!component.enabled || component.typeName !== 'Collider') continue;
    if (!owner && !parts.bodies.has(object)) parts.bodies.set(object, null);
    parts.colliders.set(component as ColliderPart, owner ?? object);
  }
  for (const child of object.children) visit(child, owner, parts);
}
