import type { Object3D } from 'three';
import type { GameObject } from './GameObject';
import type { Scene } from './Scene';

/** Parent of GameObjects: a GameObject or a scene. */
export interface GameObjectContainer {
  /** @internal */
  readonly childList: GameObject[];
  /** The scene that it is, or is in. */
  readonly scene: Scene | null;
  /** @internal The three object below which its children's hang. */
  readonly threeParent: Object3D;
}
