import { shortText } from '@farol/editing';
import type { World } from '@dimforge/rapier3d-compat';
import { Quaternion, Vector3 } from 'three';
import type { GameObject } from '../core/GameObject';
import { Body, placeOf } from './Body';
import { isCharacter } from './findParts';
import type { Rapier } from './loadRapier';
import type { CharacterPart, RigidBodyPart } from './PhysicsParts';

/** Component that a body is made for; null for colliders without a RigidBody. */
export type BodyPart = RigidBodyPart | CharacterPart | null;

const place = new Vector3();
const turn = new Quaternion();

export const vectorOf = ([x, y, z]: readonly [number, number, number]): { x: number; y: number; z: number } => ({
  x,
  y,
  z,
});

/**
 * Makes a body at an object's pose, without applying the RigidBody fields that may change later.
 * @throws Error naming the object when its pose is not finite
 */
export function makeBody(rapier: Rapier, world: World, object: GameObject, component: BodyPart): Body {
  placeOf(object.object3D, place, turn);
  if (![...place, ...turn].every(Number.isFinite)) {
    throw new Error(
      `The RigidBody of '${shortText(object.name)}' has no valid position: its object, or one above it, has a scale of 0 or a value that is not finite. Set other values.`,
    );
  }
  const { RigidBodyDesc } = rapier;
  const type = component === null ? 'fixed' : isCharacter(component) ? 'character' : component.type;
  const makers = {
    dynamic: RigidBodyDesc.dynamic,
    kinematic: RigidBodyDesc.kinematicPositionBased,
    character: RigidBodyDesc.kinematicPositionBased,
    fixed: RigidBodyDesc.fixed,
  };
  const desc = makers[type]().setTranslation(place.x, place.y, place.z).setRotation(turn);
  if (component && !isCharacter(component) && type === 'dynamic') {
    desc.setLinvel(...component.initialVelocity).setAngvel(vectorOf(component.initialAngularVelocity));
  }
  return new Body(object, component, type, world.createRigidBody(desc));
}

/** Applies a RigidBody's fields to its body. */
export function applyFields({ RigidBodyType }: Rapier, body: Body, component: RigidBodyPart): void {
  const { rapier } = body;
  const { type } = component;
  if (type !== body.type) {
    const types = {
      dynamic: RigidBodyType.Dynamic,
      kinematic: RigidBodyType.KinematicPositionBased,
      fixed: RigidBodyType.Fixed,
    };
    body.type = type;
    body.objectMoved();
    rapier.setBodyType(types[type], true);
  }
  rapier.setGravityScale(component.gravityScale, true);
  rapier.setLinearDamping(component.linearDamping);
  rapier.setAngularDamping(component.angularDamping);
  rapier.enableCcd(component.continuous);
  rapier.setEnabledTranslations(!component.lockPositionX, !component.lockPositionY, !component.lockPositionZ, true);
  rapier.setEnabledRotations(!component.lockRotationX, !component.lockRotationY, !component.lockRotationZ, true);
}

/** Distributes a body's mass over its colliders by weight. */
export function weigh({ component, type, rapier, colliders }: Body): void {
  if (!component || isCharacter(component) || type !== 'dynamic') return;
  let weight = 0;
  for (const record of colliders) weight += record.weight;
  // a body without a shape falls too, and needs a mass
  const isBare = weight === 0;
  rapier.setAdditionalMass(isBare ? component.mass : 0, true);
  for (const record of colliders) {
    if (record.weight === 0) continue;
    record.rapier.setMass(component.massFrom === 'mass' ? (component.mass * record.weight) / weight : record.weight);
  }
  rapier.recomputeMassPropertiesFromColliders();
}
