import { BoxGeometry, Mesh, MeshStandardMaterial, Object3D, Scene } from 'three';
import { expect, it } from 'vitest';
import { collectMeshes } from '../scene/collectMeshes';
import { testOptions } from '../testing/testOptions';
import { distinctSurfaces } from './unwrapStaticMeshes';

const [geometry, smooth] = [new BoxGeometry(1, 2, 3), new MeshStandardMaterial()];

const boxOf = (scale: readonly [number, number, number], material = smooth): Mesh => {
  const mesh = new Mesh(geometry, material);
  mesh.scale.set(...scale);
  return mesh;
};

it('meshes share a surface where geometry, size and shading are equal, however they are placed', () => {
  const turned = boxOf([1, 1, 1]);
  turned.rotation.set(1, 2, 3);
  turned.position.set(4, 5, 6);
  const below = new Object3D().add(boxOf([1, 1, 1]));
  below.scale.setScalar(2);
  const meshes = [
    ...[boxOf([1, 1, 1]), turned, boxOf([2, 2, 2]), below],
    ...[boxOf([1, 1, 2]), boxOf([1, 1, 1], new MeshStandardMaterial({ flatShading: true }))],
    new Mesh(new BoxGeometry(1, 2, 3), smooth),
  ];
  const scene = new Scene().add(...meshes);
  scene.updateMatrixWorld(true);
  const { surfaces, surfaceOf } = distinctSurfaces(collectMeshes(scene, testOptions()));
  expect(surfaceOf).toEqual([0, 0, 1, 1, 2, 3, 4]);
  expect(surfaces.map(({ normals }) => normals !== null)).toEqual([true, true, true, false, true]);
  // sides in metres: each box in its world size
  const sides = surfaces.map(({ positions }) =>
    [0, 1, 2].map((axis) => 2 * Math.max(...positions.filter((_, i) => i % 3 === axis))),
  );
  const whole = [1, 2, 3];
  expect(sides).toEqual([whole, [2, 4, 6], [1, 2, 6], whole, whole]);
});
