import { Matrix4, type Object3D } from 'three';
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

export interface MoveOptions {
  /** Keep position, rotation and scale in the world. */
  keepWorld?: boolean;
}

function checkNoCycle(gameObject: GameObject, container: GameObjectContainer): void {
  let above = container === container.scene ? null : (container as GameObject);
  for (; above; above = above.parent) {
    if (above === gameObject) {
      throw new Error(
        `'${gameObject.name}' cannot be put below itself: choose a parent that is not among its children.`,
      );
    }
  }
}

function unlink(gameObject: GameObject): void {
  const siblings = gameObject.container?.childList;
  if (siblings) siblings.splice(siblings.indexOf(gameObject), 1);
  gameObject.container = null;
  gameObject.object3D.removeFromParent();
}

function link(gameObject: GameObject, container: GameObjectContainer, index: number): void {
  container.childList.splice(Math.min(Math.max(index, 0), container.childList.length), 0, gameObject);
  gameObject.container = container;
  container.threeParent.add(gameObject.object3D);
}

/**
 * Puts a GameObject into a container, out of the one where it is; null takes it out only. Everything is checked before
 * anything changes.
 * @param index - place among the new siblings once it has left the old ones; at the end when absent
 */
export function moveGameObject(
  gameObject: GameObject,
  container: GameObjectContainer | null,
  index = Infinity,
  { keepWorld = false }: MoveOptions = {},
): void {
  const from = gameObject.sceneOf;
  const to = container?.scene ?? null;
  if (container) checkNoCycle(gameObject, container);
  if (to && to !== from) to.checkSubtree(gameObject);

  let world: Matrix4 | null = null;
  if (keepWorld) {
    gameObject.transform.restoreAuthored();
    gameObject.object3D.updateWorldMatrix(true, false);
    world = gameObject.object3D.matrixWorld.clone();
  }
  if (from && from !== to) from.subtreeLeaves(gameObject);
  unlink(gameObject);
  if (container) link(gameObject, container, index);
  if (to && to !== from) to.subtreeEntered(gameObject);
  gameObject.refreshActive();
  if (world) gameObject.transform.modelMatrix = world;
  if (from && from !== to) from.notify({ kind: 'remove', gameObject });
  if (to) to.notify({ kind: from === to ? 'move' : 'add', gameObject });
}
