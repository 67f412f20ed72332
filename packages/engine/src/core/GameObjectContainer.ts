import type { Object3D } from 'three';
import type { GameObject } from './GameObject';
import type { Scene } from './Scene';

/** Parent of GameObjects: a GameObject or a scene. */
export interface GameObjectContainer {
  /** @internal */
  readonly childList: GameObject[];
  /** The scene itself, or the scene that contains the object. */
  readonly scene: Scene | null;
  /** @internal Parent of the children's three objects. */
  readonly threeParent: Object3D;
}
