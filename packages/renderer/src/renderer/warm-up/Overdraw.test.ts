import {
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
import { byOctave, Overdraw } from './Overdraw';

const material = new MeshStandardMaterial();
const camera = new PerspectiveCamera(60, 16 / 9, 0.1, 100);
camera.updateMatrixWorld();

/** A quad of a size at a depth, in front of the camera. */
function quad(depth: number, size = 1000, x = 0): Mesh {
  const mesh = new Mesh(new PlaneGeometry(size, size), material);
  mesh.position.set(x, 0, -depth);
  mesh.updateMatrixWorld();
  return mesh;
}

const order = { groupOrder: 0, renderOrder: 0, materialVariant: 0, id: 0 };
const item = (object: Mesh, route: RenderItem['route'] = 'split'): RenderItem => {
  const { geometry, material, position } = object;
  return { ...order, object, geometry, material, z: -position.z, group: null, route } as unknown as RenderItem;
};

/** A frame of 100 × 100 pixels. */
const frameOf = (opaque: readonly RenderItem[], by: Camera = camera, nearFirst = false) => ({
  ...{ camera: by, width: 100, height: 100 },
  queue: { opaque, order: nearFirst ? byOctave : null },
});

function estimate(items: readonly RenderItem[], by?: Camera, nearFirst?: boolean): Overdraw {
  const overdraw = new Overdraw();
  overdraw.follow(frameOf(items, by, nearFirst));
  return overdraw;
}

const depths = Array.from({ length: 16 }, (_, i) => 20 - i);

it('counts every layer that is drawn from back to front, and none from front to back', () => {
  const layers = depths.map((depth) => item(quad(depth)));
  expect(estimate(layers)).toMatchObject({ layers: 15, triangles: 32 });
  expect(estimate(layers.toReversed()).layers).toBe(0);
  const flat = new OrthographicCamera(-10, 10, 10, -10, 0.1, 100);
  flat.updateMatrixWorld();
  expect(estimate(layers, flat).layers, 'an orthographic camera').toBe(15);
});

it('counts the part of the picture that is covered twice', () => {
  const { x: half } = camera.position.clone().set(1, 0, 0).unproject(camera);
  const right = 10 * (half / 0.1);
  const layers = [item(quad(20)), item(quad(10, 2 * right, right))];
  expect(estimate(layers).layers).toBeCloseTo(0.5, 1);
  expect(estimate([item(quad(20)), item(quad(10, 1, 500))]).layers, 'out of sight').toBe(0);
});

it('leaves out what no depth pre-pass draws, and what has no positions or known bounds', () => {
  const instanced = new InstancedMesh(new BoxGeometry(100, 100, 1), material, 3);
  const empty = new Mesh(undefined, material);
  const freed = quad(10);
  Object.assign(freed.geometry.attributes.position, { array: null });
  const others = [item(quad(10), 'plain'), item(quad(9), 'forward'), item(instanced), item(empty), item(freed)];
  expect(estimate([item(quad(20)), ...others])).toMatchObject({ layers: 0, triangles: 2 + 36 + 2 });
  instanced.setMatrixAt(0, new Matrix4().setPosition(0, 0, -110));
  for (const i of [1, 2]) instanced.setMatrixAt(i, new Matrix4().setPosition(0, 0, -110 - i));
  instanced.computeBoundingSphere();
  expect(estimate([item(quad(200)), item(instanced)]).layers, 'instances, by their sphere').toBeGreaterThan(0.5);
});

it('takes a box that reaches behind the camera to cover the picture', () => {
  const hall = new Mesh(new BoxGeometry(10, 10, 10), material);
  hall.updateMatrixWorld();
  expect(estimate([item(quad(20)), item(hall)]).layers).toBe(1);
});

it('is made anew every 32 frames, half of it from the one before, and for no more than 1,000 items', () => {
  const overdraw = new Overdraw();
  const follow = (items: readonly RenderItem[], frames: number) => {
    for (let i = 0; i < frames; i++) overdraw.follow(frameOf(items));
    return overdraw.layers;
  };
  const layers = depths.map((depth) => item(quad(depth)));
  expect(follow(layers, 1)).toBe(15);
  expect(follow([], 31)).toBe(15);
  expect(follow([], 1)).toBe(7.5);
  expect(estimate(Array.from({ length: 1001 }, (_, i) => layers[i % 16])).layers).toBe(0);
});

it('finds whether drawing front to back spares more than its changes of material cost', () => {
  const [first, second] = [new MeshStandardMaterial(), new MeshStandardMaterial()];
  const layer = (depth: number, by: MeshStandardMaterial) => Object.assign(item(quad(depth)), { material: by });
  const [near, middle, far] = [layer(3, second), layer(6, first), layer(12, second)];
  // front to back costs one more change of material (4,000 pixels), and hides a layer (10,000 pixels)
  const asThree = [middle, near, far];
  expect(estimate(asThree)).toMatchObject({ layers: 1, order: byOctave });
  expect(estimate([near, middle, far], camera, true), 'once it is done').toMatchObject({ layers: 0, order: byOctave });
  expect(estimate([near, far], camera), 'one material').toMatchObject({ order: null });
  const small = new Overdraw();
  small.follow({ ...frameOf(asThree), width: 30 });
  expect(small.order, 'few pixels').toBeNull();
  const many = Array.from({ length: 1001 }, (_, i) => layer(3 * 2 ** (i % 3), i % 2 ? first : second));
  expect(estimate(many).order, 'many items').toBeNull();
});
