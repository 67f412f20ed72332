import { CubeTexture, Texture } from 'three';
import { expect, test } from 'vitest';
import { CookieSlot } from './CookieSlot';
import { ImageSamplers, imageSamplersOf } from './ImageSamplers';

function setUp(count: number) {
  const samplers = new ImageSamplers(count);
  const images = new Map<Texture, CookieSlot>();
  let frame = 0;
  /** A frame in which lights project images, in this order. */
  const light = (...thrown: CookieSlot[]) => {
    frame++;
    for (const image of thrown) {
      images.set(image.texture, image);
      image.lastLit = frame;
    }
    samplers.assign(images, frame);
    return thrown.map(({ sampler }) => sampler);
  };
  return { samplers, light };
}

test('an image keeps its sampler as long as it is thrown, and others get those that are free', () => {
  const { samplers, light } = setUp(2);
  const [a, b, c] = [new Texture(), new Texture(), new Texture()].map((texture) => new CookieSlot(texture));
  expect(light(a, b, c)).toEqual([0, 1, -1]);
  expect(light(c, b, a), 'in another order').toEqual([-1, 1, 0]);
  expect(light(b, c), 'without the first').toEqual([1, 0]);
  expect(a.sampler).toBe(-1);
  expect(light(a, b, c)).toEqual([-1, 1, 0]);
  expect(samplers.textures).toEqual([c.texture, b.texture]);
});

test('cubes are copied, and a copy needs its region to be there', () => {
  const { light } = setUp(1);
  const cube = new CookieSlot(new CubeTexture());
  const image = new CookieSlot(new Texture());
  expect(light(cube, image)).toEqual([-1, 0]);
  expect([cube.isThere, image.isThere]).toEqual([false, true]);
});

test('devices with few samplers leave them to materials', () => {
  expect([8, 16, 31, 32, 64].map(imageSamplersOf)).toEqual([1, 1, 1, 4, 4]);
});
