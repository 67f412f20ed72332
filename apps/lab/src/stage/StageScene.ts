import type { ParticleEmitter } from '@farol/renderer/particles';
import type { Camera, Light, PointLight, RectAreaLight, Scene, SpotLight } from 'three';
import type { LightKind, Shading } from '../plan/lightKinds';

/** A light that moves and is an object of its own. */
export type MovingLight = PointLight | SpotLight | RectAreaLight;

/** A case's scene as plain three objects: what every competitor gets. Rivals convert it. */
export interface StageScene {
  readonly three: Scene;
  readonly camera: Camera;
  /** What the moving lights are. */
  readonly kind: LightKind;
  readonly shading: Shading;
  /**
   * The moving lights, as many as the case asks for; ten more while `addLights` is measured. None where they are a
   * LightField's or particles.
   */
  readonly lights: readonly MovingLight[];
  /** Whose particles are the lights; null for other kinds. */
  readonly emitter: ParticleEmitter | null;
  /** Lights that stand still: ambient, hemisphere, directional, spot. */
  readonly still: readonly Light[];
  /** Size of the picture (pixels). */
  readonly width: number;
  readonly height: number;
  /** Moves the lights to where they are at a time (s): closed form, without allocation. */
  setTime(seconds: number): void;
  /** Adds `count` lights beside those that are there. @returns what takes them away again */
  addLights(count: number): () => void;
}
