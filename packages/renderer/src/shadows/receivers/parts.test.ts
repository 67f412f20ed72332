import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { makeReach } from '../slots/reach';
import { aimCubeFace, makeCubeFaces } from '../slots/ShadowFace';
import { cubeFaceParts } from './cubeFaceParts';
import { mapPart } from './mapPart';

function random(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

function randomBox(next: () => number): Float64Array {
  return Float64Array.from({ length: 6 }, (_, i) => (i < 3 ? next() * 8 - 4 : next() * 2));
}

function pointIn(box: Float64Array, next: () => number): Vector3 {
  const [x, y, z] = [0, 1, 2].map((axis) => box[axis] + (next() * 2 - 1) * box[3 + axis]);
  return new Vector3(x, y, z);
}

function noParts(): Float64Array {
  return new Float64Array(24).fill(-Infinity);
}

describe('cubeFaceParts', () => {
  it('holds every point of the box within the range, where the faces that draw see it', () => {
    const next = random(5);
    const faces = makeCubeFaces();
    const position = new Vector3(0.3, -0.2, 0.5);
    const widening = 1.05;
    faces.forEach((face, i) => aimCubeFace(face, i, position, 0.1, 10, widening));
    let seen = 0;
    for (let run = 0; run < 300; run++) {
      const box = randomBox(next);
      const parts = noParts();
      cubeFaceParts(parts, box, 0, makeReach(position.x, position.y, position.z, 4, widening));
      for (let k = 0; k < 20; k++) {
        const point = pointIn(box, next);
        if (point.distanceTo(position) > 4) continue;
        faces.forEach(({ camera }, i) => {
          const clip = point.clone().applyMatrix4(camera.matrixWorldInverse);
          const [across, up] = [clip.x / -clip.z, clip.y / -clip.z];
          if (clip.z >= 0 || Math.max(Math.abs(across), Math.abs(up)) > widening) return;
          seen++;
          expect(across).toBeGreaterThanOrEqual(-parts[i * 4] - 1e-9);
          expect(across).toBeLessThanOrEqual(parts[i * 4 + 1] + 1e-9);
          expect(up).toBeGreaterThanOrEqual(-parts[i * 4 + 2] - 1e-9);
          expect(up).toBeLessThanOrEqual(parts[i * 4 + 3] + 1e-9);
        });
      }
    }
    expect(seen).toBeGreaterThan(1000);
  });

  it('is tight: a floor below fills half of the faces at its sides, a small box little of one', () => {
    const floor = noParts();
    cubeFaceParts(floor, new Float64Array([0, -1, 0, 50, 0, 50]), 0, makeReach(0, 0, 0, 4));
    expect([...floor.subarray(0, 3)]).toEqual([Infinity, Infinity, Infinity]);
    expect(floor[3]).toBeCloseTo(-0.25, 9);
    expect([...floor.subarray(8, 12)]).toEqual([...noParts().subarray(8, 12)]);
    expect([...floor.subarray(12, 16)]).toEqual([Infinity, Infinity, Infinity, Infinity]);
    const small = noParts();
    cubeFaceParts(small, new Float64Array([3, 0, 0, 1, 0.25, 0.25]), 0, makeReach(0, 0, 0, 10, 1, 0.25));
    for (let side = 0; side < 4; side++) expect(small[side]).toBeCloseTo(0.5 / 1.75, 9);
    expect([...small.subarray(4)]).toEqual([...noParts().subarray(4)]);
  });
});

describe('cubeFaceParts without writing', () => {
  it('says what writing would do, and leaves the parts as they are', () => {
    const next = random(3);
    const counts = [0, 0, 0];
    for (let run = 0; run < 2000; run++) {
      const reach = makeReach(next() - 0.5, next() - 0.5, next() - 0.5, 2 + next() * 4, 1 + next() * 0.2, next() * 0.1);
      const parts = noParts();
      const held = randomBox(next);
      cubeFaceParts(parts, held, 0, reach);
      const box =
        run % 2 === 0 ? randomBox(next) : held.map((value, i) => (i < 3 ? value : value * (1 + next() * 0.04)));
      const before = parts.slice();
      const widens = cubeFaceParts(parts, box, 0, reach, 63, false);
      expect(parts).toEqual(before);
      expect(cubeFaceParts(parts, box, 0, reach)).toBe(Math.min(widens, 1));
      const most = Math.max(...parts.map((part, i) => (part === before[i] ? 0 : Math.min(part, reach[4]) - before[i])));
      expect(widens).toBe(most === 0 ? 0 : most <= 0.06 + 1e-9 ? 1 : 2);
      counts[widens]++;
      expect(cubeFaceParts(parts, box, 0, reach, 63, false)).toBe(0);
    }
    expect(Math.min(...counts)).toBeGreaterThan(10);
  });
});

describe('mapPart', () => {
  it.each([new PerspectiveCamera(50, 1, 0.1, 20), new OrthographicCamera(-3, 3, 3, -3, 0.1, 20)])(
    'holds every point of the box: $type',
    (camera) => {
      const next = random(9);
      camera.position.set(1, 3, 9);
      camera.lookAt(0, 0, 0);
      camera.updateMatrixWorld();
      const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
      for (let run = 0; run < 100; run++) {
        const box = randomBox(next);
        const part = new Float64Array([Infinity, -Infinity, Infinity, -Infinity]);
        const shrunk = box.map((value, i) => (i < 3 ? value : value - 0.1));
        mapPart(part, 0, shrunk, 0, makeReach(0, 0, 0, Infinity, 1, 0.1), matrix);
        for (let k = 0; k < 10; k++) {
          const { x, y } = pointIn(box, next).applyMatrix4(matrix);
          expect(x).toBeGreaterThanOrEqual(part[0] - 1e-9);
          expect(x).toBeLessThanOrEqual(part[1] + 1e-9);
          expect(y).toBeGreaterThanOrEqual(part[2] - 1e-9);
          expect(y).toBeLessThanOrEqual(part[3] + 1e-9);
        }
      }
    },
  );

  it('is all for what reaches behind the camera', () => {
    const camera = new PerspectiveCamera(50, 1, 0.1, 20);
    const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const part = new Float64Array([Infinity, -Infinity, Infinity, -Infinity]);
    mapPart(part, 0, new Float64Array([0, 0, -1, 1, 1, 2]), 0, makeReach(), matrix);
    expect([...part]).toEqual([-Infinity, Infinity, -Infinity, Infinity]);
  });
});
