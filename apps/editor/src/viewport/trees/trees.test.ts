import { createRandom, GameObject, ObjectRenderer, Scene } from '@farol/engine';
import {
  BackSide,
  BufferAttribute,
  type BufferGeometry,
  DoubleSide,
  InstancedMesh,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  type Intersection,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Ray,
  Raycaster,
  SphereGeometry,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { vertexBesideRay } from '../handles/vertexBesideRay';
import { castByTree, castMesh } from './castByTree';
import { LARGE, treeOf, treeReady } from './meshTrees';

/** A sphere with bumps, of 65,000 triangles. */
function ball(): SphereGeometry {
  const geometry = new SphereGeometry(1, 200, 164);
  const position = geometry.getAttribute('position') as BufferAttribute;
  const random = createRandom(5);
  const point = new Vector3();
  for (let i = 0; i < position.count; i++) {
    point.fromBufferAttribute(position, i).multiplyScalar(1 + 0.01 * random());
    position.setXYZ(i, point.x, point.y, point.z);
  }
  return geometry;
}

const single = new MeshBasicMaterial();

/** The properties of hits that are compared, by distance. */
const facts = (hits: Intersection[]): unknown[] =>
  hits
    .toSorted((a, b) => a.distance - b.distance || a.faceIndex! - b.faceIndex!)
    .map(({ distance, point, face, faceIndex, object, instanceId }) => ({
      distance: distance.toFixed(5),
      point: point.toArray().map((each) => (Math.round(each * 1e5) / 1e5 + 0).toFixed(5)),
      corners: [face!.a, face!.b, face!.c, face!.materialIndex],
      ...{ faceIndex, object: object.id, instanceId },
    }));

/** Compares trees with three's raycasting for rays around a mesh. @returns number of rays that hit */
async function agrees(mesh: Mesh): Promise<number> {
  mesh.updateMatrixWorld();
  await treeReady(mesh.geometry);
  expect(treeOf(mesh.geometry)).not.toBeNull();
  const random = createRandom(3);
  const raycaster = new Raycaster();
  const aim = new Vector3();
  const next = (): number => 2 * random() - 1;
  let count = 0;
  for (let i = 0; i < 60; i++) {
    raycaster.ray.origin.set(next(), next(), next()).normalize().multiplyScalar(9);
    aim.set(2 * next(), 2 * next(), 2 * next());
    raycaster.ray.direction.copy(aim.sub(raycaster.ray.origin)).normalize();
    const hits: Intersection[] = [];
    expect(castByTree(mesh, raycaster, hits)).toBe(true);
    expect(facts(hits)).toEqual(facts(raycaster.intersectObject(mesh, false)));
    if (hits.length > 0) count++;
  }
  return count;
}

describe('a tree of triangles', () => {
  it('is hit where three hits the mesh: turned, scaled, seen from one side or both', async () => {
    const geometry = ball();
    const [index, position] = [geometry.index!.array.slice(), geometry.getAttribute('position').array.slice()];
    for (const side of [single.side, BackSide, DoubleSide]) {
      const mesh = new Mesh(geometry, new MeshBasicMaterial({ side }));
      mesh.position.set(0.3, -0.5, 0.2);
      mesh.rotation.set(0.3, 1.2, 2);
      mesh.scale.set(2, 0.7, 1.4);
      expect(await agrees(mesh)).toBeGreaterThan(10);
    }
    // the geometry is unchanged
    expect(geometry.index!.array).toEqual(index);
    expect(geometry.getAttribute('position').array).toEqual(position);
  });

  it('knows groups of materials, meshes without an index, interleaved and quantized positions', async () => {
    const grouped = ball();
    grouped.addGroup(0, 60_000, 0);
    grouped.addGroup(60_000, grouped.index!.count - 60_000, 1);
    expect(await agrees(new Mesh(grouped, [single, new MeshBasicMaterial({ side: BackSide })]))).toBeGreaterThan(10);
    expect(await agrees(new Mesh(ball().toNonIndexed(), single))).toBeGreaterThan(10);
    const packed = ball();
    const { array, count } = packed.getAttribute('position');
    const words = new Int16Array(count * 4);
    for (let i = 0; i < count; i++) for (let k = 0; k < 3; k++) words[4 * i + k] = (array[3 * i + k] / 1.1) * 32767;
    packed.setAttribute('position', new InterleavedBufferAttribute(new InterleavedBuffer(words, 4), 3, 0, true));
    expect(await agrees(new Mesh(packed, single))).toBeGreaterThan(10);
  });

  it('is hit in each instance, as three hits them', async () => {
    const mesh = new InstancedMesh(ball(), single, 3);
    for (let i = 0; i < 3; i++) mesh.setMatrixAt(i, new Matrix4().makeTranslation(2 * i - 2, 0.3 * i, 0));
    expect(await agrees(mesh)).toBeGreaterThan(15);
  });

  it('is there for large rigid meshes alone, and grows anew when they are edited', async () => {
    const small = new SphereGeometry();
    expect(treeOf(small)).toBeNull();
    const raycaster = new Raycaster(new Vector3(0, 0, 5), new Vector3(0, 0, -1));
    expect(castByTree(new Mesh(small, single), raycaster, [])).toBe(false);
    const geometry = ball();
    expect(geometry.index!.count / 3).toBeGreaterThan(LARGE);
    const mesh = new Mesh(geometry, single);
    const nearest = (): number => {
      const hits: Intersection[] = [];
      castMesh(mesh, raycaster, hits);
      return Math.min(...hits.map(({ distance }) => distance));
    };
    // three tests the triangles until the tree is built
    expect(castByTree(mesh, raycaster, [])).toBe(false);
    const before = nearest();
    await treeReady(geometry);
    expect(nearest()).toBeCloseTo(before, 6);
    geometry.translate(0, 0, 1);
    geometry.getAttribute('position').needsUpdate = true;
    expect(castByTree(mesh, raycaster, [])).toBe(false);
    await treeReady(geometry);
    expect(castByTree(mesh, raycaster, [])).toBe(true);
    expect(nearest()).toBeCloseTo(before - 1, 6);
    geometry.morphAttributes.position = [geometry.getAttribute('position') as BufferAttribute];
    expect(castByTree(new Mesh(geometry, single), raycaster, [])).toBe(false);
  });

  it('gives the vertex beside a ray that all vertices give', async () => {
    const scene = new Scene();
    const geometry = ball();
    scene.assets.register('ball', geometry);
    const object = new GameObject('Ball');
    object.addComponent(ObjectRenderer, { mesh: 'ball' });
    object.transform.scale = [2, 1, 1];
    scene.add(object);
    scene.three.updateMatrixWorld();
    const drawn = object.getComponent(ObjectRenderer)!.geometry as BufferGeometry;
    const camera = new PerspectiveCamera();
    const random = createRandom(9);
    const rays = Array.from({ length: 20 }, () => {
      const aim = new Vector3(4.4 * random() - 2.2, 2.2 * random() - 1.1, 0);
      const eye = new Vector3(0, 0, 5);
      return new Ray(eye, aim.sub(eye).normalize());
    });
    const find = (): unknown[] =>
      rays.map((ray) => vertexBesideRay(scene, ray, camera, new Set(), 6)?.toArray() ?? null);
    // the first call starts building the tree, and tests all vertices itself
    const all = find();
    expect(all.filter(Boolean).length).toBeGreaterThan(5);
    await treeReady(drawn);
    expect(treeOf(drawn)).not.toBeNull();
    expect(find()).toEqual(all);
    scene.dispose();
  });
});
