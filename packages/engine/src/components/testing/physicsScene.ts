import type { FieldValue, Vector3Tuple } from '@farol/editing/fields';
import type { Vector3 } from 'three';
import { Collider } from '../Collider';
import { builtinComponents } from '../index';
import { ObjectRenderer } from '../ObjectRenderer';
import { RigidBody } from '../RigidBody';
import { GameObject } from '../../core/GameObject';
import { Scene } from '../../core/Scene';
import { PhysicsSystem } from '../../physics/PhysicsSystem';

export type Values = Readonly<Record<string, FieldValue>>;

/** A scene that throws errors of components. */
export function makeScene(): Scene {
  const scene = new Scene({ registry: builtinComponents });
  scene.onComponentError = (_, error) => {
    throw error;
  };
  return scene;
}

/** A box with a Collider, and with a RigidBody unless `body` is null. */
export function box(name: string, position: Vector3Tuple, body: Values | null = {}, collider: Values = {}): GameObject {
  const object = new GameObject(name, { id: name });
  object.transform.position = position;
  object.addComponent(ObjectRenderer, { mesh: 'box' });
  if (body) object.addComponent(RigidBody, body);
  object.addComponent(Collider, collider);
  return object;
}

/** Ground of 50 m × 50 m with its top at height 0. */
export function ground(): GameObject {
  const object = box('Ground', [0, -0.5, 0], null);
  object.transform.scale = [50, 1, 50];
  return object;
}

export const prepare = (scene: Scene): Promise<void> => scene.system(PhysicsSystem).prepare();

/** Advances a scene by frames of 1/60 s. */
export function run(scene: Scene, steps: number): void {
  for (let i = 0; i < steps; i++) scene.update(1 / 60);
}

/** Positions, rotations and scales of all objects as one list of numbers. */
export function placesOf(scene: Scene): number[] {
  const places: number[] = [];
  scene.traverse(({ object3D: { position, quaternion, scale } }) =>
    places.push(...position, ...quaternion.toArray(), ...scale),
  );
  return places;
}

export const worldOf = (object: GameObject): Vector3 => object.transform.worldPosition;
