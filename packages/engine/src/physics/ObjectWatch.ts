import type { Object3D } from 'three';

/** Floats stored per object: position 3, quaternion 4, scale 3. */
const SIZE = 10;

/** Detects that an object or an ancestor was moved. */
export class ObjectWatch {
  private readonly chain: Object3D[] = [];
  private readonly poses: Float64Array;

  /** @param end - ancestor at which watching ends, exclusive; null for the root */
  constructor(object: Object3D, end: Object3D | null = null) {
    for (let each: Object3D | null = object; each && each !== end; each = each.parent) this.chain.push(each);
    this.poses = new Float64Array(this.chain.length * SIZE).fill(NaN);
    this.moved();
  }

  /** Whether any watched object has moved since the last call. */
  moved(): boolean {
    const { chain, poses } = this;
    let moved = false;
    for (let i = 0, k = 0; i < chain.length; i++, k += SIZE) {
      const { position, quaternion, scale } = chain[i];
      if (
        poses[k] === position.x &&
        poses[k + 1] === position.y &&
        poses[k + 2] === position.z &&
        poses[k + 3] === quaternion.x &&
        poses[k + 4] === quaternion.y &&
        poses[k + 5] === quaternion.z &&
        poses[k + 6] === quaternion.w &&
        poses[k + 7] === scale.x &&
        poses[k + 8] === scale.y &&
        poses[k + 9] === scale.z
      ) {
        continue;
      }
      moved = true;
      position.toArray(poses, k);
      quaternion.toArray(poses, k + 3);
      scale.toArray(poses, k + 7);
    }
    return moved;
  }
}
