import { Object3D, PerspectiveCamera, SpotLight, Texture } from 'three';
import { expect, test } from 'vitest';
import { placeAndDraw } from './testing/placeAndDraw';
import { LightSlots } from './LightSlots';
import type { ShadowSlot } from './ShadowSlot';

const camera = new PerspectiveCamera();
const root = new Object3D();

function setUp() {
  const released: unknown[] = [];
  const slots = new LightSlots({
    map: (slot) => released.push(slot.light),
    cookie: ({ texture }) => released.push(texture),
  });
  let frame = 0;
  /** One frame with lights that cast shadows, and lights that only project an image. */
  const light = (casting: SpotLight[], image: Texture | null = null, throwing: SpotLight[] = []) => {
    slots.begin(++frame);
    for (const one of [...casting, ...throwing]) if (one.parent === null) root.add(one);
    for (const one of casting) slots.add(one, root, camera, true, image, 1);
    for (const one of throwing) slots.add(one, root, camera, false, image, 1);
    slots.sortOut(false);
  };
  return { slots, released, light };
}

const lightsOf = (slots: readonly ShadowSlot[]) => slots.map((slot) => slot.light);

test('what is not lit is kept for 600 frames, then released, and a light that comes back has its slot', () => {
  const { slots, released, light } = setUp();
  const [a, b] = [new SpotLight(), new SpotLight()];
  const image = new Texture({ width: 8, height: 8 } as unknown as HTMLImageElement);
  light([a, b], image);
  const slot = slots.litSlotOf(a)!;
  expect(lightsOf(slots.depths)).toEqual([a, b]);
  expect(slots.colours).toHaveLength(1);
  light([b]);
  expect(slots.litSlotOf(a)).toBeUndefined();
  expect([lightsOf(slots.depths), lightsOf(slots.keptDepths)]).toEqual([[b], [a]]);
  expect([slots.colours.length, slots.keptColours.length]).toEqual([0, 1]);
  for (let i = 0; i < 598; i++) light([b]);
  light([a, b]);
  expect(slots.litSlotOf(a)).toBe(slot);
  for (let i = 0; i < 600; i++) light([b]);
  expect(released).toEqual([image]);
  light([b]);
  expect(released).toEqual([image, a]);
});

test('a light that throws its image but casts no shadow any more keeps its map as long as nobody needs the room', () => {
  const { slots, light } = setUp();
  const spot = new SpotLight();
  const image = new Texture({ width: 8, height: 8 } as unknown as HTMLImageElement);
  light([], image, [spot]);
  expect([slots.mapCount, slots.depths, slots.keptDepths], 'there is no map yet').toEqual([0, [], []]);
  light([spot], image);
  placeAndDraw(slots.litSlotOf(spot)!, 64);
  light([], image, [spot]);
  expect([slots.mapCount, slots.depths, lightsOf(slots.keptDepths)]).toEqual([0, [], [spot]]);
});

test('what a slot is told marks its map: another scene, other layers, a loss', () => {
  const { slots, light } = setUp();
  const spot = new SpotLight();
  light([spot]);
  const slot = slots.litSlotOf(spot)!;
  const marked = (act: () => void) => {
    placeAndDraw(slot, 64);
    act();
    return slot.map.state;
  };
  expect(marked(() => light([spot]))).toBe('whole');
  expect(marked(() => slot.enter(new Object3D()))).toBe('stale-whole');
  slot.enter(root);
  spot.shadow.camera.layers.enable(3);
  expect(marked(() => light([spot]))).toBe('stale-whole');
  expect(marked(() => slots.lose(true))).toBe('lost');
});

test('a light that was removed from its scene is released at once, one that is hidden or far is not', () => {
  const { slots, released, light } = setUp();
  const there = [new SpotLight(), new SpotLight()];
  light(there);
  for (let i = 0; i < 500; i++) {
    const copy = new SpotLight();
    light([...there, copy]);
    copy.removeFromParent();
    light([there[0]]);
  }
  expect([...slots.all()].length).toBeLessThanOrEqual(4);
  expect(released.length).toBeGreaterThanOrEqual(498);
  expect(released).not.toContain(there[1]);
});
