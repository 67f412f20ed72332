import {
  AmbientLight,
  DirectionalLight,
  Group,
  HemisphereLight,
  type Light,
  PointLight,
  RectAreaLight,
  SpotLight,
  Vector3,
} from 'three';
import { expect, it } from 'vitest';
import { copyLight } from './copyLight';

const lights: Light[] = [
  new AmbientLight(0x102030, 0.4),
  new HemisphereLight(0x405060, 0x708090, 0.6),
  new DirectionalLight(0x112233, 2),
  new PointLight(0x445566, 7, 8, 1.3),
  new SpotLight(0x778899, 9, 10, 0.6, 0.3, 1.7),
];

/** Numbers and colours of a light. */
const valuesOf = (light: Light): Record<string, unknown> =>
  Object.fromEntries(
    Object.entries(light).flatMap(([name, value]) => {
      if (typeof value === 'number' && name !== 'id') return [[name, value]];
      return value?.isColor ? [[name, value.getHex()]] : [];
    }),
  );

it.each(lights)('a $type is copied with each of its values, at its place in the world', (light) => {
  const above = new Group().add(light);
  above.position.set(1, 2, 3);
  light.position.set(4, 5, 6);
  const { target } = light as Partial<SpotLight>;
  if (target) {
    target.position.set(7, 8, 9);
    above.add(target);
  }
  light.castShadow = true;
  const { shadow } = light as Partial<SpotLight>;
  if (shadow) {
    shadow.bias = -0.25;
    shadow.mapSize.set(64, 32);
  }
  above.updateMatrixWorld(true);
  const copy = copyLight(light)!;
  expect(copy).not.toBe(light);
  expect(copy.type).toBe(light.type);
  expect(valuesOf(copy)).toEqual(valuesOf(light));
  expect(copy.position).toEqual(new Vector3(5, 7, 9));
  if (target) expect((copy as SpotLight).target.position).toEqual(new Vector3(8, 10, 12));
  if (shadow) {
    expect(copy.castShadow).toBe(true);
    expect([(copy as SpotLight).shadow.bias, (copy as SpotLight).shadow.mapSize.toArray()]).toEqual([-0.25, [64, 32]]);
  }
});

it('kinds that stock three lights only by tables of its own are none', () => {
  expect(copyLight(new RectAreaLight())).toBeNull();
});
