import { MathUtils, Matrix4, OrthographicCamera, PerspectiveCamera, Quaternion, Vector3, Vector4 } from 'three';
import { describe, expect, it } from 'vitest';
import { boxRectangle } from './boxRectangle';

const size = { width: 200, height: 100 };

describe('boxRectangle', () => {
  it('holds every point of a box that is in view, whole pixels, within the picture', () => {
    MathUtils.seededRandom(11);
    const random = () => MathUtils.seededRandom() - 0.5;
    const perspective = new PerspectiveCamera(60, 2, 0.1, 100);
    const orthographic = new OrthographicCamera(-4, 4, 2, -2, 0.1, 100);
    let seen = 0;
    let small = 0;
    for (let i = 0; i < 200; i++) {
      const { projectionMatrix } = i % 2 === 0 ? perspective : orthographic;
      const modelView = new Matrix4().compose(
        new Vector3(random() * 10, random() * 6, -6 + random() * 10),
        new Quaternion(random(), random(), random(), random()).normalize(),
        new Vector3(0.1 + Math.abs(random()), 0.5, 2),
      );
      const rectangle = boxRectangle(modelView, projectionMatrix, size, new Vector4());
      const { x, y, z, w } = rectangle;
      expect(rectangle.toArray().every((value) => Number.isInteger(value) && value >= 0)).toBe(true);
      if (z > 0 && w > 0) {
        expect(x + z).toBeLessThanOrEqual(size.width);
        expect(y + w).toBeLessThanOrEqual(size.height);
        if (z * w < 0.25 * size.width * size.height) small++;
      }
      for (let j = 0; j < 50; j++) {
        const point = new Vector4(random(), random(), random(), 1)
          .applyMatrix4(modelView)
          .applyMatrix4(projectionMatrix);
        const pixel = [point.x, point.y].map((value) => value / point.w);
        if (point.w <= 0 || pixel.some((value) => Math.abs(value) >= 1)) continue;
        seen++;
        const [px, py] = [(pixel[0] + 1) * 0.5 * size.width, (pixel[1] + 1) * 0.5 * size.height];
        expect(px >= x && px <= x + z && py >= y && py <= y + w, `box ${i}`).toBe(true);
      }
    }
    expect(seen).toBeGreaterThan(3000);
    expect(small, 'it is no more than needed').toBeGreaterThan(60);
  });

  it('is the whole picture where the box reaches behind the camera, and nothing beside the picture', () => {
    const { projectionMatrix } = new PerspectiveCamera(60, 2, 0.1, 100);
    const at = (x: number, z: number) =>
      boxRectangle(new Matrix4().makeTranslation(x, 0, z), projectionMatrix, size, new Vector4());
    expect(at(0, 0).toArray()).toEqual([0, 0, 200, 100]);
    expect(at(50, -5).z).toBe(0);
  });
});
