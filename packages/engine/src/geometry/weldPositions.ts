import type { BufferAttribute, InterleavedBufferAttribute } from 'three';
import { inSteps, type Steps } from '../base/steps';

/** Index of each vertex's position among the distinct positions, 0 to `count` - 1. */
export interface Places {
  readonly places: Uint32Array;
  readonly count: number;
}

/** Gives vertices at equal positions equal numbers. Positions are equal within a millionth of the geometry's extent. */
export function* weldPositions(position: BufferAttribute | InterleavedBufferAttribute): Steps<Places> {
  let extent = 0;
  yield* inSteps(position.count, (from, to) => {
    for (let i = from; i < to; i++) {
      extent = Math.max(extent, Math.abs(position.getX(i)), Math.abs(position.getY(i)), Math.abs(position.getZ(i)));
    }
  });
  const steps = extent > 0 ? 1e6 / extent : 1;
  const places = new Uint32Array(position.count);
  const cells = new Int32Array(position.count * 3);
  const size = 1 << Math.ceil(Math.log2(Math.max(2, position.count * 2)));
  const table = new Int32Array(size).fill(-1);
  let count = 0;
  yield* inSteps(position.count, (from, to) => {
    for (let i = from; i < to; i++) {
      const x = Math.round(position.getX(i) * steps);
      const y = Math.round(position.getY(i) * steps);
      const z = Math.round(position.getZ(i) * steps);
      const hash = Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791);
      let slot = (hash ^ (hash >>> 15)) & (size - 1);
      for (;;) {
        const place = table[slot];
        if (place < 0) {
          cells.set([x, y, z], count * 3);
          table[slot] = count;
          places[i] = count++;
          break;
        }
        if (cells[place * 3] === x && cells[place * 3 + 1] === y && cells[place * 3 + 2] === z) {
          places[i] = place;
          break;
        }
        slot = (slot + 1) & (size - 1);
      }
    }
  });
  return { places, count };
}
