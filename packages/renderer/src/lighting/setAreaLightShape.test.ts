import { RectAreaLight } from 'three';
import { expect, it } from 'vitest';
import { setAreaLightShape } from './setAreaLightShape';

it('makes an area light another shape, and refuses one that there is not', () => {
  const light = new RectAreaLight();
  light.userData.farol = { range: 3 };
  setAreaLightShape(light, 'disc');
  expect(light.userData.farol).toEqual({ range: 3, shape: 'disc' });
  expect(() => setAreaLightShape(light, 'disk' as 'disc')).toThrow(
    'Farol: "disk" is no shape; give rectangle, disc, tube.',
  );
  expect(light.userData.farol.shape).toBe('disc');
});
