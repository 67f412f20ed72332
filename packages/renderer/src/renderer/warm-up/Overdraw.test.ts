import {
  BackSide,
  BoxGeometry,
  type Camera,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
} from 'three';
import { expect, it } from 'vitest';
import type { RenderItem } from '../../frame/RenderItem';
import { Overdraw } from './Overdraw';

const material = new MeshStandardMaterial();
const camera = new PerspectiveCamera(90, 1, 0.1, 100);
camera.updateMatrixWorld();

/** A quad before the camera, of many triangles; it fills the picture of an angle of 90°. */
function quad(depth: number, by = material, size = 2 * depth, x = 0): Mesh {
  const mesh = new Mesh(new PlaneGeometry(size, size, 8, 8), by);
  mesh.position.set(x, 0, -depth);
  mesh.updateMatrixWorld();
  return mesh;
}

const item = (object: Mesh, route: RenderItem['route'] = 'split', renderOrder = 0): RenderItem => {
  const { geometry, material, position } = object;
  const order = { groupOrder: 0, renderOrder, materialVariant: 0, id: 0 };
  return { ...order, object, geometry, material, z: -position.z, group: null, route } as unknown as RenderItem;
};

/** Size of the picture (pixels). */
const size = { width: 1280, height: 720 };

function estimate(opaque: readonly RenderItem[], by: Camera = camera): Overdraw {
  const overdraw = new Overdraw(() => {});
  for (let i = 0; i < 9; i++)
    overdraw.follow({ camera: by, ...size, queue: { opaque, cleared: 9, reaches: () => false } });
  return overdraw;
}

const depths = Array.from({ length: 16 }, (_, i) => 20 - i);

it('counts every layer that is drawn from back to front, and none from front to back', () => {
  const layers = depths.map((depth) => item(quad(depth)));
  const { layers: counted, triangles } = estimate(layers);
  expect(counted).toBeGreaterThan(11);
  expect(counted).toBeLessThan(15.1);
  expect(triangles).toBe(16 * 128);
  expect(estimate(layers.toReversed()).layers).toBe(0);
  const flat = new OrthographicCamera(-10, 10, 10, -10, 0.1, 100);
  flat.updateMatrixWorld();
  expect(estimate(layers, flat).layers, 'an orthographic camera').toBeGreaterThan(5);
});

it('counts the part of the picture that is covered twice, and surfaces that face the camera', () => {
  const hall = new Mesh(new BoxGeometry(10, 10, 10, 8, 8, 8), new MeshStandardMaterial({ side: BackSide }));
  hall.updateMatrixWorld();
  const of = (...meshes: Mesh[]) => estimate(meshes.map((mesh) => item(mesh))).layers;
  const whole = of(quad(20), quad(10));
  expect(of(quad(20), quad(10, material, 20, 10)) / whole).toBeCloseTo(0.5, 1);
  expect(of(quad(20), quad(10, material, 1, 500)), 'out of sight').toBe(0);
  expect(of(quad(20), hall), 'from within').toBeGreaterThan(whole / 2);
  (hall.material as MeshStandardMaterial).side = 0;
  expect(of(quad(20), hall), 'its outside').toBe(0);
});

it('leaves out what no depth pre-pass draws, and what has no positions or known bounds', () => {
  const instanced = new InstancedMesh(new BoxGeometry(100, 100, 1), material, 3);
  const empty = new Mesh(undefined, material);
  const freed = quad(10);
  Object.assign(freed.geometry.attributes.position, { array: null });
  const others = [item(quad(10), 'plain'), item(quad(9), 'forward'), item(instanced), item(empty), item(freed)];
  expect(estimate([item(quad(20)), ...others])).toMatchObject({ layers: 0, triangles: 128 + 36 + 128 });
  instanced.setMatrixAt(0, new Matrix4().setPosition(0, 0, -110));
  for (const i of [1, 2]) instanced.setMatrixAt(i, new Matrix4().setPosition(0, 0, -110 - i));
  instanced.computeBoundingSphere();
  expect(estimate([item(quad(300)), item(instanced)]).layers, 'instances, by their sphere').toBeGreaterThan(0.2);
});

it('is made anew every 64 frames, half of it from the one before, and for no more than 1,000 items', () => {
  const overdraw = new Overdraw(() => {});
  const follow = (opaque: readonly RenderItem[], frames: number) => {
    for (let i = 0; i < frames; i++)
      overdraw.follow({ camera, ...size, queue: { opaque, cleared: 9, reaches: () => false } });
    return overdraw.layers;
  };
  const layers = depths.map((depth) => item(quad(depth)));
  expect(follow(layers, 8)).toBe(0);
  const first = follow(layers, 1);
  expect(first).toBeGreaterThan(1);
  expect(follow([], 63)).toBe(first);
  expect(follow([], 1)).toBe(first / 2);
  const many = estimate(Array.from({ length: 1001 }, (_, i) => layers[i % 16]));
  expect(many).toMatchObject({ layers: 0, order: null });
});

it('orders materials so that what hides others is drawn before them', () => {
  const [first, second, third] = [0, 1, 2].map(() => new MeshStandardMaterial());
  const meshes = [quad(10, first), quad(20, second), quad(5, third), quad(6, third)];
  const ordered = (items: RenderItem[]) => {
    const { order } = estimate(items);
    return (
      order &&
      [first, second, third].toSorted((a, b) => order.rankOf(item(quad(1, a))) - order.rankOf(item(quad(1, b))))
    );
  };
  expect(ordered(meshes.map((mesh) => item(mesh)))).toEqual([third, second, first]);
  const steps = meshes.map((mesh, i) => item(mesh, 'split', i));
  expect(ordered(steps), 'where none may change places').toBeNull();
  expect(ordered([item(quad(20, first)), item(quad(10, second, 1, 4))]), 'little to save').toBeNull();
  expect(ordered([item(quad(10, first)), item(quad(20, second))]), "three's order is as good").toBeNull();
  expect(ordered([item(quad(20, second)), item(quad(10, first))]), "the host's order").toBeNull();
  const small = new Overdraw(() => {});
  for (let i = 0; i < 9; i++) {
    small.follow({
      camera,
      width: 80,
      height: 45,
      queue: { opaque: meshes.map((mesh) => item(mesh)), cleared: 9, reaches: () => false },
    });
  }
  expect(small.order, 'few pixels').toBeNull();
  const changing = Array.from({ length: 65 }, (_, i) => item(quad(5 + i, [first, second][i % 2])));
  expect(ordered(changing), 'too many changes of material').toBeNull();
  expect(estimate(changing.toReversed()).layers, 'which are counted all the same').toBeGreaterThan(30);
});
