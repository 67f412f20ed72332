import type { Object3D } from 'three';
import type { GameObject } from './GameObject';
import type { Scene } from './Scene';

/** What can hold GameObjects: another one, or a scene. */
export interface GameObjectContainer {
  /** @internal */
  readonly childList: GameObject[];
  /** The scene that it is, or is in. */
  readonly scene: Scene | null;
  /** @internal The three object below which its children's hang. */
  readonly threeParent: Object3D;
}
