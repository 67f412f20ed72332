import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import {
  BoxGeometry,
  Group,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  SphereGeometry,
  type WebGLRenderer,
} from 'three';
import { expect, it } from 'vitest';
import { builtinMicroShaders } from '../../../authoring/builtinMicroShaders';
import { MicroShaderRegistry } from '../../../microshaders';
import { addMicroShaders } from '../../../microshaders/addMicroShaders';
import type { Caster } from '../Caster';
import { ShadowCasters } from '../ShadowCasters';
import { mergedCaster, mergedCasterDepth } from '.';
import { MergedCasters } from './MergedCasters';

setFlagsFromString('--expose_gc');
const collect = runInNewContext('gc') as () => void;

/** The parts of a WebGLRenderer that merging, without draws, uses. */
const webgl = {
  getContext: () => ({ MAX_UNIFORM_BUFFER_BINDINGS: 0, MAX_UNIFORM_BLOCK_SIZE: 1, getParameter: () => 65_536 }),
} as unknown as WebGLRenderer;

const registry = new MicroShaderRegistry();
registry.add(builtinMicroShaders);
addMicroShaders(registry, 'shadows', { mergedCaster, mergedCasterDepth });

/** A scene of casters, and the MergedCasters that merges them. */
class Bench {
  readonly root = new Group();
  readonly merged = new MergedCasters(webgl, registry);
  readonly loose: Caster[] = [];
  private readonly casters = new ShadowCasters();
  private readonly camera = new PerspectiveCamera();

  add(geometry: BoxGeometry | SphereGeometry, material: MeshStandardMaterial): Mesh {
    const mesh = new Mesh(geometry, material);
    mesh.castShadow = true;
    this.root.add(mesh);
    return mesh;
  }

  draw(): void {
    this.root.updateMatrixWorld();
    this.casters.update(this.root, this.camera, false);
    this.loose.length = 0;
    this.merged.begin(this.camera, this.casters, this.loose);
  }

  /** Number of vertices and indices that fit in the buffers, and number of pages. */
  get room(): { vertices: number; pages: number } {
    const proxies: Mesh[] = [];
    this.merged.addProxies(proxies);
    const counts = proxies.map(({ geometry }) => geometry.attributes.position.count);
    return { vertices: counts.reduce((sum, count) => sum + count, 0), pages: counts.length };
  }
}

it.each([
  ['of few triangles', new BoxGeometry()],
  ['of many', new SphereGeometry(1, 64, 48)],
])('casters %s that come and go 500 times leave nothing behind', async (_, geometry) => {
  const bench = new Bench();
  const material = new MeshStandardMaterial();
  for (let i = 0; i < 8; i++) bench.add(geometry, material);
  bench.draw();
  const gone: WeakRef<Mesh>[] = [];
  const edit = (): void => {
    const copy = bench.add(geometry, material);
    bench.draw();
    bench.root.remove(copy);
    bench.draw();
    gone.push(new WeakRef(copy));
  };
  for (let i = 0; i < 50; i++) edit();
  const before = bench.room;
  for (let i = 0; i < 450; i++) edit();
  // weak references are cleared only between tasks
  await new Promise((resolve) => setImmediate(resolve));
  collect();
  const alive = gone.filter((each) => each.deref() !== undefined).length;
  expect(alive).toBeLessThan(100);
  expect(bench.room.vertices).toBeLessThanOrEqual(2 * before.vertices);
  expect(bench.room.pages).toBeLessThanOrEqual(before.pages + 1);
  // the remaining casters are still merged
  bench.draw();
  expect(bench.loose).toEqual([]);
});

it('casters that are hidden for a while are merged as before when they are back', () => {
  const bench = new Bench();
  const material = new MeshStandardMaterial();
  const geometry = new BoxGeometry();
  const all = Array.from({ length: 150 }, () => bench.add(geometry, material));
  bench.draw();
  const { vertices } = bench.room;
  for (let i = 0; i < 100; i++) {
    for (const mesh of all.slice(20)) mesh.visible = i % 4 === 0;
    bench.draw();
  }
  for (const mesh of all) mesh.visible = true;
  bench.draw();
  expect(bench.room.vertices).toBe(vertices);
  expect(bench.loose).toEqual([]);
});
