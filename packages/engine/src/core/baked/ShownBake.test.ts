import { LightProbes } from '@farol/renderer/light-probes';
import { type Mesh, MeshStandardMaterial, SphericalHarmonics3, Vector3 } from 'three';
import { afterEach, beforeAll, expect, test, vi } from 'vitest';
import { Light } from '../../components/Light';
import { ObjectRenderer } from '../../components/ObjectRenderer';
import { loadBakeCode } from './bakeCode';
import { GameObject } from '../GameObject';
import { Scene } from '../Scene';
import { deserialize } from '../../files/deserialize';
import { containerContent, inlineAssets } from '../../files/container';
import { bakeSignature } from '../../bake/bakeSignature';
import { dampRinging, fillBuriedProbes, probeBox } from '../../bake/probeGrid';
import { bakeSources } from '../../bake/bakeSources';
import { smallBake } from '../../bake/testing/smallBake';
import { writeBake } from '../../assets/bake/writeBake';

beforeAll(loadBakeCode);
afterEach(() => vi.restoreAllMocks());

/** A static floor and wall of one material, a moving ball, a baked and a realtime lamp. */
function room(): Scene {
  const scene = new Scene();
  const add = (name: string, isStatic: boolean): GameObject => {
    const object = new GameObject(name, { id: name });
    object.isStatic = isStatic;
    scene.add(object);
    return object;
  };
  for (const name of ['Floor', 'Wall']) add(name, true).addComponent(ObjectRenderer, { mesh: 'plane' });
  add('Ball', false).addComponent(ObjectRenderer, { mesh: 'sphere' });
  add('Lamp', true).addComponent(Light, { mode: 'baked' });
  add('Sun', true).addComponent(Light, { type: 'directional' });
  return scene;
}

const meshOf = (scene: Scene, name: string): Mesh => scene.find(name)!.getComponent(ObjectRenderer)!.three!;
const lightOf = (scene: Scene, name: string): Light => scene.find(name)!.getComponent(Light)!;
const hasLightmap = (scene: Scene, name: string): boolean =>
  (meshOf(scene, name).material as MeshStandardMaterial).lightMap !== null;

/** Bakes a scene and applies the result. */
async function bake(scene: Scene): Promise<void> {
  scene.assets.registerFile('Baked light.bake', new Blob([await writeBake(smallBake(scene))]));
  await scene.assets.load('Baked light.bake');
  scene.settings.bakedLight = 'Baked light.bake';
}

test('static meshes get lightmaps and baked lights go; without it all is as before', async () => {
  const scene = room();
  const before = ['Floor', 'Wall', 'Ball'].map((name) => ({ ...meshOf(scene, name) }));
  await bake(scene);
  expect(scene.baked.isShown).toBe(true);
  expect(['Floor', 'Wall', 'Ball'].map((name) => hasLightmap(scene, name))).toEqual([true, true, false]);
  const [floor, wall] = [meshOf(scene, 'Floor'), meshOf(scene, 'Wall')];
  expect(floor.geometry.getAttribute('uv1').count).toBe(6);
  expect((floor.material as MeshStandardMaterial).lightMap!.channel).toBe(1);
  // meshes that share a material share the lightmapped one too
  expect(floor.material).toBe(wall.material);
  expect(lightOf(scene, 'Lamp').three.visible).toBe(false);
  expect(lightOf(scene, 'Sun').three.visible).toBe(true);
  expect(scene.requiredEffects.map(({ effectClass }) => effectClass)).toEqual([LightProbes]);

  scene.settings.bakedLight = null;
  const after = ['Floor', 'Wall', 'Ball'].map((name) => meshOf(scene, name));
  expect(after.map(({ geometry, material }) => ({ geometry, material }))).toEqual(
    before.map(({ geometry, material }) => ({ geometry, material })),
  );
  expect(lightOf(scene, 'Lamp').three.visible).toBe(true);
  expect(scene.requiredEffects).toEqual([]);
});

test('what is edited of a mesh with a lightmap is seen; a mesh of another shape goes without', async () => {
  const scene = room();
  await bake(scene);
  const floor = scene.find('Floor')!.getComponent(ObjectRenderer)!;
  floor.colour = [1, 0, 0];
  expect(hasLightmap(scene, 'Floor')).toBe(true);
  expect((floor.three!.material as MeshStandardMaterial).color.toArray()).toEqual([1, 0, 0]);
  expect(meshOf(scene, 'Wall').material).not.toBe(floor.three!.material);
  floor.mesh = 'sphere';
  expect(hasLightmap(scene, 'Floor')).toBe(false);
  floor.mesh = 'plane';
  expect(hasLightmap(scene, 'Floor')).toBe(true);
  const object = scene.find('Floor')!;
  scene.remove(object);
  expect(floor.three).toBeNull();
  scene.add(object);
  expect(hasLightmap(scene, 'Floor')).toBe(true);
});

test('a light that is no longer baked shines, and one that was switched off stays dark', async () => {
  const scene = room();
  await bake(scene);
  const lamp = lightOf(scene, 'Lamp');
  lamp.mode = 'realtime';
  expect(lamp.three.visible).toBe(true);
  lamp.mode = 'baked';
  expect(lamp.three.visible).toBe(false);
  // replaces the three light by a new one
  lamp.type = 'spot';
  expect(lamp.three.visible).toBe(false);
  lamp.enabled = false;
  scene.settings.bakedLight = null;
  expect(lamp.three.visible).toBe(false);
});

test('while it is suspended the scene is as without', async () => {
  const scene = room();
  await bake(scene);
  const resume = scene.baked.suspend();
  expect([hasLightmap(scene, 'Floor'), lightOf(scene, 'Lamp').three.visible]).toEqual([false, true]);
  resume();
  expect([hasLightmap(scene, 'Floor'), lightOf(scene, 'Lamp').three.visible]).toEqual([true, false]);
});

test('a scene opens as it was saved: in a container, and as plain JSON', async () => {
  const scene = room();
  await bake(scene);
  const content = containerContent(scene);
  expect(content.file.assets).toEqual([{ name: 'Baked light.bake', type: 'bake', file: 'assets/Baked%20light.bake' }]);
  const opened = await deserialize(JSON.stringify(content.file), { fileOf: (path) => content.files.get(path) ?? null });
  const inline = await deserialize(JSON.stringify(await inlineAssets(content)));
  for (const each of [opened, inline]) {
    expect(each.find('Floor')!.isStatic).toBe(true);
    expect(each.find('Ball')!.isStatic).toBe(false);
    expect([hasLightmap(each, 'Floor'), hasLightmap(each, 'Ball')]).toEqual([true, false]);
    expect(lightOf(each, 'Lamp').three.visible).toBe(false);
    expect(bakeSignature(each)).toBe(bakeSignature(scene));
    expect(each.assets.bake('Baked light.bake').data).toEqual(scene.assets.bake('Baked light.bake').data);
  }
});

test('a file without baked light has no word of it', () => {
  const scene = new Scene();
  const object = new GameObject('Box');
  object.addComponent(ObjectRenderer);
  object.addComponent(Light);
  scene.add(object);
  expect(JSON.stringify(containerContent(scene).file)).not.toMatch(/bake|static|mode/i);
});

test('the signature tells what makes baked light wrong, and nothing else', () => {
  const scene = room();
  const first = bakeSignature(scene);
  const same = (change: () => void): void => {
    change();
    expect(bakeSignature(scene)).toBe(first);
  };
  const other = (change: () => void, back: () => void): void => {
    change();
    expect(bakeSignature(scene)).not.toBe(first);
    back();
    expect(bakeSignature(scene)).toBe(first);
  };
  const [floor, lamp] = [scene.find('Floor')!, scene.find('Lamp')!];
  const renderer = floor.getComponent(ObjectRenderer)!;
  same(() => (scene.find('Ball')!.transform.position = [1, 2, 3]));
  same(() => (lightOf(scene, 'Sun').intensity = 5));
  same(() => (floor.name = 'Ground'));
  same(() => (scene.settings.bakeSamples = 16));
  same(() => (renderer.receiveShadow = true));
  same(() => scene.add(floor));
  other(
    () => (floor.transform.position = [0, 1, 0]),
    () => (floor.transform.position = [0, 0, 0]),
  );
  other(
    () => (floor.isStatic = false),
    () => (floor.isStatic = true),
  );
  other(
    () => (renderer.colour = [1, 0, 0]),
    () => (renderer.colour = renderer.fields.colour.default as [number, number, number]),
  );
  other(
    () => (lightOf(scene, 'Lamp').intensity = 2),
    () => (lightOf(scene, 'Lamp').intensity = 1),
  );
  other(
    () => (lamp.active = false),
    () => (lamp.active = true),
  );
  other(
    () => (lightOf(scene, 'Sun').mode = 'mixed'),
    () => (lightOf(scene, 'Sun').mode = 'realtime'),
  );
  other(
    () => (scene.settings.background = 'sky'),
    () => (scene.settings.background = 'colour'),
  );
});

test('a static object that moves while the scene plays is told once', async () => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
  const scene = room();
  await bake(scene);
  const play = (frames: number, speed: number): void => {
    for (let i = 0; i < frames; i++) {
      scene.update(1 / 60);
      scene.find('Floor')!.object3D.position.x += speed;
      scene.find('Ball')!.object3D.position.x += 0.1;
      scene.three.updateMatrixWorld();
    }
  };
  scene.find('Floor')!.transform.position = [0, 3, 0];
  scene.three.updateMatrixWorld();
  play(100, 0);
  expect(warn).not.toHaveBeenCalled();
  play(200, 0.01);
  expect(warn.mock.calls).toEqual([
    [
      "Farol: 'Floor' is static and moves while the scene plays: its baked light does not move with it. Switch Static off and bake again.",
    ],
  ]);
});

test('probes fill the box of what is static; those within walls take the light beside them', () => {
  const scene = room();
  const { meshes } = bakeSources(scene);
  expect(meshes.map(({ component }) => component.gameObject.name)).toEqual(['Floor', 'Wall']);
  expect(probeBox(meshes, 0.25)!.counts).toEqual([4, 2, 4]);
  expect(probeBox(meshes, 0.001)!.counts.reduce((a, b) => a * b)).toBeLessThanOrEqual(8192);
  expect(probeBox([], 1)).toBeNull();
  const box = { min: [0, 0, 0], max: [3, 1, 1], counts: [3, 1, 1] } as const;
  const coefficients = new Float32Array(81).fill(9);
  coefficients.fill(1, 0, 27);
  coefficients.fill(3, 54, 81);
  fillBuriedProbes(box, coefficients, Float32Array.from([0, 0.9, 0]));
  expect([coefficients[0], coefficients[27], coefficients[54]]).toEqual([1, 2, 3]);
});

test('a probe beside a strong light is nowhere darker than dark, and one in soft light is left as it is', () => {
  // spherical harmonics of a small lamp above
  const basis: number[] = [];
  SphericalHarmonics3.getBasisAt(new Vector3(0, 1, 0), basis);
  const lamp = basis.flatMap((value) => [value, 0.5 * value, 0.1 * value]);
  const soft = [3, 3, 3, 0.4, 0.4, 0.4, ...Array.from({ length: 21 }, () => 0)];
  const coefficients = Float32Array.from([...lamp, ...soft]);
  const least = (at: number): number => {
    const harmonics = new SphericalHarmonics3().fromArray([...coefficients.slice(at, at + 27)]);
    const angles = Array.from({ length: 64 }, (_, i) => (i * Math.PI) / 32);
    return Math.min(
      ...angles.map((a) => harmonics.getIrradianceAt(new Vector3(Math.sin(a), Math.cos(a), 0), new Vector3()).x),
    );
  };
  expect(least(0)).toBeLessThan(-0.03);
  dampRinging(coefficients);
  expect(least(0)).toBeGreaterThan(-0.003);
  expect(coefficients[0]).toBeCloseTo(lamp[0], 6);
  expect(coefficients[3]).toBeGreaterThan(0.5 * lamp[3]);
  expect([...coefficients.slice(27)]).toEqual([...Float32Array.from(soft)]);
});
