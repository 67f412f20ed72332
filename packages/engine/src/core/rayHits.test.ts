import { BoxGeometry, GLBufferAttribute, Mesh, PerspectiveCamera, Ray, Vector2, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { Scene } from './Scene';
import { hitPoint, rayHits } from './rayHits';

it('rays go through what has its vertices on the GPU alone', () => {
  const scene = new Scene();
  const behind = new Mesh(new BoxGeometry(9, 9, 1));
  behind.position.z = -3;
  const freed = new Mesh(new BoxGeometry());
  freed.geometry.computeBoundingSphere();
  (freed.geometry.attributes.position as { array: unknown }).array = null;
  const onGPU = new Mesh(new BoxGeometry());
  onGPU.geometry.setAttribute('position', new GLBufferAttribute({}, 5126, 3, 4, 24) as never);
  scene.three.add(freed, onGPU, behind);
  const camera = new PerspectiveCamera();
  camera.position.z = 5;
  camera.updateMatrixWorld();
  scene.three.updateMatrixWorld();
  expect(hitPoint(scene, camera, new Vector2())?.object).toBe(behind);
  const ray = new Ray(new Vector3(0, 0, 5), new Vector3(0, 0, -1));
  expect(rayHits(scene, ray, camera)[0].object).toBe(behind);
  scene.dispose();
});
