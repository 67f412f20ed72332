import { BoxGeometry, InstancedMesh, Matrix4, Mesh, MeshStandardMaterial, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { viewFrustumPlanes } from '../../lights/spheres';
import { setSurface, Surface } from '../../surfaces';
import { isMergeable } from './merged/isMergeable';
import { boxInsidePlanes, boxOutsidePlanes, casterBox } from './casterBox';
import { isBeyond, isWithin, makeReach } from '../slots/reach';

function random(seed: number): () => number {
  return () => {
    seed = (seed * 16807) % 2147483647;
    return (seed - 1) / 2147483646;
  };
}

describe('casterBox', () => {
  test('holds every vertex of a turned, scaled object, and touches some, and leaves the geometry as it was', () => {
    const next = random(3);
    for (let n = 0; n < 50; n++) {
      const mesh = new Mesh(new BoxGeometry(1 + next(), 1, 1 + 3 * next()), new MeshStandardMaterial());
      mesh.position.set(next() * 9, next() * 9, next() * 9);
      mesh.rotation.set(next() * 6, next() * 6, next() * 6);
      mesh.scale.set(-next(), 0.5, 2);
      mesh.updateMatrixWorld();
      const box = new Float64Array(6);
      expect(casterBox(mesh, box)).toBe(true);
      const { position } = mesh.geometry.attributes;
      const point = new Vector3();
      const farthest = [0, 0, 0];
      for (let i = 0; i < position.count; i++) {
        point.fromBufferAttribute(position, i).applyMatrix4(mesh.matrixWorld);
        expect(isBeyond(makeReach(point.x, point.y, point.z, 1e-6), box, 0)).toBe(false);
        point.toArray().forEach((value, axis) => {
          farthest[axis] = Math.max(farthest[axis], value - box[axis]);
        });
      }
      farthest.forEach((value, axis) => expect(value).toBeCloseTo(box[3 + axis], 6));
      expect(mesh.geometry.boundingBox).toBeNull();
    }
  });

  test('what it says is outside of a frustum has no point inside', () => {
    const next = random(11);
    const camera = new PerspectiveCamera(50, 1.3, 0.5, 20);
    const planes = viewFrustumPlanes(camera.projectionMatrix.elements, new Float64Array(24));
    let outside = 0;
    for (let n = 0; n < 500; n++) {
      const box = new Float64Array([
        next() * 20 - 10,
        next() * 20 - 10,
        -next() * 25,
        next() * 3,
        next() * 3,
        next() * 3,
      ]);
      if (!boxOutsidePlanes(planes, box)) continue;
      outside++;
      for (let i = 0; i < 40; i++) {
        const p = [0, 1, 2].map((axis) => box[axis] + (next() * 2 - 1) * box[3 + axis]);
        let inside = true;
        for (let k = 0; k < 24; k += 4) {
          if (planes[k] * p[0] + planes[k + 1] * p[1] + planes[k + 2] * p[2] + planes[k + 3] < 0) inside = false;
        }
        expect(inside).toBe(false);
      }
    }
    expect(outside).toBeGreaterThan(50);
  });

  test('it is larger by the reach of a surface; one that displaces without a declared reach has none', () => {
    const mesh = new Mesh(new BoxGeometry(2, 2, 2), new MeshStandardMaterial());
    const text =
      'uniform float a; // = 2\n// reach: 0.5 + 0.25 * a\nvoid displace(inout VertexData v) { v.positionOS *= a; }';
    const surface = new Surface('grows', text);
    const values = setSurface(mesh.material, surface);
    const box = new Float64Array(6);
    expect(casterBox(mesh, box)).toBe(true);
    expect([...box]).toEqual([0, 0, 0, 2, 2, 2]);
    values.a.value = -6;
    casterBox(mesh, box);
    expect([...box]).toEqual([0, 0, 0, 3, 3, 3]);
    expect(isMergeable(mesh)).toBe(false);
    surface.source = text.replace('// reach', '// no reach');
    expect(casterBox(mesh, box)).toBe(false);
  });

  test('instanced meshes and such have none', () => {
    const mesh = new InstancedMesh(new BoxGeometry(), new MeshStandardMaterial(), 2);
    mesh.setMatrixAt(0, new Matrix4());
    expect(casterBox(mesh, new Float64Array(6))).toBe(false);
  });
});

test('boxInsidePlanes says whether all corners are within, isWithin whether they are in range', () => {
  const next = random(13);
  const camera = new PerspectiveCamera(50, 1.5, 0.5, 20);
  const planes = viewFrustumPlanes(camera.projectionMatrix.elements, new Float64Array(24));
  let inside = 0;
  let near = 0;
  for (let n = 0; n < 500; n++) {
    const box = Float64Array.from({ length: 6 }, (_, i) => (i < 3 ? next() * 10 - (i === 2 ? 12 : 5) : next()));
    const corners = Array.from({ length: 8 }, (_, k) =>
      new Vector3().fromArray([0, 1, 2].map((axis) => box[axis] + ((k >> axis) & 1 ? 1 : -1) * box[axis + 3])),
    );
    const isInside = corners.every((corner) => {
      const { x, y, z } = corner.clone().applyMatrix4(camera.projectionMatrix);
      return corner.z < 0 && Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) <= 1;
    });
    expect(boxInsidePlanes(planes, box)).toBe(isInside);
    const isNear = corners.every((corner) => corner.length() <= 7);
    expect(isWithin(makeReach(0, 0, 0, 7), box, 0)).toBe(isNear);
    inside += +isInside;
    near += +isNear;
  }
  expect(Math.min(inside, near)).toBeGreaterThan(30);
});
