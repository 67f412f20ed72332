import type { Command, Pose } from '@farol/editing';
import type { Object3D } from 'three';

/** Puts objects to places: what a drag of the gizmo does. */
export class SetPoses implements Command<Object3D> {
  /** Poses before the first `do`; null until then. */
  private before: readonly Pose[] | null = null;

  /** @param poses of the objects, in their order; what does not change is left out */
  constructor(
    readonly label: string,
    private readonly objects: readonly Object3D[],
    private readonly poses: readonly Partial<Pose>[],
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
    // what this one changes and the next one does not, such as a place, goes back
    this.undo();
    next.do();
    return next;
  }
}

/** Where an object is in its parent: by its matrix, where the page sets that one by hand. */
export function poseOf({ position, quaternion, scale, matrix, matrixAutoUpdate }: Object3D): Pose {
  const pose = { position: position.clone(), quaternion: quaternion.clone(), scale: scale.clone() };
  if (!matrixAutoUpdate) matrix.decompose(pose.position, pose.quaternion, pose.scale);
  return pose;
}

function apply(object: Object3D, { position, quaternion, scale }: Partial<Pose>): void {
  if (position) object.position.copy(position);
  if (quaternion) object.quaternion.copy(quaternion);
  if (scale) object.scale.copy(scale);
  if (!object.matrixAutoUpdate) object.updateMatrix();
}
