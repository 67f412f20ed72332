import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { beforeEach, describe, expect, test } from 'vitest';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { Camera } from './Camera';

let camera: Camera;

beforeEach(() => {
  const gameObject = new GameObject('Camera');
  new Scene().add(gameObject);
  camera = gameObject.addComponent(Camera);
});

describe('projection', () => {
  test('by setPerspective is that of the four parameters', () => {
    camera.setPerspective(Math.PI / 2, 2, 1, 9);
    const { elements } = camera.projectionMatrix;
    expect(elements[5]).toBeCloseTo(1, 9);
    expect(elements[0]).toBeCloseTo(0.5, 9);
    expect(elements[10]).toBeCloseTo(-10 / 8, 9);
    expect(camera.autoAspect).toBe(false);
  });

  test('can be orthographic, of a height in metres', () => {
    camera.setViewport(300, 100);
    camera.projection = 'orthographic';
    camera.size = 4;
    expect(camera.three).toBeInstanceOf(OrthographicCamera);
    expect(new Vector3(6, 2, -1).applyMatrix4(camera.projectionMatrix).toArray().slice(0, 2)).toEqual([1, 1]);
    camera.projection = 'perspective';
    expect(camera.three).toBeInstanceOf(PerspectiveCamera);
    expect(camera.gameObject.object3D.children).toEqual([camera.three]);
  });

  test('stays finite when far is before near', () => {
    camera.near = 10;
    camera.far = 1;
    for (const element of camera.projectionMatrix.elements) expect(Number.isFinite(element)).toBe(true);
  });
});

describe('view', () => {
  test('is the inverse of where the object is', () => {
    camera.lookAt([1, 2, 3], [1, 2, -7]);
    const { x, y, z } = new Vector3(1, 2, -7).applyMatrix4(camera.viewMatrix);
    expect(x).toBeCloseTo(0, 9);
    expect(y).toBeCloseTo(0, 9);
    expect(z).toBeCloseTo(-10, 9);
  });

  test('follows the object when it moves', () => {
    camera.gameObject.transform.translate([0, 0, 5]);
    expect(new Vector3().applyMatrix4(camera.viewMatrix).z).toBeCloseTo(-5, 9);
  });
});
