import type { FieldEdit } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { Vector3 } from 'three';

const place = new Vector3();

/** Edits that move objects by world vectors (m). @param objects - none of them a descendant of another */
export function moveInWorld(objects: readonly GameObject[], ways: readonly Vector3[]): FieldEdit[] {
  return objects.flatMap(({ transform, object3D: { parent } }, i): FieldEdit[] => {
    if (ways[i].lengthSq() < 1e-14) return [];
    const before = transform.getAuthored('position') as Vector3Tuple;
    place.fromArray(before);
    if (parent) {
      parent.updateWorldMatrix(true, false);
      place.applyMatrix4(parent.matrixWorld).add(ways[i]);
      parent.worldToLocal(place);
    } else place.add(ways[i]);
    // unchanged coordinates keep their digits, changed ones are rounded
    const value = place.toArray().map((each, axis) => {
      return Math.abs(each - before[axis]) < 1e-9 ? before[axis] : Number(each.toFixed(5)) + 0;
    });
    return [{ owner: transform, name: 'position', value: value as unknown as Vector3Tuple }];
  });
}
