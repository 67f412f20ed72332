import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { dragonMesh } from './dragonMesh';

const dragon = dragonMesh();

test('the dragon made in code is as large and as fine as the Stanford dragon, and faces out', () => {
  const { index, attributes, boundingBox } = dragon;
  const { position, normal } = attributes;
  const triangles = index!.count / 3;
  expect(triangles).toBeGreaterThan(40_000);
  expect(triangles).toBeLessThan(55_000);
  expect(boundingBox!.min.y).toBeCloseTo(0, 6);
  expect(boundingBox!.getSize(new Vector3()).x).toBeCloseTo(1, 6);
  const [a, b, c, n] = Array.from({ length: 4 }, () => new Vector3());
  let volume = 0;
  let outward = 0;
  let bad = 0;
  for (let i = 0; i < index!.count; i += 3) {
    [a, b, c].forEach((corner, k) => corner.fromBufferAttribute(position, index!.getX(i + k)));
    n.fromBufferAttribute(normal, index!.getX(i));
    volume += a.dot(b.clone().cross(c)) / 6;
    outward += Number(b.clone().sub(a).cross(c.clone().sub(a)).dot(n) >= 0);
    if (!(Math.abs(n.length() - 1) < 1e-3)) bad++;
  }
  expect(bad).toBe(0);
  expect(volume).toBeGreaterThan(0.005);
  expect(outward / triangles).toBeGreaterThan(0.99);
});

test('it is the same each time', () => {
  expect(dragonMesh().attributes.position.array).toEqual(dragon.attributes.position.array);
});
