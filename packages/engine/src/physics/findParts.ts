import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import type { CharacterPart, ColliderPart, JointPart, RigidBodyPart } from './PhysicsParts';

/** Components and objects of a scene that take part in physics, in tree order. */
export interface SceneParts {
  /** Objects that are bodies, each with its RigidBody or CharacterController; null for colliders without one. */
  readonly bodies: Map<GameObject, RigidBodyPart | CharacterPart | null>;
  /** Colliders, each with the object whose body it belongs to. */
  readonly colliders: Map<ColliderPart, GameObject>;
  /** Joints, each with the object of its body; null without one. */
  readonly joints: Map<JointPart, GameObject | null>;
  /** RigidBodies that are ignored, since their objects have a CharacterController. */
  readonly doubled: RigidBodyPart[];
}

export function findParts(scene: Scene): SceneParts {
  const parts: SceneParts = { bodies: new Map(), colliders: new Map(), joints: new Map(), doubled: [] };
  for (const root of scene.roots) visit(root, null, parts);
  return parts;
}

function visit(object: GameObject, above: GameObject | null, parts: SceneParts): void {
  if (!object.active) return;
  let owner = above;
  const character = partOf<CharacterPart>(object, 'CharacterController');
  const rigid = partOf<RigidBodyPart>(object, 'RigidBody');
  if (character && rigid) parts.doubled.push(rigid);
  if (character || rigid) {
    parts.bodies.set(object, character ?? rigid);
    owner = object;
  }
  for (const component of object.components) {
    if (!component.enabled) continue;
    if (component.typeName === 'Joint') parts.joints.set(component as JointPart, owner);
    if (component.typeName !== 'Collider') continue;
    if (!owner && !parts.bodies.has(object)) parts.bodies.set(object, null);
    parts.colliders.set(component as ColliderPart, owner ?? object);
  }
  for (const child of object.children) visit(child, owner, parts);
}

function partOf<T extends Component>(object: GameObject, typeName: string): T | null {
  const component = object.components.find((each) => each.enabled && each.typeName === typeName);
  return (component as T | undefined) ?? null;
}

/** Whether a body is that of a CharacterController. */
export const isCharacter = (component: Component): component is CharacterPart =>
  component.typeName === 'CharacterController';
