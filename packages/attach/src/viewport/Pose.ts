import { type Object3D, Quaternion, Vector3 } from 'three';

/** Place, turn and size of an object. */
export class Pose {
  readonly position = new Vector3();
  readonly quaternion = new Quaternion();
  readonly scale = new Vector3();

  constructor(readonly object: Object3D) {
    this.position.copy(object.position);
    this.quaternion.copy(object.quaternion);
    this.scale.copy(object.scale);
  }

  apply(): void {
    const { object } = this;
    object.position.copy(this.position);
    object.quaternion.copy(this.quaternion);
    object.scale.copy(this.scale);
    if (!object.matrixAutoUpdate) object.updateMatrix();
  }

  equals({ position, quaternion, scale }: Pose): boolean {
    return this.position.equals(position) && this.quaternion.equals(quaternion) && this.scale.equals(scale);
  }
}
