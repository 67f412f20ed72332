import { describe, expect, it } from 'vitest';
import { makeReach } from './reach';
import { cubeFacesOf } from './cubeFacesOf';

function random(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

/** The faces whose pyramid holds a direction. */
function facesOf(direction: readonly number[], widening: number): number {
  let faces = 0;
  for (let i = 0; i < 6; i++) {
    const along = direction[i >> 1] * (i % 2 === 0 ? 1 : -1);
    const others = direction.filter((_, axis) => axis !== i >> 1);
    if (along > 0 && others.every((value) => Math.abs(value) <= along * widening)) faces |= 1 << i;
  }
  return faces;
}

describe('cubeFacesOf', () => {
  it('has each face that sees a point of the box within range', () => {
    const next = random(11);
    let within = 0;
    for (let run = 0; run < 400; run++) {
      const box = Float64Array.from({ length: 6 }, (_, i) => (i < 3 ? next() * 8 - 4 : next() * 2));
      const widening = 1 + next() * 0.1;
      const [x, y, z] = [next() - 0.5, next() - 0.5, next() - 0.5];
      const range = 1 + next() * 5;
      const wider = next() * 0.2;
      const seen = cubeFacesOf(box, 0, makeReach(x, y, z, range, widening, wider));
      for (let point = 0; point < 20; point++) {
        // the corners first, since they are the extremes
        const place = (axis: number) => (point < 8 ? ((point >> axis) & 1) * 2 - 1 : next() * 2 - 1);
        const direction = [x, y, z].map((from, axis) => box[axis] + place(axis) * (box[3 + axis] + wider) - from);
        if (Math.hypot(...direction) > range) continue;
        within++;
        expect(facesOf(direction, widening) & ~seen).toBe(0);
      }
    }
    expect(within).toBeGreaterThan(2000);
  });

  it('leaves out the faces that a box is far from', () => {
    const box = new Float64Array([5, 0, 0, 1, 1, 1]);
    expect(cubeFacesOf(box, 0, makeReach(0, 0, 0))).toBe(1);
    expect(cubeFacesOf(box, 0, makeReach(10, 0, 0))).toBe(2);
    expect(cubeFacesOf(new Float64Array([0, 0, -7, 2, 2, 2]), 0, makeReach(0, 0, 0))).toBe(32);
    expect(cubeFacesOf(new Float64Array([3, 3, 0, 1, 1, 1]), 0, makeReach(0, 0, 0))).toBe(1 | 4);
    expect(cubeFacesOf(new Float64Array([0, 0, 0, 1, 1, 1]), 0, makeReach(0, 0, 0))).toBe(63);
    expect(cubeFacesOf(box, 0, makeReach(0, 0, 0, 3.9))).toBe(0);
    expect(cubeFacesOf(box, 0, makeReach(0, 0, 0, 3.9, 1, 0.2))).toBe(1);
    expect(cubeFacesOf(new Float64Array([3, 3, 0, 1, 1, 1]), 0, makeReach(0, 0, 0, 2.8))).toBe(0);
  });
});
