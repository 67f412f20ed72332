import type { Command, Pose } from '@farol/editing';
import type { Vector3Tuple } from '@farol/editing/fields';
import type { Object3D } from 'three';

/** A pose with the Euler angles of the page's `rotation` (rad) in the object's own order, since a rotation has many. */
export interface AngledPose extends Pose {
  readonly angles: Vector3Tuple;
}

/** Difference below which two angles are equal (rad). */
const SAME = 1e-9;

/** Command that sets position, rotation and scale of objects; result of a gizmo drag. */
export class SetPoses implements Command<Object3D> {
  /** Poses before the first `do`; null until then. */
  private before: readonly AngledPose[] | null = null;

  /** @param poses - pose of each object; unchanged parts are omitted */
  constructor(
    readonly label: string,
    private readonly objects: readonly Object3D[],
    private readonly poses: readonly Partial<AngledPose>[],
  ) {}

  get isEmpty(): boolean {
    const before = this.before ?? this.objects.map(poseOf);
    return this.poses.every(({ position, quaternion, scale }, i) => {
      const { position: place, quaternion: rotation, scale: size } = before[i];
      return (
        (!position || position.equals(place)) &&
        (!quaternion || quaternion.equals(rotation)) &&
        (!scale || scale.equals(size))
      );
    });
  }

  do(): void {
    this.before ??= this.objects.map(poseOf);
    this.objects.forEach((object, i) => apply(object, this.poses[i]));
  }

  undo(): void {
    this.objects.forEach((object, i) => apply(object, this.before![i]));
  }

  replaceWith(next: Command<Object3D>): SetPoses | null {
    if (!(next instanceof SetPoses) || next.objects !== this.objects) return null;
    next.before = this.before;
    // this command is undone first, since it may have set parts of poses that `next` does not set
    this.undo();
    next.do();
    return next;
  }
}

/** Pose of an object relative to its parent; from its matrix when `matrixAutoUpdate` is false. */
export function poseOf({ position, quaternion, rotation, scale, matrix, matrixAutoUpdate }: Object3D): AngledPose {
  const pose = { position: position.clone(), quaternion: quaternion.clone(), scale: scale.clone() };
  if (!matrixAutoUpdate) matrix.decompose(pose.position, pose.quaternion, pose.scale);
  const { x, y, z } = matrixAutoUpdate ? rotation : rotation.clone().setFromQuaternion(pose.quaternion);
  return { ...pose, angles: [x, y, z] };
}

function apply(object: Object3D, { position, quaternion, angles, scale }: Partial<AngledPose>): void {
  if (position) object.position.copy(position);
  if (quaternion) object.quaternion.copy(quaternion);
  const { rotation } = object;
  // restores the page's angles: three has computed equivalent ones from the quaternion
  if (angles && [rotation.x, rotation.y, rotation.z].some((angle, i) => Math.abs(angle - angles[i]) > SAME)) {
    rotation.set(...(angles as [number, number, number]));
  }
  if (scale) object.scale.copy(scale);
  if (!object.matrixAutoUpdate) object.updateMatrix();
}
