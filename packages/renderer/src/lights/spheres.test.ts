import { OrthographicCamera, PerspectiveCamera, PointLight, SpotLight } from 'three';
import { expect, it } from 'vitest';
import { boundLight, ViewSpace } from './spheres';

const cameras = [new PerspectiveCamera(60, 1.5, 0.1, 100), new OrthographicCamera(-15, 15, 10, -10, 0.1, 100)];

it.each(cameras)('a light covers the share of the picture that its sphere does: $type', (camera) => {
  camera.updateProjectionMatrix();
  const space = new ViewSpace();
  for (const depth of [5, 10, 40]) {
    for (const light of [new PointLight(), new SpotLight(0xffffff, 1, 0, 0.4)]) {
      light.position.z = -depth;
      if (light instanceof SpotLight) light.target.position.set(0, 0, -depth - 1);
      light.updateMatrixWorld();
      if (light instanceof SpotLight) light.target.updateMatrixWorld();
      space.begin(camera);
      expect(boundLight(light, space, new Float64Array([0, 0, 0, 2]), new Float64Array(4), 0)).toBe(true);
      const [halfWidth, halfHeight] = camera instanceof PerspectiveCamera ? [depth * 0.866, depth * 0.5774] : [15, 10];
      expect(space.coverage / ((Math.PI * 2 * 2) / (4 * halfWidth * halfHeight))).toBeCloseTo(1, 3);
    }
  }
});
