import {
  BatchedMesh,
  BoxGeometry,
  BufferGeometry,
  InstancedBufferAttribute,
  InstancedMesh,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
} from 'three';
import { expect, test } from 'vitest';
import { ObjectMotion } from './ObjectMotion';

/** `hasMoved` and `isKnown` of an object after each of some changes. */
function after(object: Object3D, changes: readonly (() => void)[]): boolean[][] {
  const motion = new ObjectMotion();
  motion.remember(object, 0);
  const seen = changes.map((change, i) => {
    change();
    const moved = motion.hasMoved(object);
    const state = [moved, !moved || motion.isKnown(object)];
    motion.remember(object, i + 1);
    return state;
  });
  motion.dispose();
  return seen;
}

test('an object whose vertices are moved or replaced has moved, and it is not known from where', () => {
  const mesh = new Mesh(new BoxGeometry());
  const { position } = mesh.geometry.attributes;
  expect(
    after(mesh, [
      () => {},
      () => (position.needsUpdate = true),
      () => {},
      () => mesh.geometry.setAttribute('position', position.clone()),
      () => (mesh.geometry = new BoxGeometry(2, 1, 1)),
      () => (mesh.position.x += 1) && mesh.updateMatrixWorld(),
    ]),
  ).toEqual([
    [false, true],
    [true, false],
    [false, true],
    [true, false],
    [true, false],
    [true, true],
  ]);
  const buffer = () => new InterleavedBuffer(new Float32Array(18), 6);
  const shared = buffer();
  const attribute = new InterleavedBufferAttribute(shared, 3, 0);
  const interleaved = new Mesh(new BufferGeometry().setAttribute('position', attribute));
  expect(
    after(interleaved, [() => (shared.needsUpdate = true), () => {}, () => (attribute.data = buffer()), () => {}]),
  ).toEqual([
    [true, false],
    [false, true],
    [true, false],
    [false, true],
  ]);
});

test('instances whose matrices or morphs are replaced have moved, and so have those of a batch', () => {
  const material = new MeshBasicMaterial();
  const group = new InstancedMesh(new BoxGeometry(), material, 2);
  const other = () => (group.instanceMatrix = new InstancedBufferAttribute(new Float32Array(32), 16));
  // their former state is copied from the first change on
  expect(after(group, [() => {}, other, other])).toEqual([
    [false, true],
    [true, false],
    [true, true],
  ]);
  const morphed = new Mesh(new BoxGeometry());
  morphed.morphTargetInfluences = [0.5];
  group.setMorphAt(0, morphed);
  expect(after(group, [() => (group.morphTexture!.needsUpdate = true), () => {}])).toEqual([
    [true, false],
    [false, true],
  ]);
  const batch = new BatchedMesh(2, 100, 100, material);
  const box = batch.addGeometry(new BoxGeometry());
  batch.addInstance(box);
  expect(after(batch, [() => batch.setGeometryAt(box, new BoxGeometry(2, 1, 1)), () => {}])).toEqual([
    [true, false],
    [false, true],
  ]);
  // the page has freed the array
  (group.instanceMatrix as { array: unknown }).array = null;
  expect(after(group, [() => {}])).toEqual([[false, true]]);
});
