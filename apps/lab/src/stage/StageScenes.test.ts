import {
  Camera,
  type ComponentClass,
  GameObject,
  Light as LightComponent,
  ObjectRenderer,
  RandomMovement,
  Scene,
} from '@farol/engine';
import { serialize } from '@farol/engine/files';
import { LightField } from '@farol/renderer/light-field';
import {
  InstancedMesh,
  Mesh,
  type MeshStandardMaterial,
  type Object3D,
  PointLight,
  type RectAreaLight,
  SpotLight,
  type Texture,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { type LabCase, plainCase } from '../plan/LabPlan';
import { type OwnedScene, StageScenes } from './StageScenes';

const scenes = new StageScenes();

const planes = (changes: Partial<LabCase> = {}): LabCase => ({
  ...plainCase,
  ...{ scene: { name: 'benchmarkLights', parameters: { n: 3 } }, lights: 9, shadows: 0, overdraw: 0 },
  ...{ width: 160, height: 90 },
  ...changes,
});
const named = (name: string, changes: Partial<LabCase> = {}): LabCase =>
  planes({ scene: { name, parameters: {} }, ...changes });

const meshesOf = ({ three }: OwnedScene): Mesh[] => three.children.filter((child) => child instanceof Mesh);
const places = ({ lights }: OwnedScene): number[][] => lights.map(({ position }) => position.toArray());

/** The scene as the engine's file, as bytes. */
const bytesOf = (scene: Scene): Uint8Array => new TextEncoder().encode(JSON.stringify(serialize(scene)));

describe('StageScenes', () => {
  it('makes planes, lights and nothing that shows where lights are', async () => {
    const scene = await scenes.build(planes({ width: 200, height: 100 }));
    expect(meshesOf(scene)).toHaveLength(9);
    expect(meshesOf(scene).some((mesh) => mesh instanceof InstancedMesh)).toBe(false);
    expect(scene.lights).toHaveLength(9);
    expect(scene.still.map(({ type }) => type)).toEqual(['AmbientLight']);
    const { elements } = scene.camera.projectionMatrix;
    expect(elements[0]).toBeCloseTo(elements[5] / 2);
  });

  it('gives every competitor the same, and objects of its own', async () => {
    const [a, b] = [await scenes.build(planes()), await scenes.build(planes())];
    a.setTime(1.3);
    b.setTime(0.2);
    expect(places(a)).not.toEqual(places(b));
    b.setTime(1.3);
    expect(places(a)).toEqual(places(b));
    const [one, other] = [meshesOf(a)[4], meshesOf(b)[4]];
    expect(one.matrix).toEqual(other.matrix);
    expect(one.geometry).not.toBe(other.geometry);
    expect(one.material).not.toBe(other.material);
    expect(one.geometry.attributes.position.array).toBe(other.geometry.attributes.position.array);
  });

  it('makes exactly as many lights as are asked for', async () => {
    for (const lights of [0, 1, 10, 16]) expect((await scenes.build(planes({ lights }))).lights).toHaveLength(lights);
    expect((await scenes.build(named('sponza', { lights: 7 }))).lights).toHaveLength(7);
  });

  it('keeps the other lights of a scene, in the world', async () => {
    const { still, three } = await scenes.build(named('temple', { lights: 4 }));
    const count = (type: string) => still.filter((light) => light.type === type).length;
    expect(['DirectionalLight', 'HemisphereLight', 'SpotLight'].map(count)).toEqual([1, 1, 6]);
    // three reads the sky's direction from the position of a hemisphere light
    expect(still.find(({ type }) => type === 'HemisphereLight')!.position.toArray()).toEqual([0, 1, 0]);
    three.updateMatrixWorld();
    const spot = still.find(({ type }) => type === 'SpotLight') as unknown as { target: Object3D };
    expect(spot.target.parent).toBe(three);
  });

  it('has the first lights cast shadows, all meshes taking part', async () => {
    const scene = await scenes.build(named('sponza', { lights: 5, shadows: 2 }));
    expect(scene.lights.map(({ castShadow }) => castShadow)).toEqual([true, true, false, false, false]);
    expect((scene.lights[0] as PointLight).shadow.mapSize.toArray()).toEqual([512, 512]);
    expect(meshesOf(scene).every(({ castShadow, receiveShadow }) => castShadow && receiveShadow)).toBe(true);
  });

  it('adds lights beside those that are there, and takes them away', async () => {
    const scene = await scenes.build(planes());
    scene.setTime(2);
    const before = places(scene);
    const remove = scene.addLights(10);
    scene.setTime(2);
    expect(scene.lights).toHaveLength(19);
    expect(places(scene).slice(0, 9)).toEqual(before);
    for (const { position, parent } of scene.lights.slice(9)) {
      expect(parent).toBe(scene.three);
      expect(Math.min(...before.map((place) => position.distanceTo(new Vector3(...place))))).toBeCloseTo(
        0.3 * 2 ** 0.5,
      );
    }
    remove();
    scene.setTime(2);
    expect(places(scene)).toEqual(before);
    expect(scene.three.children.filter((child) => child instanceof PointLight)).toHaveLength(9);
  });

  it('adds lights where there is none', async () => {
    const scene = await scenes.build(planes({ lights: 0 }));
    scene.addLights(10);
    scene.setTime(1);
    expect(scene.lights).toHaveLength(10);
    for (const { position } of scene.lights) expect(position.clone().project(scene.camera).z).toBeLessThan(1);
  });

  it('covers the picture by layers that are drawn from back to front', async () => {
    const scene = await scenes.build(planes({ overdraw: 4 }));
    const layers = meshesOf(scene).filter(({ name }) => name.startsWith('Layer'));
    expect(layers).toHaveLength(4);
    scene.three.updateMatrixWorld();
    const depths = layers.map((layer) => {
      layer.geometry.computeBoundingBox();
      const { min, max } = layer.geometry.boundingBox!;
      const corners = [min.x, max.x].flatMap((x) => [min.y, max.y].map((y) => new Vector3(x, y, 0)));
      const seen = corners.map((corner) => layer.localToWorld(corner).project(scene.camera));
      for (const { x, y } of seen) expect(Math.min(Math.abs(x), Math.abs(y))).toBeGreaterThan(1);
      return seen[0].z;
    });
    const orders = layers.map(({ renderOrder }) => renderOrder);
    expect(orders).toEqual([...orders].sort((a, b) => a - b));
    expect(orders.at(-1)).toBeLessThan(0);
    expect(depths).toEqual([...depths].sort((a, b) => b - a));
  });

  it('takes the scene of a file, whose lights the engine moves', async () => {
    const made = new Scene({ name: 'Mine' });
    const add = (name: string, ...parts: [ComponentClass, Record<string, unknown>?][]) => {
      const object = new GameObject(name);
      for (const part of parts) object.addComponent(part[0], part[1] as never);
      made.add(object);
      return object;
    };
    add('Camera', [Camera]).transform.position = [0, 1, 5];
    add('Box', [ObjectRenderer, { mesh: 'box' }], [RandomMovement, { speed: 2 }]);
    add('Rock', [ObjectRenderer, { mesh: 'sphere' }]);
    add('Lamp', [LightComponent, { castShadow: true, shadowMapSize: 256 }], [RandomMovement, {}]);
    add('Fixed', [LightComponent, { attenuation: 'near-far', far: 4 }]);
    const own = new StageScenes({ makeRenderer: () => null });
    own.setOwn(bytesOf(made));
    const scene = await own.build(named('own', { lights: null }));
    expect(scene.lights).toHaveLength(2);
    expect((scene.lights[0] as PointLight).shadow.mapSize.x).toBe(256);
    expect(scene.lights[1].userData.farol).toBeUndefined();
    scene.setTime(1.5);
    scene.three.updateMatrixWorld();
    const [lamp, box] = ['Lamp', 'Box'].map((name) => made.find(name)!.object3D);
    made.setTime(1.5);
    expect(scene.lights[0].position.distanceTo(lamp.position)).toBeCloseTo(0);
    const place = new Vector3().setFromMatrixPosition(meshesOf(scene)[0].matrixWorld);
    expect(place.distanceTo(box.position)).toBeCloseTo(0);
    expect(place.length()).toBeGreaterThan(0.01);
    // objects that do not move are not updated
    scene.setTime(2);
    expect(meshesOf(scene).map(({ matrixWorldNeedsUpdate }) => matrixWorldNeedsUpdate)).toEqual([true, false]);
  });

  it('makes of the point lights spots and rectangles that shine down from the same places', async () => {
    const points = await scenes.build(planes({ lightRange: 2 }));
    expect(points.lights.map((light) => (light as PointLight).distance)).toEqual(Array(9).fill(2));
    for (const kind of ['spots', 'rectangles'] as const) {
      const scene = await scenes.build(planes({ lightKind: kind, lightRange: 2 }));
      for (const each of [points, scene]) each.setTime(1.7);
      expect(places(scene)).toEqual(places(points));
      scene.three.updateMatrixWorld();
      for (const [i, light] of scene.lights.entries()) {
        const { intensity } = points.lights[i];
        if (light instanceof SpotLight) {
          const target = new Vector3().setFromMatrixPosition(light.target.matrixWorld);
          expect(target.sub(light.position).toArray()).toEqual([0, -1, 0].map((part) => expect.closeTo(part)));
          expect([light.intensity, light.distance]).toEqual([intensity, 2]);
        } else {
          const { width, height, userData } = light as RectAreaLight;
          const ahead = new Vector3(0, 0, -1).transformDirection(light.matrixWorld);
          expect(ahead.toArray()).toEqual([0, -1, 0].map((part) => expect.closeTo(part)));
          expect(light.intensity * width * height).toBeCloseTo(intensity);
          expect(userData.farol).toEqual({ range: 2 });
        }
      }
      const remove = scene.addLights(10);
      expect(scene.lights.map(({ type }) => type)).toEqual(Array(19).fill(scene.lights[0].type));
      remove();
      expect(scene.lights).toHaveLength(9);
    }
  });

  it('gives points the three profiles in turns, each scene its own copies', async () => {
    const [a, b] = [
      await scenes.build(planes({ lightKind: 'profiles' })),
      await scenes.build(planes({ lightKind: 'profiles' })),
    ];
    const profilesOf = ({ lights }: OwnedScene) => lights.map(({ userData }) => userData.farolProfile as Texture);
    const own = profilesOf(a);
    expect(new Set(own).size).toBe(3);
    expect(own[3]).toBe(own[0]);
    expect(profilesOf(b)).not.toContain(own[0]);
  });

  it('has the same lights as a LightField: colours, reaches and places at any time', async () => {
    const points = await scenes.build(planes({ lightRange: 3 }));
    const scene = await scenes.build(planes({ lightKind: 'field', lightRange: 3 }));
    expect(scene.lights).toEqual([]);
    const field = scene.three.children.find((child) => child instanceof LightField)!;
    const check = () => {
      expect(field.count).toBe(points.lights.length);
      points.lights.forEach((light, i) => {
        const { position, color, intensity, decay } = light as PointLight;
        const sphere = [...position.toArray(), 3].map((part) => expect.closeTo(part, 4));
        expect([...field.spheres.array.slice(i * 4, i * 4 + 4)]).toEqual(sphere);
        const emission = [...color.toArray().map((part) => part * intensity), decay].map((part) =>
          expect.closeTo(part, 4),
        );
        expect([...field.emissions.array.slice(i * 4, i * 4 + 4)]).toEqual(emission);
      });
    };
    for (const each of [points, scene]) each.setTime(2.3);
    check();
    const removes = [points, scene].map((each) => each.addLights(10));
    for (const each of [points, scene]) each.setTime(0.7);
    check();
    removes.forEach((remove) => remove());
    check();
  });

  it('has as many particles as lights, none of which is ever missing', async () => {
    const scene = await scenes.build(named('sponza', { lights: 40, lightKind: 'particles', lightRange: 2 }));
    expect(scene.lights).toEqual([]);
    const { emitter } = scene;
    expect(emitter!.parent).toBe(scene.three);
    const { capacity, lightEvery, lightRange, rate, life, prewarm } = emitter!.settings;
    expect({ capacity, lightEvery, lightRange }).toEqual({ capacity: 40, lightEvery: 1, lightRange: 2 });
    expect(rate * life[0]).toBe(40);
    expect(prewarm).toBe(life[0]);
    scene.setTime(0.5);
    expect(emitter!.time).toBeCloseTo(0.5);
    // the stage resets its clock after the picture was drawn
    scene.setTime(0.1);
    scene.setTime(0.2);
    expect(emitter!.time).toBeCloseTo(0.6);
  });

  it('shades all materials by name, flat for three too', async () => {
    const shaded = async (shading: LabCase['shading']) =>
      meshesOf(await scenes.build(named('sponza', { lights: 1, shading }))).map(({ material }) => {
        const { flatShading, userData } = material as MeshStandardMaterial;
        return [flatShading, (userData.farol as { shading?: string } | undefined)?.shading];
      });
    const [[isFlat, own]] = await shaded('own');
    expect([isFlat, own]).toEqual([false, undefined]);
    for (const shading of ['flat', 'gouraud', 'phong'] as const) {
      const all = await shaded(shading);
      expect(all).toEqual(all.map(() => [shading === 'flat', shading]));
    }
  });

  it('says what is wrong', async () => {
    await expect(scenes.build(named('nowhere'))).rejects.toThrow('no scene ‘nowhere’: choose one of temple');
    await expect(new StageScenes().build(named('own', { lights: null }))).rejects.toThrow('No scene was handed over');
    const own = new StageScenes({ makeRenderer: () => null });
    own.setOwn(bytesOf(new Scene({ name: 'Dark' })));
    await expect(own.build(named('own', { lights: null }))).rejects.toThrow('‘Dark’ has no camera');
    own.setOwn(new Uint8Array());
    await expect(own.build(named('own', { lights: null }))).rejects.toThrow('The file is empty');
  });
});
