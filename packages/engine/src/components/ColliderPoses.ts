import { type Matrix4, type Object3D, Vector3 } from 'three';

/** Pose of a collider that particles bounce off, in world space. */
export interface ColliderPose {
  /** World position of the collider (m). */
  readonly position: readonly [number, number, number];
  /** World direction of the collider's +Y, unit length. */
  readonly up: readonly [number, number, number];
  /** Greatest scale factor of the object's axes, above 0. */
  readonly scale: number;
}

const LEAST_SCALE = 1e-6;
const axis = new Vector3();

/** World poses of some objects, recomputed only when an object has moved. */
export class ColliderPoses {
  poses: readonly ColliderPose[] = [];
  private readonly matrices: Matrix4[] = [];
  private count = 0;

  /**
   * Updates the poses from the objects' world matrices, which it brings up to date.
   * @returns whether an object was moved, added or removed
   */
  follow(objects: readonly (Object3D | null)[]): boolean {
    let changed = false;
    let count = 0;
    for (let i = 0; i < objects.length; i++) {
      const object = objects[i];
      if (object === null) continue;
      object.updateWorldMatrix(true, false);
      if (count >= this.matrices.length) this.matrices.push(object.matrixWorld.clone());
      else if (count < this.count && this.matrices[count].equals(object.matrixWorld)) {
        count++;
        continue;
      } else this.matrices[count].copy(object.matrixWorld);
      changed = true;
      count++;
    }
    changed ||= count !== this.count;
    this.count = count;
    if (changed) this.poses = this.matrices.slice(0, count).map(poseOf);
    return changed;
  }
}

function poseOf(matrix: Matrix4): ColliderPose {
  const e = matrix.elements;
  axis.setFromMatrixColumn(matrix, 1);
  if (axis.lengthSq() === 0) axis.set(0, 1, 0);
  axis.normalize();
  return {
    position: [e[12], e[13], e[14]],
    up: [axis.x, axis.y, axis.z],
    scale: Math.max(LEAST_SCALE, matrix.getMaxScaleOnAxis()),
  };
}
