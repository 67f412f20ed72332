import { DirectionalLight, PointLight } from 'three';
import { expect, it } from 'vitest';
import { LightWatch } from './LightWatch';

const points = (count: number) => Array.from({ length: count }, (_, i) => new PointLight(0xffffff, i + 1, 10));

it('tells a change of a light that it knows, and none of lights that come and go', () => {
  const watch = new LightWatch();
  const sun = new DirectionalLight();
  const boundeds = points(3);
  const lights = { directionals: [sun], unboundeds: [], boundeds };
  expect(watch.changed(lights)).toBe(false);
  boundeds.pop();
  boundeds.push(...points(2));
  expect(watch.changed(lights)).toBe(false);
  boundeds[0].intensity = 0.5;
  expect(watch.changed(lights)).toBe(true);
  expect(watch.changed(lights)).toBe(false);
  sun.target.position.x = 1;
  sun.target.updateMatrixWorld();
  expect(watch.changed(lights)).toBe(true);
  boundeds[1].position.y = 2;
  boundeds[1].updateMatrixWorld();
  expect(watch.changed(lights)).toBe(true);
});

it('looks at each of many lights within some frames', () => {
  const watch = new LightWatch();
  const boundeds = points(1000);
  const lights = { directionals: [], unboundeds: [], boundeds };
  for (let i = 0; i < 4; i++) expect(watch.changed(lights)).toBe(false);
  boundeds[999].color.set(1, 0, 0);
  expect([0, 1, 2, 3].map(() => watch.changed(lights))).toContain(true);
});
