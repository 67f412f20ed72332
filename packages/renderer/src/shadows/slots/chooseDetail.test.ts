import {
  OrthographicCamera,
  PCFShadowMap,
  PerspectiveCamera,
  PointLight,
  SpotLight,
  VSMShadowMap,
  type WebGLShadowMap,
} from 'three';
import { expect, test } from 'vitest';
import { chooseDetail } from './chooseDetail';
import { placeAndDraw } from './testing/placeAndDraw';
import { ShadowSlot } from './ShadowSlot';

const picture = { width: 1280, height: 720 };
const shadowMap = (type: number = PCFShadowMap) => ({ type, autoUpdate: true }) as WebGLShadowMap;

function cameraAt(z: number): PerspectiveCamera {
  const camera = new PerspectiveCamera(60, 16 / 9, 0.1, 500);
  camera.position.z = z;
  camera.updateMatrixWorld();
  return camera;
}

function slotOf(light: PointLight | SpotLight, size = 512): ShadowSlot {
  light.shadow.mapSize.set(size, size);
  light.updateMatrixWorld();
  if (light instanceof SpotLight) light.target.updateMatrixWorld();
  const slot = new ShadowSlot(light as SpotLight);
  slot.follow(false, cameraAt(0));
  return slot;
}

function place(slot: ShadowSlot, size = 512): void {
  placeAndDraw(slot, size >> slot.detail.level);
}

function choose(slots: ShadowSlot[], z: number, isFull = false, frames = 1): number[] {
  for (let i = 0; i < frames; i++) chooseDetail(slots, cameraAt(z), picture, shadowMap(), isFull);
  return slots.map(({ detail }) => detail.level);
}

/** Texels (m) of the reduced map and pixels (m), half way to the light's range, on its side of the camera. */
function sides(range: number, z: number, texels: number): [number, number] {
  return [range / texels, (2 * Math.tan(Math.PI / 6) * (z - range / 2)) / picture.height];
}

test('the farther a point light is, the fewer texels: each no larger than a pixel, and no smaller than a third of one', () => {
  let before = 0;
  for (const z of [3, 5.1, 10, 20, 40, 80, 160]) {
    const [level] = choose([slotOf(new PointLight(0xffffff, 1, 5))], z);
    expect(level).toBeGreaterThanOrEqual(before);
    before = level;
    const [texel, pixel] = sides(5, z, 512 >> level);
    if (level > 0) expect(texel).toBeLessThan(pixel);
    if (z > 10 && level < 5) expect(texel).toBeGreaterThan(pixel / 3);
  }
  expect(before).toBeGreaterThan(3);
  expect(choose([slotOf(new PointLight(0xffffff, 1, 5))], 1e6), 'fewest').toEqual([5]);
});

test('what has no range, is near the camera or behind it, and variance shadow maps, stay as they are', () => {
  const slots = [slotOf(new PointLight(0xffffff, 1, 0)), slotOf(new SpotLight(0xffffff, 1, 0))];
  expect(choose(slots, 300)).toEqual([0, 0]);
  const lights = () => [slotOf(new PointLight(0xffffff, 1, 5)), slotOf(new SpotLight(0xffffff, 1, 5))];
  expect(choose(lights(), 4)).toEqual([0, 0]);
  expect(choose(lights(), -100)).toEqual([0, 0]);
  const variance = lights();
  chooseDetail(variance, cameraAt(100), picture, shadowMap(VSMShadowMap), false);
  expect(variance.map(({ detail }) => detail.level)).toEqual([0, 0]);
});

test('a spot light that shines towards the camera needs more than one that shines away', () => {
  const [towards, away] = [1, -1].map((z) => {
    const light = new SpotLight(0xffffff, 1, 20, 0.4);
    light.position.set(0, 0, 0);
    light.target.position.set(0, 0, z);
    return slotOf(light);
  });
  const [near, far] = choose([towards, away], 30);
  expect(far).toBeGreaterThan(near);
});

test('for an orthographic camera no light is nearer than another; a larger picture needs more', () => {
  const camera = new OrthographicCamera(-64, 64, 36, -36, 0.1, 100);
  const at = (z: number, size = picture) => {
    camera.position.z = z;
    camera.updateMatrixWorld();
    const slot = slotOf(new PointLight(0xffffff, 1, 5));
    chooseDetail([slot], camera, size, shadowMap(), false);
    return slot.detail.level;
  };
  expect(at(3)).toBe(at(90));
  expect(at(3)).toBeGreaterThan(0);
  expect(at(3, { width: 5120, height: 2880 })).toBe(at(3) - 2);
  expect(at(3, { width: 128, height: 72 }), 'a small one needs no less').toBe(at(3));
});

test('a map that becomes too coarse is larger at once, but few a frame where it can wait', () => {
  const slots = Array.from({ length: 12 }, () => slotOf(new PointLight(0xffffff, 1, 5)));
  const [far] = choose(slots, 120);
  for (const slot of slots) place(slot);
  const half = choose(slots, 72);
  expect(half.filter((level) => level === far - 1)).toHaveLength(4);
  for (const slot of slots) place(slot);
  expect(choose(slots, 72).filter((level) => level === far - 1)).toHaveLength(8);
  expect(new Set(choose(slots, 3))).toEqual(new Set([0]));
});

test('a map is smaller only when it is drawn anyway, after a while, and never by turns of two cameras', () => {
  const slot = slotOf(new PointLight(0xffffff, 1, 5));
  choose([slot], 4);
  place(slot);
  expect(choose([slot], 60, false, 100), 'kept as it is').toEqual([0]);
  slot.map.change();
  expect(choose([slot], 60)[0]).toBeGreaterThan(1);
  place(slot);
  choose([slot], 4);
  place(slot);
  slot.map.change();
  for (let i = 0; i < 100; i++) {
    expect(choose([slot], 60)).toEqual([0]);
    expect(choose([slot], 4)).toEqual([0]);
  }
  expect(choose([slot], 60, false, 20), 'not yet').toEqual([0]);
  expect(choose([slot], 60, true, 100), 'a full atlas sees to it').toEqual([0]);
  expect(slot.detail.target).toBeGreaterThan(1);
});

test('a map that the host has drawn once is not reduced', () => {
  const light = new PointLight(0xffffff, 1, 5);
  light.shadow.autoUpdate = false;
  const slots = [slotOf(light), slotOf(new PointLight(0xffffff, 1, 5))];
  const [once, often] = choose(slots, 60);
  expect(once).toBe(0);
  expect(often).toBeGreaterThan(0);
});

test('a reduced map is looked up farther from surfaces, by half of what its texels are wider', () => {
  const light = new PointLight(0xffffff, 1, 5);
  light.shadow.normalBias = 0.01;
  const slot = slotOf(light);
  expect(slot.normalBias).toBe(0.01);
  slot.detail.start(2);
  expect(slot.normalBias).toBeCloseTo(0.01 + (5 / 128 - 5 / 512) / 2, 6);
});
