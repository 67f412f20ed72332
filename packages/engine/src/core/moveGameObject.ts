import { shortText } from '@farol/editing';
import { Matrix4, type Object3D } from 'three';
import { maximumDepth } from '../base/maximumDepth';
import { checkSubtree } from './admission';
import type { GameObject } from './GameObject';
import type { GameObjectContainer } from './GameObjectContainer';

/** Options of `GameObject.reparent`. */
export interface MoveOptions {
  /** Whether to keep position, rotation and scale in the world. */
  keepWorld?: boolean;
}

/** Checks that an object is not moved below itself. @returns depth of the container in objects; 0 for a scene */
function checkNoCycle(gameObject: GameObject, container: GameObjectContainer): number {
  let above = container === container.scene ? null : (container as GameObject);
  let depth = 0;
  for (; above; above = above.parent) {
    if (above === gameObject) {
      throw new Error(
        `'${shortText(gameObject.name)}' cannot be put below itself: choose a parent that is not among its children.`,
      );
    }
    depth++;
  }
  return depth;
}

/** Checks that a scene does not exceed the maximum depth. Iterative, since a tree in no scene may be of any depth. */
function checkDepth(gameObject: GameObject, depth: number): void {
  let level: readonly GameObject[] = [gameObject];
  for (let deep = depth + 1; level.length > 0; deep++) {
    if (deep > maximumDepth) {
      throw new Error(
        `'${shortText(gameObject.name)}' cannot be put there: the scene would be more than ${maximumDepth} objects deep. Choose a parent nearer to the top.`,
      );
    }
    level = level.flatMap(({ childList }) => childList);
  }
}

/**
 * Does the same as three's `removeFromParent`, but searches children from the end, where objects being disposed of are.
 */
function removeFromParent(object: Object3D): void {
  const { parent } = object;
  if (!parent) return;
  parent.children.splice(parent.children.lastIndexOf(object), 1);
  object.parent = null;
  object.dispatchEvent({ type: 'removed' });
  parent.dispatchEvent({ type: 'childremoved', child: object });
}

function unlink(gameObject: GameObject): void {
  const siblings = gameObject.container?.childList;
  if (siblings) siblings.splice(siblings.lastIndexOf(gameObject), 1);
  gameObject.container = null;
  removeFromParent(gameObject.object3D);
}

function link(gameObject: GameObject, container: GameObjectContainer, index: number): void {
  container.childList.splice(Math.min(Math.max(index, 0), container.childList.length), 0, gameObject);
  gameObject.container = container;
  container.threeParent.add(gameObject.object3D);
}

/**
 * Moves a GameObject from its container to another one, or to none (null). Everything is checked before anything
 * changes.
 * @param index - place among the new siblings, after the removal from the old ones; at the end when absent
 */
export function moveGameObject(
  gameObject: GameObject,
  container: GameObjectContainer | null,
  index = Infinity,
  { keepWorld = false }: MoveOptions = {},
): void {
  const from = gameObject.sceneOf;
  const to = container?.scene ?? null;
  const depth = container ? checkNoCycle(gameObject, container) : 0;
  if (to) checkDepth(gameObject, depth);
  if (to && to !== from) checkSubtree(to, gameObject);

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
