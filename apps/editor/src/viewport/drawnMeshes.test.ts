import { GameObject, ObjectRenderer, Scene } from '@farol/engine';
import { BoxGeometry, PerspectiveCamera, Ray, Vector2, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { boundsOf } from './boundsOf';
import { vertexBesideRay } from './handles/vertexBesideRay';
import { pick } from './pick';
import { SurfaceBelow } from './placing/SurfaceBelow';
import { SurfaceSampler } from './placing/SurfaceSampler';

it('what has its vertices on the GPU alone is a place, without corners or surface', () => {
  const scene = new Scene();
  const geometry = new BoxGeometry();
  scene.assets.register('case', geometry);
  const object = new GameObject('Case');
  object.addComponent(ObjectRenderer, { mesh: 'case' });
  object.transform.position = [1, 2, 3];
  scene.add(object);
  scene.three.updateMatrixWorld();
  // as a script may, after three has uploaded the array
  for (const attribute of [...Object.values(object.getComponent(ObjectRenderer)!.geometry!.attributes)])
    (attribute as { array: unknown }).array = null;
  const { min, max } = boundsOf([object]);
  expect([min.toArray(), max.toArray()]).toEqual([
    [1, 2, 3],
    [1, 2, 3],
  ]);
  const camera = new PerspectiveCamera();
  camera.position.set(1, 2, 9);
  camera.updateMatrixWorld();
  expect(pick(scene, camera, new Vector2())).toBeNull();
  const ray = new Ray(new Vector3(1, 2, 9), new Vector3(0, 0, -1));
  expect(vertexBesideRay(scene, ray, camera, new Set(), 100)).toBeNull();
  expect(new SurfaceBelow(scene, new Set()).heightAt({ x: 1, y: 9, z: 3 })).toBe(0);
  expect(() => new SurfaceSampler([object], true)).not.toThrow();
  scene.dispose();
});
