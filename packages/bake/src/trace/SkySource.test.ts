import {
  Color,
  CubeTexture,
  EquirectangularReflectionMapping,
  type Matrix3,
  PointLight,
  Scene,
  Texture,
  Vector3,
} from 'three';
import { expect, it } from 'vitest';
import type { Sky } from '../BakeOptions';
import type { SkyLight } from '../scene/collectLights';
import { skySource } from './SkySource';

const equirectangular = (): Texture => Object.assign(new Texture(), { mapping: EquirectangularReflectionMapping });

function source(scene: Scene, sky: Sky, lights: readonly SkyLight[] = []) {
  const warnings: string[] = [];
  const { isBlack, uniforms, defines } = skySource(scene, sky, lights, (sentence) => warnings.push(sentence));
  const value = <T>(name: string): T => uniforms[`farol_sky${name}`].value as T;
  return { isBlack, defines, warnings, value };
}

it('is black without a sky, lights or an environment', () => {
  for (const sky of ['none', 'environment', 0x000000] as const) {
    const { isBlack, value, defines, warnings } = source(new Scene(), sky);
    expect([isBlack, value('Map'), value<Color>('Colour').toArray(), warnings]).toEqual([true, null, [0, 0, 0], []]);
    expect(defines).toEqual({ SKY_LIGHTS: 1 });
  }
});

it('is the environment as the scene has it: its intensity, and turned as three turns it', () => {
  const scene = new Scene();
  scene.environment = equirectangular();
  scene.environmentIntensity = 0.25;
  scene.environmentRotation.set(0.3, 0.5, -0.2);
  const { isBlack, value, defines } = source(scene, 'environment');
  expect([isBlack, value('Map'), value('Factor')]).toEqual([false, scene.environment, 0.25]);
  expect(defines).toEqual({ SKY_LIGHTS: 1, SKY_TEXTURE: '' });
  // the lookup direction, rotated back, is the world direction
  const world = new Vector3(1, 2, 3).normalize();
  const looked = world.clone().applyMatrix3(value<Matrix3>('Turn')).applyEuler(scene.environmentRotation);
  for (const axis of ['x', 'y', 'z'] as const) expect(looked[axis]).toBeCloseTo(world[axis], 12);
});

it('is a texture or a colour that is given, whatever the environment of the scene', () => {
  const scene = Object.assign(new Scene(), { environment: equirectangular(), environmentIntensity: 3 });
  const texture = equirectangular();
  const given = source(scene, texture);
  expect([given.value('Map'), given.value('Factor')]).toEqual([texture, 1]);
  const coloured = source(scene, new Color(0.5, 2, 0));
  expect([coloured.isBlack, coloured.value('Map')]).toEqual([false, null]);
  expect(coloured.value<Color>('Colour').toArray()).toEqual([0.5, 2, 0]);
});

it('says which textures it cannot bake', () => {
  for (const texture of [new Texture(), new CubeTexture()]) {
    const { isBlack, warnings } = source(new Scene(), texture as Texture);
    expect([isBlack, warnings.length]).toEqual([true, 1]);
    expect(warnings[0]).toMatch(/not equirectangular\. Give options\.sky/);
  }
});

it('has of each light the radiance above and below: irradiance over π', () => {
  const lights = [new Vector3(0, 1, 0), new Vector3(1, 0, 0)].map((up, i): SkyLight => {
    const [sky, ground] = [new Color(1 + i, 2, 3), new Color(0, 5 + i, 6)];
    return { light: new PointLight(), up, sky, ground, isIndirect: false };
  });
  const { isBlack, value, defines } = source(new Scene(), 'none', lights);
  expect([isBlack, defines]).toEqual([false, { SKY_LIGHTS: 2 }]);
  expect(value<Vector3[]>('Up')).toEqual(lights.map(({ up }) => up));
  for (const [name, part] of [
    ['Above', 'sky'],
    ['Below', 'ground'],
  ] as const) {
    value<Color[]>(name).forEach((each, i) => {
      const expected = lights[i][part].toArray();
      each.toArray().forEach((channel, k) => expect(channel * Math.PI, `${name} ${k}`).toBeCloseTo(expected[k], 12));
    });
  }
});
