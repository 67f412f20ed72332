import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { AssetLibrary, Light, ObjectRenderer, type Scene } from '@farol/engine';
import { deserialize, serialize } from '@farol/engine/files';
import { benchmarkLights } from './benchmark/benchmarkLights';
import { benchmarkLightsObjects } from './benchmark/benchmarkLightsObjects';
import { scenes } from './index';
import { lightBudget } from './lightBudget';
import { sponza } from './sponza/sponza';

const shared = new AssetLibrary();
const few: Record<string, Record<string, number | string>> = {
  temple: { lights: 5 },
  sponza: { lights: 5, textureSize: '128' },
  dragons: { lights: 5 },
  niceScene: { lights: 2 },
  benchmarkLights: { n: 2, m: 3 },
  benchmarkLightsObjects: { n: 2, m: 3, mesh: 'dragon' },
};

const lightPlaces = (scene: Scene): number[][] => scene.componentsOf(Light).map((light) => light.position.toArray());

const seeds = (scene: Scene): unknown[] =>
  scene.find('Lights')!.children.map((light) => light.getComponent('RandomMovement')!.get('seed'));

/** ObjectRenderers of a scene that draw a mesh of their own. */
function meshes(scene: Scene): ObjectRenderer[] {
  const list: ObjectRenderer[] = [];
  scene.traverse((gameObject) => list.push(...gameObject.getComponents(ObjectRenderer)));
  return list.filter((renderer) => renderer.three);
}

const triangles = (scene: Scene): number =>
  meshes(scene).reduce((sum, { geometry }) => sum + geometry!.index!.count / 3, 0);

test('all of the thesis are there', () => {
  expect(new Set(Object.keys(scenes))).toEqual(new Set(Object.keys(few)));
});

describe.each(Object.keys(few))('%s', (name) => {
  test('is the same file after a file, and after being built anew', async () => {
    const scene = await scenes[name].build(few[name], shared);
    const text = JSON.stringify(serialize(scene));
    const copy = await deserialize(text, { assets: shared });
    expect(JSON.stringify(serialize(copy))).toBe(text);
    const again = await scenes[name].build(few[name], shared);
    expect(JSON.stringify(serialize(again))).toBe(text);
    copy.setTime(4.2);
    scene.setTime(1);
    scene.setTime(4.2);
    expect(lightPlaces(copy)).toEqual(lightPlaces(scene));
    for (const each of [scene, copy, again]) each.dispose();
  });

  test('has a camera, lights, and meshes with normals that are all finite', async () => {
    const scene = await scenes[name].build(few[name], shared);
    scene.update(1);
    scene.three.updateMatrixWorld();
    expect(scene.activeCamera).not.toBeNull();
    expect(scene.componentsOf(Light).length).toBeGreaterThan(3);
    const normals = new Set(meshes(scene).map(({ geometry }) => geometry!.getAttribute('normal')));
    let bad = 0;
    for (const normal of normals) {
      const vector = new Vector3();
      for (let i = 0; i < normal.count; i++) {
        // also counts NaN
        if (!(Math.abs(vector.fromBufferAttribute(normal, i).length() - 1) < 1e-3)) bad++;
      }
    }
    expect(bad).toBe(0);
    scene.dispose();
  });

  test('has shadows when it is a sample, at most a few by point lights, and none otherwise', async () => {
    const { build, sample } = scenes[name];
    const [plain, shown] = await Promise.all([build(few[name], shared), build({ ...few[name], ...sample }, shared)]);
    const casters = (scene: Scene): Light[] => scene.componentsOf(Light).filter(({ castShadow }) => castShadow);
    expect(casters(plain)).toEqual([]);
    const lights = shown.componentsOf(Light).filter(({ type }) => type === 'directional' || type === 'spot');
    expect(casters(shown)).toEqual(expect.arrayContaining(lights));
    expect(casters(shown).length).toBeGreaterThan(0);
    expect(casters(shown).length - lights.length).toBeLessThan(5);
    const solid = meshes(shown).filter(({ mesh }) => mesh !== 'bulb');
    expect(solid.filter(({ castShadow, receiveShadow }) => !castShadow && !receiveShadow)).toEqual([]);
    plain.dispose();
    shown.dispose();
  });

  test('gives back all that it held', async () => {
    const assets = new AssetLibrary();
    const scene = await scenes[name].build(few[name], assets);
    scene.three.updateMatrixWorld();
    const disposed = new Set<unknown>();
    const materials = new Set(meshes(scene).map(({ three }) => three!.material));
    const geometries = new Set(meshes(scene).map(({ geometry }) => geometry!));
    for (const each of [...materials, ...geometries]) {
      (each as { addEventListener(type: string, listener: () => void): void }).addEventListener('dispose', () =>
        disposed.add(each),
      );
    }
    scene.dispose();
    expect(disposed.size).toBe(materials.size + geometries.size);
    expect(assets.materials.size).toBe(0);
    expect(assets.uses.size).toBe(0);
    expect(scene.three.children).toEqual([]);
    assets.dispose();
  });

  test('refuses parameters that it does not have, and values out of range', async () => {
    await expect(scenes[name].build({ lamps: 3 }, shared)).rejects.toThrow(`${name}.lamps is unknown`);
    await expect(scenes[name].build({ seed: 0.5 }, shared)).rejects.toThrow(`${name}.seed must be a whole number`);
  });
});

describe('benchmarkLights', () => {
  test.each([
    [1, 1],
    [3, 4],
  ])('%i × %i: that many planes over 30 m, and lights above them', async (n, m) => {
    const scene = await benchmarkLights(n, m, { assets: shared });
    const planes = scene.find('Planes')!.children;
    expect(planes).toHaveLength(n * n);
    expect(planes[0].transform.scale[0] * n).toBeCloseTo(30, 9);
    expect(scene.componentsOf(Light).filter(({ type }) => type === 'point')).toHaveLength(m * m);
    expect(meshes(scene)).toHaveLength(n * n);
    scene.dispose();
  });
});

test('grids of a scene need be no squares', async () => {
  const parameters = { n: 2, nRows: 3, m: 4, mRows: 1 };
  for (const [name, group] of [
    ['benchmarkLights', 'Planes'],
    ['benchmarkLightsObjects', 'Objects'],
  ]) {
    const scene = await scenes[name].build(parameters, shared);
    expect(scene.find(group)!.children).toHaveLength(6);
    expect(new Set(scene.find(group)!.children.map(({ transform }) => transform.position[2])).size).toBe(3);
    const lights = scene.find('Lights')!.children.map(({ transform }) => transform.position);
    expect(lights).toHaveLength(4);
    expect(new Set(lights.map(([, , z]) => z))).toEqual(new Set([0]));
    scene.dispose();
  }
});

describe('benchmarkLightsObjects', () => {
  test('makes meshes of size 1 of any mesh, standing on the floor', async () => {
    const scene = await benchmarkLightsObjects(2, 1, 'temple/column', { assets: shared });
    const [object] = scene.find('Objects')!.children;
    const { geometry } = object.getComponent(ObjectRenderer)!;
    const { min, max } = geometry!.boundingBox!;
    const scale = object.transform.scale[0];
    expect((max.y - min.y) * scale).toBeCloseTo(1, 6);
    expect(object.transform.position[1] + min.y * scale).toBeCloseTo(0, 6);
    await expect(benchmarkLightsObjects(1, 1, 'teapot', { assets: shared })).rejects.toThrow(/'teapot' is unknown/);
    scene.dispose();
  });
});

test.each([
  ['Planes', () => benchmarkLights(3, 1, { assets: shared })],
  ['Objects', () => benchmarkLightsObjects(3, 1, 'sphere', { assets: shared })],
  ['Objects', () => benchmarkLightsObjects(4, 1, 'sphere', { assets: shared })],
])('%s of a benchmark stand round the middle of the scene', async (name, build) => {
  const scene = await build();
  const middle = new Vector3();
  const { children } = scene.find(name)!;
  for (const { transform } of children) middle.add(transform.worldPosition);
  const count = children.length;
  scene.dispose();
  expect(middle.x / count).toBeCloseTo(0, 9);
  expect(middle.z / count).toBeCloseTo(0, 9);
});

describe('sponza', () => {
  test('is an atrium of about 100 meshes and 260,000 triangles, with a dozen materials', async () => {
    const scene = await sponza(0, { assets: shared, textureSize: 128 });
    expect(meshes(scene).length).toBeGreaterThan(90);
    expect(meshes(scene).length).toBeLessThan(115);
    expect(triangles(scene)).toBeGreaterThan(240_000);
    expect(triangles(scene)).toBeLessThan(290_000);
    expect(shared.materials.size).toBeLessThan(16);
    scene.dispose();
  });
});

test('a scene with more lights holds the colours and paths of the one with fewer', async () => {
  const [small, large] = await Promise.all([3, 5].map((m) => benchmarkLights(1, m, { assets: shared })));
  expect(seeds(large).slice(0, 9)).toEqual(seeds(small));
  small.dispose();
  large.dispose();
});

test('the more lights there are, the smaller and the dimmer each one is', () => {
  const budgets = [10, 50, 200, 1000, 5000].map((count) => lightBudget(count, { volume: 5600, range: 6, light: 20 }));
  for (let i = 1; i < budgets.length; i++) {
    expect(budgets[i].range).toBeLessThanOrEqual(budgets[i - 1].range);
    expect(budgets[i].intensity).toBeLessThanOrEqual(budgets[i - 1].intensity);
  }
  expect(budgets[0]).toEqual({ range: 6, intensity: 20 });
  expect(budgets[4].range).toBeGreaterThan(1.5);
});
