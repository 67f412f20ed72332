import { builtinComponents as registry } from '../core/builtinComponents';
import { Transform } from '../core/Transform';
import { Animation } from './Animation';
import { Animator } from './Animator';
import { AudioListener } from './AudioListener';
import { AudioSource } from './AudioSource';
import { Camera } from './Camera';
import { CharacterController } from './CharacterController';
import { Collider } from './Collider';
import { Decal } from './Decal';
import { FogVolume } from './FogVolume';
import { Grabbable } from './Grabbable';
import { Joint } from './Joint';
import { EventTrigger } from './EventTrigger';
import { KeyController } from './KeyController';
import { Light } from './Light';
import { LightGroup } from './LightGroup';
import { ModelRenderer } from './ModelRenderer';
import { MouseController } from './MouseController';
import { ObjectRenderer } from './ObjectRenderer';
import { ParticleEmitter } from './ParticleEmitter';
import { RandomMovement } from './RandomMovement';
import { SunAndMoon } from './SunAndMoon';
import { RigidBody } from './RigidBody';
import { Room } from './Room';
import { Wall } from './Wall';
import { XRRig } from './XRRig';

/** The built-in components, in the order of the Add menu. */
const components = [
  Transform,
  ObjectRenderer,
  ModelRenderer,
  Animation,
  Animator,
  Light,
  SunAndMoon,
  LightGroup,
  Camera,
  Decal,
  FogVolume,
  Wall,
  Room,
  ParticleEmitter,
  KeyController,
  MouseController,
  RandomMovement,
  RigidBody,
  Collider,
  Joint,
  CharacterController,
  AudioSource,
  AudioListener,
  EventTrigger,
  XRRig,
  Grabbable,
];

for (const each of components) registry.register(each);

/**
 * The built-in types of components. Importing this name runs the registrations above, even where a bundler drops the
 * package's index as free of side effects.
 */
export const builtinComponents = registry;
