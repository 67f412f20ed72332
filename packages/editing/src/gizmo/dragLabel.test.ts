import { Matrix4, Object3D, Quaternion, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { dragLabel } from './dragLabel';
import { TransformDrag } from './TransformDrag';

const pose = { position: new Vector3(), quaternion: new Quaternion(), scale: new Vector3(1, 1, 1) };

it('says what a drag has done to what', () => {
  const pivot = new Object3D();
  pivot.position.set(1, 2, 3);
  pivot.updateMatrixWorld();
  const drag = new TransformDrag(pivot, [{ ...pose, parentWorld: new Matrix4() }]);
  const one = [{ name: 'Lantern 3' }];
  pivot.position.add(new Vector3(0, 1.2, 1e-15));
  expect(dragLabel('translate', one, drag)).toBe('Moved Lantern 3 by 0, 1.2, 0 m');
  expect(dragLabel('translate', [...one, { name: 'Box' }], drag)).toBe('Moved 2 objects by 0, 1.2, 0 m');
  pivot.rotateY(-Math.PI / 4);
  expect(dragLabel('rotate', one, drag)).toBe('Rotated Lantern 3 by -45°');
  pivot.rotateY(Math.PI);
  expect(dragLabel('rotate', one, drag)).toBe('Rotated Lantern 3 by 135°');
  pivot.scale.set(2, 2, 2);
  expect(dragLabel('scale', one, drag)).toBe('Scaled Lantern 3 by 2');
  pivot.scale.set(2, 1, 1);
  expect(dragLabel('scale', [{ name: '', type: 'Mesh' }], drag)).toBe('Scaled Mesh by 2, 1, 1');
});
