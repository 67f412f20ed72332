import type { Camera, Light, PointLight, Scene } from 'three';

/** A case's scene as plain three objects: what every competitor gets. Rivals convert it. */
export interface StageScene {
  readonly three: Scene;
  readonly camera: Camera;
  /** The moving point lights, as many as the case asks for; ten more while `addLights` is measured. */
  readonly lights: readonly PointLight[];
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
