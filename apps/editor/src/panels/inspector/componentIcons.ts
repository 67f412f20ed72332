import type { IconName } from '../../style/iconPaths';

const icons: Readonly<Record<string, IconName>> = {
  Transform: 'transform',
  ObjectRenderer: 'mesh',
  ModelRenderer: 'mesh',
  Animation: 'animation',
  Animator: 'play',
  Light: 'point',
  Camera: 'camera',
  Decal: 'decal',
  Wall: 'wall',
  Room: 'room',
  ParticleEmitter: 'particles',
  KeyController: 'keyboard',
  MouseController: 'mouse',
  RandomMovement: 'motion',
  RigidBody: 'body',
  Collider: 'collider',
  CharacterController: 'character',
  Joint: 'joint',
  AudioSource: 'sound',
  AudioListener: 'listener',
  EventTrigger: 'trigger',
};

/** Icon of a component type. */
export const componentIcon = (typeName: string): IconName => icons[typeName] ?? 'object';

export { componentName as wordsOf } from '../../model/componentName';
