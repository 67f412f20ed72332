import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import { Pose } from './Pose';

/** An object that follows the one that is dragged: where it was in the world, and its parent's world the other way round. */
interface Follower {
  readonly object: Object3D;
  readonly world: Matrix4;
  readonly toParent: Matrix4;
  readonly scale: Vector3;
}

const delta = new Matrix4();
const position = new Vector3();
const quaternion = new Quaternion();
const scale = new Vector3();

/** A drag of one object by the gizmo, which others follow: moved and turned with it in the world, scaled each in its place. */
export class Drag {
  private readonly before: readonly Pose[];
  private readonly followers: readonly Follower[];
  private readonly startInverse: Matrix4;
  private readonly startScale: Vector3;

  /** @param others that follow; none is below another one, or above or below the one that leads */
  constructor(
    private readonly leader: Object3D,
    others: readonly Object3D[],
  ) {
    this.before = [leader, ...others].map((object) => new Pose(object));
    leader.updateWorldMatrix(true, false);
    this.startInverse = leader.matrixWorld.clone().invert();
    this.startScale = leader.scale.clone();
    this.followers = others.map((object) => {
      object.updateWorldMatrix(true, false);
      const toParent = object.parent ? object.parent.matrixWorld.clone().invert() : new Matrix4();
      return { object, world: object.matrixWorld.clone(), toParent, scale: object.scale.clone() };
    });
  }

  /** Has the others follow to where the leader is now. @param isScale - whether the gizmo scales */
  follow(isScale: boolean): void {
    const { leader, startInverse, startScale } = this;
    if (!leader.matrixAutoUpdate) leader.updateMatrix();
    leader.updateWorldMatrix(false, false);
    for (const { object, world, toParent, scale: own } of this.followers) {
      if (isScale) object.scale.copy(own).multiply(scale.copy(leader.scale).divide(startScale));
      else {
        delta.multiplyMatrices(leader.matrixWorld, startInverse).multiply(world).premultiply(toParent);
        delta.decompose(position, quaternion, scale);
        object.position.copy(position);
        object.quaternion.copy(quaternion);
      }
      if (!object.matrixAutoUpdate) object.updateMatrix();
    }
  }

  /** Puts everything back. */
  undo(): void {
    for (const pose of this.before) pose.apply();
  }

  /** @returns what does the drag again; null when nothing is elsewhere */
  finish(): (() => void) | null {
    const after = this.before.map(({ object }) => new Pose(object));
    if (after.every((pose, i) => pose.equals(this.before[i]))) return null;
    return () => {
      for (const pose of after) pose.apply();
    };
  }
}
