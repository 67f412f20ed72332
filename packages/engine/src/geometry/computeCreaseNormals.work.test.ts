import { growthOf } from '@farol/tools/workOf';
import { BufferGeometry, Float32BufferAttribute, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { createRandom } from '../base/createRandom';
import { computeCreaseNormals } from './computeCreaseNormals';

test('where very many faces meet each keeps its own normal, by work that grows with them alone', async () => {
  const geometry = new BufferGeometry();
  let result = geometry;
  const growth = await growthOf(6000, (count) => {
    const random = createRandom(4);
    // a scan with one far outlier, beside which all other points weld to one
    const cloud = Array.from({ length: count }, () => [random(), random(), random()]).flat();
    geometry.setAttribute('position', new Float32BufferAttribute([...cloud, 1e9, 0, 0, 0, 1e9, 0, 0, 0, 1e9], 3));
    return () => (result = computeCreaseNormals(geometry));
  });
  expect(growth).toBeLessThan(4.5);
  const [a, b, c] = [0, 1, 2].map((i) => new Vector3().fromBufferAttribute(geometry.getAttribute('position'), i));
  const face = b.sub(a).cross(c.sub(a)).normalize();
  for (let i = 0; i < 3; i++) {
    const normal = new Vector3().fromBufferAttribute(result.getAttribute('normal'), result.index!.getX(i));
    expect(normal.distanceTo(face)).toBeLessThan(1e-3);
  }
});
