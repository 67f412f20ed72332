import { type ComponentClass, Decal, GameObject, Light, ObjectRenderer, Room, Scene, Wall } from '@farol/engine';
import { Box3, PerspectiveCamera, Ray, Vector2, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { boundsOf } from '../boundsOf';
import { land, type LandingView } from './land';
import { surfacesAlong } from './surfaces';

type Triple = [number, number, number];

const CENTRE = new Vector2();

function mesh(scene: Scene | null, position: Triple, scale: Triple = [1, 1, 1], shape = 'box'): GameObject {
  const object = new GameObject(shape);
  object.addComponent(ObjectRenderer, { mesh: shape });
  object.transform.position = position;
  object.transform.scale = scale;
  scene?.add(object);
  return object;
}

/** View of a scene from an eye towards a target. */
function viewOf(scene: Scene, eye: Triple, target: Triple): LandingView {
  const camera = new PerspectiveCamera(50, 1.5, 0.1, 1000);
  camera.position.fromArray(eye);
  camera.lookAt(new Vector3(...target));
  camera.updateMatrixWorld();
  return { scene, camera, target: new Vector3(...target), step: 0.001 };
}

/** Places an object and adds it to the scene. */
function place(view: LandingView, object: GameObject, point = CENTRE): Box3 {
  land(view, [object], point);
  view.scene.add(object);
  view.scene.three.updateMatrixWorld();
  return boundsOf([object]);
}

const light = (type: string): GameObject => {
  const object = new GameObject('Light');
  object.addComponent(Light, { type });
  return object;
};

/** A new object with a room or a wall. */
function building(type: ComponentClass, values = {}): GameObject {
  const object = new GameObject(type.typeName);
  object.addComponent(type, values);
  object.addComponent(ObjectRenderer, { mesh: null });
  return object;
}

/** Share of surface points of an object, on a grid over its box, that are visible from the eye. */
function shareSeen({ scene, camera }: LandingView, object: GameObject): number {
  const box = boundsOf([object]);
  const size = box.getSize(new Vector3());
  const eye = new Vector3().setFromMatrixPosition(camera.matrixWorld);
  let [seen, hits] = [0, 0];
  for (let i = 0; i < 343; i++) {
    const at = new Vector3((i % 7) / 6, (Math.floor(i / 7) % 7) / 6, Math.floor(i / 49) / 6)
      .multiply(size)
      .add(box.min);
    const found = surfacesAlong(scene, new Ray(eye, at.sub(eye).normalize()), camera);
    if (!found.some((each) => each.object === object)) continue;
    hits++;
    if (found[0].object === object) seen++;
  }
  return seen / hits;
}

/** Whether boxes overlap by more than their faces. */
const share = (a: Box3, b: Box3): boolean => a.clone().expandByScalar(-0.01).intersectsBox(b);

describe('land', () => {
  it('stands on the ground under the middle of the picture, many beside each other', () => {
    const view = viewOf(new Scene(), [4, 3, 6], [1, 0, 2]);
    const boxes = Array.from({ length: 8 }, () => place(view, mesh(null, [0, 0, 0])));
    expect(
      boxes[0]
        .getCenter(new Vector3())
        .toArray()
        .map((each) => Number(each.toFixed(3))),
    ).toEqual([1, 0.5, 2]);
    boxes.forEach((box, i) => {
      expect(box.min.y).toBeCloseTo(0, 4);
      expect(boxes.slice(0, i).some((other) => share(box, other))).toBe(false);
      // all are close to the first one: a few box widths to either side
      expect(box.getCenter(new Vector3()).distanceTo(boxes[0].getCenter(new Vector3()))).toBeLessThan(6);
    });
    expect(boxes[1].min.x).toBeGreaterThan(boxes[0].max.x);
    view.scene.dispose();
  });

  it('stands on a table, but beside a thing of its own size', () => {
    const scene = new Scene();
    mesh(scene, [0, 0.5, 0], [3, 1, 3]);
    const view = viewOf(scene, [0, 6, 6], [0, 1, 0]);
    const small = place(view, mesh(null, [0, 0, 0], [0.4, 0.4, 0.4]));
    expect(small.min.y).toBeCloseTo(1, 4);
    const same = place(view, mesh(null, [0, 0, 0], [3, 1, 3]));
    expect(same.min.y).toBeCloseTo(0, 4);
    expect(share(same, new Box3(new Vector3(-1.5, 0, -1.5), new Vector3(1.5, 1, 1.5)))).toBe(false);
    scene.dispose();
  });

  it('stands on the floor before a wall that is looked at, not in it', () => {
    const scene = new Scene();
    const wall = mesh(scene, [0, 2, -5], [20, 4, 0.5]);
    const view = viewOf(scene, [1, 2, 6], [1, 2, -5]);
    const box = place(view, mesh(null, [0, 0, 0], [1, 2, 1]));
    expect(box.min.y).toBeCloseTo(0, 4);
    expect(share(box, boundsOf([wall]))).toBe(false);
    expect(box.min.z).toBeGreaterThanOrEqual(-4.75);
    expect(box.min.z).toBeLessThan(-4.6);
    scene.dispose();
  });

  it('counts a room as a place, not as an obstacle', () => {
    const scene = new Scene();
    const room = mesh(scene, [0, 5, 0], [30, 10, 30]);
    room.getComponent(ObjectRenderer)!.set('doubleSided', true);
    scene.three.updateMatrixWorld();
    const view = viewOf(scene, [0, 3, 8], [0, 0, 0]);
    const box = place(view, mesh(null, [0, 0, 0]));
    expect(box.getCenter(new Vector3()).distanceTo(new Vector3(0, 0.5, 0))).toBeLessThan(0.01);
    scene.dispose();
  });

  it.each([
    ['the front', [4, 3, 6]],
    ['the left', [-7, 2.5, 1]],
    ['behind', [-3, 4, -8]],
    ['above', [0.5, 12, 4]],
  ] as const)('puts a wall or a room where it is seen, not behind the room that is looked at from %s', (_side, eye) => {
    for (const [type, away] of [
      [Wall, 1],
      [Room, 1.7],
    ] as const) {
      const [x, y, z] = eye.map((each) => each * away);
      const view = viewOf(new Scene(), [x, y, z], [0, 0.5, 0]);
      const room = place(view, building(Room));
      const added = building(type);
      expect(share(place(view, added), room)).toBe(false);
      expect(shareSeen(view, added)).toBeGreaterThan(0.6);
      view.scene.dispose();
    }
  });

  it('puts a wall into the room that one looks into, between its walls', () => {
    for (const [eye, values] of [
      [[1.5, 1.6, 0.5], {}],
      [[4, 6, 5], { ceiling: false }],
    ] as const) {
      const scene = new Scene();
      const room = building(Room, { width: 5, depth: 4, ...values });
      room.getComponent(ObjectRenderer)!.set('doubleSided', true);
      scene.add(room);
      scene.three.updateMatrixWorld();
      const box = place(viewOf(scene, [...eye], [-0.9, 0, -0.9]), building(Wall));
      expect(new Box3(new Vector3(-2.501, -0.001, -2.001), new Vector3(2.501, 2.601, 2.001)).containsBox(box)).toBe(
        true,
      );
      expect(box.getCenter(new Vector3()).z).toBeCloseTo(-0.9, 1);
      scene.dispose();
    }
  });

  it('hangs lights at a useful height, below a ceiling, apart from each other', () => {
    const scene = new Scene();
    const view = viewOf(scene, [4, 3, 6], [0, 0, 0]);
    for (const [type, height] of [
      ['point', 2.5],
      ['spot', 2.5],
      ['directional', 4],
    ] as const) {
      const object = light(type);
      place(view, object);
      expect(object.transform.position[1]).toBeCloseTo(height, 3);
    }
    const second = light('point');
    place(view, second);
    const [first] = scene.roots;
    expect(second.transform.worldPosition.distanceTo(first.transform.worldPosition)).toBeGreaterThan(0.4);
    mesh(scene, [0, 2.1, 0], [50, 0.2, 50]);
    const low = light('point');
    place(viewOf(scene, [2, 1, 2], [0, 0, 0]), low);
    expect(low.transform.position[1]).toBeCloseTo(1.6, 2);
    scene.dispose();
  });

  it('goes to a comfortable distance before the eye where nothing is seen', () => {
    const scene = new Scene();
    const up = viewOf(scene, [0, 2, 0], [0, 12, -10]);
    const box = place(up, mesh(null, [0, 0, 0])).getCenter(new Vector3());
    expect(box.distanceTo(new Vector3(0, 2, 0))).toBeCloseTo(Math.hypot(10, 10), 2);
    // towards the horizon: on the ground at a moderate distance
    const level = viewOf(scene, [20, 2, 0], [20, 2, -10]);
    const far = place(level, mesh(null, [0, 0, 0]));
    expect(far.min.y).toBeCloseTo(0, 4);
    expect(far.getCenter(new Vector3()).z).toBeCloseTo(-10, 2);
    scene.dispose();
  });

  it('lays a floor flat under what stands there, and the next floor beside it', () => {
    const scene = new Scene();
    const view = viewOf(scene, [4, 3, 6], [0, 0, 0]);
    place(view, mesh(null, [0, 0, 0]));
    const floor = place(view, mesh(null, [0, 0, 0], [10, 1, 10], 'plane'));
    expect(
      floor
        .clone()
        .expandByScalar(0.01)
        .containsPoint(new Vector3(0, 0, 0)),
    ).toBe(true);
    const next = place(view, mesh(null, [0, 0, 0], [10, 1, 10], 'plane'));
    for (const each of [floor, next]) expect(each.min.y).toBeCloseTo(0, 9);
    expect(next.min.x >= floor.max.x || next.max.z <= floor.min.z || next.min.z >= floor.max.z).toBe(true);
    // small planes lie on it, just above to avoid z-fighting
    expect(place(view, mesh(null, [0, 0, 0], [2, 1, 2], 'plane')).min.y).toBeCloseTo(0.01, 4);
    scene.dispose();
  });

  it('throws a decal onto the wall that is hit', () => {
    const scene = new Scene();
    mesh(scene, [0, 2, -5], [20, 4, 0.5]);
    const decal = new GameObject('Decal');
    decal.addComponent(Decal);
    place(viewOf(scene, [1, 2, 6], [1, 2, -5]), decal);
    expect(decal.transform.worldPosition.distanceTo(new Vector3(1, 2, -4.75))).toBeLessThan(0.001);
    expect(decal.transform.front.distanceTo(new Vector3(0, 0, -1))).toBeLessThan(1e-6);
    scene.dispose();
  });

  it('keeps several as they are to each other, and rounds to the step', () => {
    const view = { ...viewOf(new Scene(), [4, 3, 6], [1.3, 0, 2.2]), step: 0.5 };
    const pair = [mesh(null, [10, 3, 0]), mesh(null, [12, 4, 0])];
    land(view, pair, CENTRE);
    expect(pair.map(({ transform }) => [...transform.position])).toEqual([
      [0.5, 0.5, 2],
      [2.5, 1.5, 2],
    ]);
    view.scene.dispose();
  });
});
