import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { windowCamera } from './windowCamera';

const cameras = {
  perspective: new PerspectiveCamera(50, 160 / 96, 0.1, 40),
  orthographic: new OrthographicCamera(-5, 5, 3, -3, 0.1, 40),
  'off-centre': new PerspectiveCamera(50, 160 / 96, 0.1, 40),
};
cameras['off-centre'].setViewOffset(320, 192, 100, 30, 160, 96);

describe.each(Object.entries(cameras))('the window of a %s camera', (_name, camera) => {
  camera.position.set(1, 2, 5);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const window = windowCamera(camera, 32, 48, 16, 160, 96);

  it('shows each point at the same pixel, and as deep', () => {
    for (const point of [new Vector3(0, 0, 0), new Vector3(-1, 0.3, 1), new Vector3(2, -1, -3)]) {
      const whole = point.clone().project(camera);
      const part = point.clone().project(window);
      expect(((part.x + 1) / 2) * 16 + 32).toBeCloseTo(((whole.x + 1) / 2) * 160, 6);
      expect(((part.y + 1) / 2) * 16 + 48).toBeCloseTo(((whole.y + 1) / 2) * 96, 6);
      expect(part.z).toBeCloseTo(whole.z, 9);
      expect(part.unproject(window).distanceTo(point)).toBeLessThan(1e-5);
    }
  });

  it('is the camera in all else', () => {
    expect(window).toBeInstanceOf(camera.constructor);
    expect(window.layers).toBe(camera.layers);
    expect(window.matrixWorld).toBe(camera.matrixWorld);
    expect(camera.projectionMatrix).not.toBe(window.projectionMatrix);
  });
});
