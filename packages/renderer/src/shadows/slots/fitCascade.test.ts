import { DirectionalLight, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { placeAndDraw } from './testing/placeAndDraw';
import { fitCascade } from './fitCascade';
import { ShadowFace } from './ShadowFace';
import { ShadowSlot } from './ShadowSlot';

function setUp(): { view: PerspectiveCamera; whole: OrthographicCamera; light: DirectionalLight } {
  const view = new PerspectiveCamera(50, 4 / 3, 0.1, 200);
  view.position.set(0, 1.6, 4);
  view.lookAt(0, 0.4, 0);
  view.updateMatrixWorld();
  const light = new DirectionalLight();
  light.position.set(4, 10, 3);
  Object.assign(light.shadow.camera, { left: -30, right: 30, top: 20, bottom: -30, near: 1, far: 40 });
  light.updateMatrixWorld();
  light.target.updateMatrixWorld();
  const slot = new ShadowSlot(light);
  slot.follow(false, view);
  return { view, whole: slot.faces[0].camera as OrthographicCamera, light };
}

describe('fitCascade', () => {
  test('coordinates of the whole map become those of the cascade, and holds what the camera sees near by', () => {
    const { view, whole } = setUp();
    for (const wider of [1, 2, 3]) {
      const face = new ShadowFace(new OrthographicCamera());
      const fit = new Float64Array(4);
      fitCascade(face, whole, view, wider, 128, 128, fit);
      const reach = 60 / 4 ** wider;
      for (const [x, y] of [
        [-1, -1],
        [1, 1],
        [0.3, -0.7],
      ]) {
        const direction = new Vector3(x, y, 0.5).unproject(view).sub(view.position).normalize();
        const axis = new Vector3(0, 0, -1).transformDirection(view.matrixWorld);
        const point = view.position.clone().addScaledVector(direction, (0.95 * reach) / direction.dot(axis));
        const there = point.clone().project(face.camera).multiplyScalar(0.5).addScalar(0.5);
        const across = point.clone().project(whole).multiplyScalar(0.5).addScalar(0.5);
        expect(across.x * fit[0] + fit[1]).toBeCloseTo(there.x, 5);
        expect(across.y * fit[2] + fit[3]).toBeCloseTo(there.y, 5);
        expect(across.z).toBeCloseTo(there.z, 5);
        expect(Math.max(Math.abs(there.x - 0.5), Math.abs(there.y - 0.5))).toBeLessThan(0.5);
      }
    }
  });

  test('tiles of a picture have the cascades of the whole', () => {
    const { view, whole } = setUp();
    const fitted = (): number[] => {
      const fit = new Float64Array(4);
      view.updateProjectionMatrix();
      fitCascade(new ShadowFace(new OrthographicCamera()), whole, view, 2, 128, 128, fit);
      return [...fit];
    };
    const all = fitted();
    for (const x of [0, 250]) {
      view.setViewOffset(400, 300, x, 20, 150, 90);
      fitted().forEach((value, i) => expect(value).toBeCloseTo(all[i], 9));
    }
  });

  test('each cascade shows what is near the camera, and its map is stale when the camera moves, not at rest', () => {
    const { view, light } = setUp();
    const slot = new ShadowSlot(light, 4);
    slot.follow(false, view);
    placeAndDraw(slot, 128, 128, 256);
    expect(slot.faces.map(({ x, y }) => [x, y])).toEqual([
      [0, 0],
      [128, 0],
      [0, 128],
      [128, 128],
    ]);
    slot.faces.forEach((face, i) => {
      const point = new Vector3(0, 0, i < 3 ? -0.3 : -20).applyMatrix4(view.matrixWorld);
      const at = point.project(face.camera);
      expect(Math.max(Math.abs(at.x), Math.abs(at.y)), `map ${i}`).toBeLessThan(1);
    });
    slot.follow(false, view);
    expect(slot.map.state).toBe('whole');
    view.position.x += 2;
    view.updateMatrixWorld();
    slot.follow(false, view);
    expect(slot.map.state).toBe('stale-whole');
  });
});
