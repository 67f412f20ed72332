import { Object3D, PerspectiveCamera, PointLight } from 'three';
import { expect, it } from 'vitest';
import { LightSlots } from './LightSlots';

/** Lights of a scene in frame after frame. */
class Bench {
  readonly released = { maps: 0 };
  readonly slots = new LightSlots({ map: () => this.released.maps++, cookie: () => {} });
  private readonly root = new Object3D();
  private readonly camera = new PerspectiveCamera();
  private frame = 0;

  draw(lights: readonly PointLight[]): void {
    // what is not lit is hidden, or far away
    for (const light of lights) if (light.parent === null) this.root.add(light);
    this.slots.begin(++this.frame);
    for (const light of lights) this.slots.add(light, this.root, this.camera, true, null, 1);
    this.slots.sortOut(false);
  }

  get count(): number {
    return [...this.slots.all()].length;
  }
}

const makeLight = (): PointLight => {
  const light = new PointLight(0xffffff, 1, 5);
  light.castShadow = true;
  light.updateMatrixWorld();
  return light;
};

it('lights that come and go 500 times are not kept but for a few', () => {
  const bench = new Bench();
  const there = [makeLight(), makeLight()];
  for (let i = 0; i < 500; i++) {
    const copy = makeLight();
    bench.draw([...there, copy]);
    copy.removeFromParent();
    bench.draw(there);
    expect(bench.count).toBeLessThanOrEqual(4);
  }
  expect(bench.released.maps).toBeGreaterThanOrEqual(498);
  expect(there.every((light) => bench.slots.litSlotOf(light) !== undefined)).toBe(true);
});

it('lights that are off for a while keep their maps', () => {
  const bench = new Bench();
  const all = Array.from({ length: 100 }, makeLight);
  bench.draw(all);
  for (let i = 0; i < 50; i++) bench.draw(all.slice(0, 10));
  expect(bench.released.maps).toBe(0);
  expect(bench.count).toBe(100);
});
