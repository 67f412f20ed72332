import { type BufferGeometry, PlaneGeometry } from 'three';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { Slices } from '../base/Slices';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { computeCreaseNormals } from '../geometry/computeCreaseNormals';
import { AssetLibrary } from './AssetLibrary';
import { MeshNormals } from './MeshNormals';

/** 101,400 corners without normals: too many for a single slice. */
function largePlane(): BufferGeometry {
  const plane = new PlaneGeometry(1, 1, 130, 130);
  plane.deleteAttribute('normal');
  return plane;
}

const library = (): AssetLibrary => new AssetLibrary().register('field', largePlane());

/** Number of times that the work has yielded to the page. */
let turns = 0;

// ends a slice after each step, on machines of any speed
beforeEach(() => {
  turns = 0;
  vi.spyOn(Slices.prototype, 'areOver', 'get').mockReturnValue(true);
  const { next } = Slices.prototype;
  vi.spyOn(Slices.prototype, 'next').mockImplementation(function (this: Slices) {
    turns++;
    return next.call(this);
  });
});
afterEach(() => {
  vi.restoreAllMocks();
});

it('are those of one go, and the page has its turn meanwhile', async () => {
  const plane = largePlane();
  const normals = new MeshNormals();
  expect(normals.isReady(plane, 0.5)).toBe(false);
  const [copy, same] = await Promise.all([normals.prepare(plane, 0.5), normals.prepare(plane, 0.5)]);
  expect(turns).toBeGreaterThan(50);
  expect(same).toBe(copy);
  expect(normals.get(plane, 0.5)).toBe(copy);
  const direct = computeCreaseNormals(plane, 0.5);
  const arraysOf = ({ attributes, index }: BufferGeometry): ArrayLike<number>[] =>
    [attributes.position, attributes.normal, attributes.uv, index!].map(({ array }) => array);
  const [copied, made] = [arraysOf(copy), arraysOf(direct)];
  expect(copied.map(({ length }) => length)).toEqual(made.map(({ length }) => length));
  for (const [k, array] of copied.entries())
    expect(Array.from(array).every((each, i) => each === made[k][i])).toBe(true);
});

it('are computed no further once nobody waits for them', async () => {
  const plane = largePlane();
  const normals = new MeshNormals();
  const [one, other] = [new AbortController(), new AbortController()];
  const waiting = [one, other].map(({ signal }) => normals.prepare(plane, 0.5, signal));
  const ends = waiting.map((promise) => promise.then(String, ({ name }: Error) => name));
  one.abort();
  expect(await ends[0]).toBe('AbortError');
  const before = turns;
  await vi.waitUntil(() => turns > before + 3);
  other.abort();
  expect(await ends[1]).toBe('AbortError');
  await normals.settled();
  const after = turns;
  expect(after).toBeLessThan(50);
  expect(normals.isReady(plane, 0.5)).toBe(false);
  // a new request starts the computation again
  await normals.prepare(plane, 0.5);
  expect(turns).toBeGreaterThan(after + 50);
});

it('of an object come later; with another crease angle it keeps its shape meanwhile', async () => {
  const assets = library();
  const scene = new Scene({ assets });
  const object = new GameObject('Field');
  const renderer = object.addComponent(ObjectRenderer, { mesh: 'field', creaseAngle: 0.5 });
  scene.add(object);
  expect(renderer.three).toBeNull();
  await assets.meshesPrepared();
  const first = renderer.geometry;
  expect(first).toBe(assets.mesh('field', 0.5));
  for (const angle of [0.6, 0.7, 0.8]) renderer.creaseAngle = angle;
  expect(renderer.geometry).toBe(first);
  await assets.meshesPrepared();
  expect(renderer.geometry).toBe(assets.mesh('field', 0.8));
  expect(assets.isMeshReady('field', 0.7)).toBe(false);
  renderer.creaseAngle = 0.9;
  scene.dispose();
  await assets.meshesPrepared();
  expect(assets.isMeshReady('field', 0.9)).toBe(false);
});

it('are there once a scene is opened, which can be cancelled', async () => {
  const assets = library();
  const scene = new Scene({ assets });
  const object = new GameObject('Field');
  object.addComponent(ObjectRenderer, { mesh: 'field' });
  scene.add(object);
  const file = JSON.stringify(serialize(scene));
  scene.dispose();
  await assets.meshesPrepared();

  const control = new AbortController();
  const opening = deserialize(file, { assets, signal: control.signal });
  const end = opening.then(String, ({ name }: Error) => name);
  const before = turns;
  await vi.waitUntil(() => turns > before + 3);
  control.abort();
  expect(await end).toBe('AbortError');
  await assets.meshesPrepared();
  expect(assets.isMeshReady('field')).toBe(false);
  await expect(deserialize(file, { assets, signal: control.signal })).rejects.toThrow(/abort/i);

  const opened = await deserialize(file, { assets });
  expect(opened.find('Field')!.getComponent(ObjectRenderer)!.geometry!.hasAttribute('normal')).toBe(true);
});
