import { OrthographicCamera, PerspectiveCamera, PointLight, SpotLight } from 'three';
import { expect, it } from 'vitest';
import { boundLight, viewFrustumPlanes } from './spheres';

const cameras = [new PerspectiveCamera(60, 1.5, 0.1, 100), new OrthographicCamera(-15, 15, 10, -10, 0.1, 100)];

it.each(cameras)('a light covers the share of the picture that its sphere does: $type', (camera) => {
  camera.updateProjectionMatrix();
  const { elements } = camera.projectionMatrix;
  const planes = viewFrustumPlanes(elements, new Float64Array(24));
  const space = { view: camera.matrixWorldInverse, projection: elements, planes };
  for (const depth of [5, 10, 40]) {
    for (const light of [new PointLight(), new SpotLight(0xffffff, 1, 0, 0.4)]) {
      light.position.z = -depth;
      if (light instanceof SpotLight) light.target.position.set(0, 0, -depth - 1);
      light.updateMatrixWorld();
      if (light instanceof SpotLight) light.target.updateMatrixWorld();
      const share = boundLight(light, 2, space, new Float64Array(4), new Float64Array(4), 0);
      const [halfWidth, halfHeight] = camera instanceof PerspectiveCamera ? [depth * 0.866, depth * 0.5774] : [15, 10];
      expect(share / ((Math.PI * 2 * 2) / (4 * halfWidth * halfHeight))).toBeCloseTo(1, 3);
    }
  }
});
