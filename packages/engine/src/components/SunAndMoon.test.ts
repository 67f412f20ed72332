import { DirectionalLight, type Texture } from 'three';
import { expect, test, vi } from 'vitest';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { Light } from './Light';
import { SunAndMoon } from './SunAndMoon';

const RADIANS = Math.PI / 180;

async function made(values: Parameters<GameObject['addComponent']>[1] = {}): Promise<{
  scene: Scene;
  sun: SunAndMoon;
  light: Light;
}> {
  const scene = new Scene();
  const object = new GameObject('Sun');
  scene.add(object);
  const sun = object.addComponent(SunAndMoon, values);
  const light = object.addComponent(Light, { type: 'directional', diffuse: [0, 1, 0] });
  await scene.settings.skyReady;
  return { scene, sun, light };
}

test('at noon of midsummer in Madrid the sun stands high in the south, white, and the sky is seen and lights', async () => {
  const { scene, sun, light } = await made({ hour: 14.25 });
  expect(sun.sun.elevation / RADIANS).toBeCloseTo(73, 0);
  expect(sun.sun.azimuth / RADIANS).toBeCloseTo(180, -1);
  scene.three.updateMatrixWorld(true);
  const { x, y, z } = light.direction;
  // north is -Z: light of a sun in the south shines north and down
  expect([y, Math.abs(x) < 0.1, z < -0.2]).toEqual([expect.closeTo(-Math.sin(sun.sun.elevation), 3), true, true]);
  const three = light.three as DirectionalLight;
  expect(three.intensity).toBeGreaterThan(2.8);
  expect(three.color.b / three.color.r).toBeGreaterThan(0.7);
  expect(scene.three.background).toBe(scene.three.environment);
  expect((scene.three.background as Texture).isTexture).toBe(true);
});

test('lux as measured: sun and sky by day, the moon alone by night', async () => {
  const { scene, sun, light } = await made({ hour: 14.25, brightness: 'measured' });
  expect(light.three.intensity).toBeGreaterThan(100_000);
  // the sky's own light on level ground is 16 klx, independent of its image's values
  expect(scene.three.environmentIntensity).toBeGreaterThan(3000);
  // full moon of 2026-05-31, over Madrid at 2 in the night
  Object.assign(sun, { month: 5, day: 31, hour: 2 });
  expect(sun.moon.lit).toBeGreaterThan(0.98);
  expect(sun.sun.elevation).toBeLessThan(-0.3);
  expect(light.three.intensity).toBeGreaterThan(0.05);
  expect(light.three.intensity).toBeLessThan(0.27);
  expect(scene.three.environmentIntensity).toBeLessThan(1);
  scene.three.updateMatrixWorld(true);
  expect(light.direction.y).toBeCloseTo(-Math.sin(sun.moon.elevation), 3);
});

test('the day goes by while the scene plays, and a reset brings the hour back', async () => {
  const { scene, light } = await made({ hour: 12, speed: 2 });
  const direction = (): number => {
    scene.three.updateMatrixWorld(true);
    return light.direction.x;
  };
  const before = direction();
  scene.update(1);
  expect(direction()).toBeGreaterThan(before + 0.2);
  scene.reset();
  expect(direction()).toBeCloseTo(before, 9);
});

test('nothing of it is an edit, and all is given back when it is switched off or removed', async () => {
  const { scene, sun, light } = await made();
  expect([light.diffuse, light.intensity, scene.settings.background]).toEqual([[0, 1, 0], 1, 'colour']);
  const { background } = scene.three;
  expect((background as Texture).isTexture).toBe(true);
  sun.enabled = false;
  expect(light.three.color.toArray()).toEqual([0, 1, 0]);
  expect((scene.three.background as Texture).isTexture).toBeUndefined();
  sun.enabled = true;
  expect(light.three.color.g).not.toBe(1);
  sun.gameObject.removeComponent(sun);
  expect([light.three.intensity, light.three.color.toArray()]).toEqual([1, [0, 1, 0]]);
});

test('turning the object by hand does not turn the sun, whatever its parent does', async () => {
  const { scene, sun, light } = await made();
  scene.three.updateMatrixWorld(true);
  const before = light.direction.toArray();
  sun.gameObject.transform.set('rotation', [1, 2, 3]);
  scene.three.updateMatrixWorld(true);
  light.direction.toArray().forEach((value, i) => expect(value).toBeCloseTo(before[i], 9));
});

test('a file keeps what was set', async () => {
  const { scene } = await made({ hour: 6.5, latitude: 1, north: 0.5 });
  const [again] = (await deserialize(serialize(scene))).componentsOf<SunAndMoon>(SunAndMoon);
  expect([again.hour, again.latitude, again.north, again.speed]).toEqual([6.5, 1, 0.5, 0]);
});

test('of several the first that is active shows its sky, so that many in a file are not painted one by one', () => {
  const scene = new Scene();
  const shown = vi.spyOn(scene.settings, 'showDay').mockImplementation(() => {});
  const suns = ['One', 'Two', 'Three'].map((name) => {
    const object = new GameObject(name);
    scene.add(object);
    return object.addComponent(SunAndMoon);
  });
  expect(shown).toHaveBeenCalledTimes(1);
  suns[0].enabled = false;
  expect(shown).toHaveBeenLastCalledWith(null);
  suns[1].update(0, 0);
  expect(shown.mock.lastCall![0]?.sun).toBeDefined();
});
