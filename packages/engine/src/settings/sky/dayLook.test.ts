import { expect, test } from 'vitest';
import { Scene } from '../../core/Scene';
import { dayLook } from './dayLook';
import { makeDaySky } from './makeSky';
import { SkySource } from './SkySource';
import { skyLooks } from './skyLooks';

const RADIANS = Math.PI / 180;

const look = (elevation: number, moon = -30): ReturnType<typeof dayLook> =>
  dayLook({
    sun: { azimuth: 1, elevation: elevation * RADIANS },
    moon: { azimuth: 2, elevation: moon * RADIANS },
    lit: 0.5,
    illuminance: null,
  });

test('the sky goes from the clear day by the sunset to the night without a jump, darker all the way', () => {
  expect(look(60).top).toEqual(skyLooks['clear-day'].top);
  expect(look(2).horizon).toEqual(skyLooks.sunset.horizon);
  expect(look(-40).top).toEqual(skyLooks.night.top);
  let before = look(60);
  for (let elevation = 60; elevation > -40; elevation -= 0.25) {
    const now = look(elevation);
    now.top.forEach((channel, i) => expect(Math.abs(channel - before.top[i])).toBeLessThan(0.01));
    expect(now.top[2]).toBeLessThanOrEqual(before.top[2] + 1e-9);
    before = now;
  }
});

test('stars come after the sun has set, and the moon takes its place, half as bright when half of it is lit', () => {
  expect([look(5).stars, look(-20).stars]).toEqual([0, skyLooks.night.stars]);
  expect(look(5, 40).disc?.elevation).toBeCloseTo(5 * RADIANS);
  expect(look(-20, 40).disc?.elevation).toBeCloseTo(40 * RADIANS);
  expect(look(-20, 40).disc?.colour[0]).toBeCloseTo(skyLooks.night.disc!.colour[0] / 2);
  expect(look(-20).disc).toBeNull();
});

test('the light of a sky on level ground is the integral of its picture', () => {
  const sky = makeDaySky({
    sun: { azimuth: 0, elevation: -0.1 },
    moon: { azimuth: 0, elevation: -1 },
    lit: 0,
    illuminance: 1,
  });
  const { data, width, height } = sky.texture.image as { data: Uint16Array; width: number; height: number };
  expect([width, height, data.length]).toEqual([512, 256, 512 * 256 * 4]);
  // a sky of uniform luminance L gives the irradiance π L
  expect(sky.irradiance! / Math.PI).toBeGreaterThan(0.02);
  expect(sky.irradiance! / Math.PI).toBeLessThan(0.3);
});

test('a sky is painted anew only where a change of sun or moon is seen', async () => {
  const source = new SkySource(() => {});
  const settings = new Scene().settings;
  const paintedFor = (sun: number, moon: number): unknown =>
    source.of(settings, {
      sun: { azimuth: 1, elevation: sun * RADIANS },
      moon: { azimuth: 2, elevation: moon * RADIANS },
      lit: 0.5,
      illuminance: null,
    });
  paintedFor(30, 10);
  await source.ready;
  const day = paintedFor(30, 10);
  expect(paintedFor(30.05, 50)).toBe(day);
  expect(paintedFor(30.5, 50)).not.toBe(day);
  const night = paintedFor(-40, 10);
  expect(paintedFor(-41, 10.2)).toBe(night);
  expect(paintedFor(-41, 12)).not.toBe(night);
  const moonless = paintedFor(-40, -10);
  expect(paintedFor(-41, -20)).toBe(moonless);
  source.dispose();
});
