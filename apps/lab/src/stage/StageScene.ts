import type { ParticleEmitter } from '@farol/renderer/particles';
import type { Camera, Light, PointLight, RectAreaLight, Scene, SpotLight } from 'three';
import type { LightKind, Shading } from '../plan/lightKinds';

/** A moving light with an object of its own. */
export type MovingLight = PointLight | SpotLight | RectAreaLight;

/** Scene of a case in plain three objects, one for each competitor. It is converted for other engines. */
export interface StageScene {
  readonly three: Scene;
  readonly camera: Camera;
  readonly kind: LightKind;
  readonly shading: Shading;
  /**
   * The moving lights: as many as in the case, and ten more while `addLights` is measured. Empty if they are a
   * LightField or particles.
   */
  readonly lights: readonly MovingLight[];
  /** Emitter of the particles that are the lights; null for other kinds. */
  readonly emitter: ParticleEmitter | null;
  /** Lights that do not move: ambient, hemisphere, directional, spot. */
  readonly still: readonly Light[];
  /** Size of the picture (pixels). */
  readonly width: number;
  readonly height: number;
  /** Moves the lights to their places at a time (s), in closed form; allocates nothing. */
  setTime(seconds: number): void;
  /** Adds `count` lights beside existing ones. @returns a function that removes them */
  addLights(count: number): () => void;
}
