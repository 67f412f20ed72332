import type { Object3D } from 'three';

/** Floats stored per object: position 3, quaternion 4, scale 3. */
const SIZE = 10;

/** Detects that an object or an ancestor was moved. */
export class ObjectWatch {
  private readonly chain: Object3D[] = [];
  private readonly seen: Float64Array;

  /** @param end - ancestor at which watching ends, exclusive; null for the root */
  constructor(object: Object3D, end: Object3D | null = null) {
    for (let each: Object3D | null = object; each && each !== end; each = each.parent) this.chain.push(each);
    this.seen = new Float64Array(this.chain.length * SIZE).fill(NaN);
    this.moved();
  }

  /** Whether any watched object has moved since the last call. */
  moved(): boolean {
    const { chain, seen } = this;
    let moved = false;
    for (let i = 0, k = 0; i < chain.length; i++, k += SIZE) {
      const { position, quaternion, scale } = chain[i];
      if (
        seen[k] === position.x &&
        seen[k + 1] === position.y &&
        seen[k + 2] === position.z &&
        seen[k + 3] === quaternion.x &&
        seen[k + 4] === quaternion.y &&
        seen[k + 5] === quaternion.z &&
        seen[k + 6] === quaternion.w &&
        seen[k + 7] === scale.x &&
        seen[k + 8] === scale.y &&
        seen[k + 9] === scale.z
      ) {
        continue;
      }
      moved = true;
      position.toArray(seen, k);
      quaternion.toArray(seen, k + 3);
      scale.toArray(seen, k + 7);
    }
    return moved;
  }
}
