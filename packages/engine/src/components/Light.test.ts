import { isFieldVisible } from '@farol/editing/fields';
import { DirectionalLight, HemisphereLight, PointLight, RectAreaLight, SpotLight, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { Light } from './Light';

function lamp(values: Parameters<GameObject['addComponent']>[1] = {}): Light {
  const gameObject = new GameObject('Lamp');
  new Scene().add(gameObject);
  return gameObject.addComponent(Light, values);
}

describe('the three light', () => {
  test('is physical with a range of 10 m by default', () => {
    const light = lamp().three as PointLight;
    expect(light).toBeInstanceOf(PointLight);
    expect([light.distance, light.decay, light.intensity]).toEqual([10, 2, 1]);
    expect(light.userData).toEqual({});
  });

  test('is exchanged when the type changes, and the old one is gone', () => {
    const light = lamp();
    const before = light.three;
    light.type = 'spot';
    expect(light.three).toBeInstanceOf(SpotLight);
    expect(before.parent).toBeNull();
    expect(light.gameObject.object3D.children).toEqual([light.three]);
  });

  test('has linear colours', () => {
    const { color } = lamp({ diffuse: [0.5, 0.25, 2] }).three;
    expect([color.r, color.g, color.b]).toEqual([0.5, 0.25, 2]);
  });
});

describe('colour by temperature', () => {
  test('is warm, with the lumens of white, and gives way to the colour by hand', () => {
    const light = lamp({ colourBy: 'temperature', kelvin: 2700, diffuse: [0, 0, 1] });
    const { r, g, b } = light.three.color;
    expect([b / r, g / r]).toEqual([expect.closeTo(0.0991, 2), expect.closeTo(0.4153, 2)]);
    expect(0.2126 * r + 0.7152 * g + 0.0722 * b).toBeCloseTo(1);
    expect(light.colour).toEqual([r, g, b]);
    light.colourBy = 'hand';
    expect(light.three.color.toArray()).toEqual([0, 0, 1]);
  });

  test('the unit and the kind of lamp leave three’s number alone', () => {
    const light = lamp({ intensity: 5, intensityUnit: 'watt', lamp: 'halogen' });
    expect(light.three.intensity).toBe(5);
    light.intensityUnit = 'lumen';
    expect(light.three.intensity).toBe(5);
  });
});

describe('what three cannot say goes to userData.farol', () => {
  test('near and far', () => {
    const { three } = lamp({ attenuation: 'near-far', near: 2, far: 6 });
    expect(three.userData.farol).toEqual({ attenuation: { kind: 'near-far', near: 2, far: 6 } });
    expect((three as PointLight).distance).toBe(6);
  });

  test('near beyond far is brought before it', () => {
    const { near, far } = lamp({ attenuation: 'near-far', near: 9, far: 6 }).three.userData.farol.attenuation;
    expect(near).toBeLessThan(far);
  });

  test('constant, linear and quadratic', () => {
    const { three } = lamp({ attenuation: 'polynomial', constant: 1, linear: 0.5, quadratic: 0.25, range: 8 });
    expect(three.userData.farol.attenuation).toEqual({
      ...{ kind: 'polynomial', constant: 1, linear: 0.5, quadratic: 0.25, range: 8 },
    });
  });

  test('extra colours, as they are: the renderer multiplies by the intensity', () => {
    const { three } = lamp({ ambient: [0.1, 0, 0], ownSpecular: true, specular: [0, 1, 0], intensity: 3 });
    expect(three.userData.farol).toEqual({ ambient: [0.1, 0, 0], specular: [0, 1, 0] });
  });

  test("a spot's exponent, and none on other types", () => {
    const light = lamp({ type: 'spot', exponent: 8, cutoff: 0.4 });
    expect(light.three.userData.farol).toEqual({ spotExponent: 8 });
    expect((light.three as SpotLight).angle).toBe(0.4);
    light.type = 'point';
    expect(light.three.userData.farol).toBeUndefined();
    light.type = 'directional';
    light.attenuation = 'near-far';
    expect(light.three.userData.farol).toBeUndefined();
  });
});

describe('a light with a shape', () => {
  test('is a RectAreaLight of its width and height, that shines along the front', () => {
    const light = lamp({ type: 'rectangle', width: 2, height: 0.5, intensity: 7, castShadow: true });
    const three = light.three as RectAreaLight;
    expect(three).toBeInstanceOf(RectAreaLight);
    expect([three.width, three.height, three.intensity, three.castShadow]).toEqual([2, 0.5, 7, true]);
    expect([light.isArea, light.reach]).toEqual([true, Infinity]);
    light.castShadow = false;
    expect(three.userData).toEqual({});
    light.lookAt([1, 2, 3], [4, 4, 4]);
    light.scene!.three.updateMatrixWorld();
    const along = new Vector3(0, 0, -1).transformDirection(three.matrixWorld);
    expect(along.distanceTo(light.direction)).toBeCloseTo(0, 9);
  });

  test('says by userData.farol what three cannot: disc, tube, and where it ends', () => {
    const light = lamp({ type: 'tube', areaRange: 4 });
    expect(light.three.userData.farol).toEqual({ shape: 'tube', range: 4 });
    expect(light.reach).toBe(4);
    light.type = 'disc';
    light.areaRange = 0;
    expect(light.three.userData.farol).toEqual({ shape: 'disc' });
    light.castShadow = true;
    light.shadowMapSize = 256;
    light.shadowNormalBias = 0.1;
    expect(light.three.userData.farol).toEqual({ shape: 'disc', shadowMapSize: 256, shadowNormalBias: 0.1 });
    light.type = 'point';
    expect([light.three.userData.farol, light.isArea]).toEqual([undefined, false]);
  });

  test.each([
    ['rectangle', ['shadowMapSize', 'shadowNormalBias']],
    ['tube', ['shadowMapSize', 'shadowNormalBias']],
    ['point', ['shadowMapSize', 'shadowRadius', 'shadowBias', 'shadowNormalBias']],
    ['directional', ['shadowMapSize', 'shadowRadius', 'shadowBias', 'shadowNormalBias', 'shadowExtent']],
    ['ambient', []],
  ])('a %s light shows the fields of shadows that it has', (type, names) => {
    const light = lamp({ type, castShadow: true });
    const shown = Object.entries(Light.fields).filter(
      ([name]) =>
        name.startsWith('shadow') && isFieldVisible(Light.fields, name, (other) => light[other as keyof Light]),
    );
    expect(shown.map(([name]) => name)).toEqual(names);
  });
});

describe('direction', () => {
  test.each(['directional', 'spot'])('a %s light shines along the front of its object', (type) => {
    const light = lamp({ type });
    light.lookAt([3, 4, 5], [3, 0, 5], [1, 0, 0]);
    light.scene!.three.updateMatrixWorld();
    const { target } = light.three as SpotLight | DirectionalLight;
    const from = new Vector3().setFromMatrixPosition(light.three.matrixWorld);
    const along = new Vector3().setFromMatrixPosition(target.matrixWorld).sub(from);
    expect(along.distanceTo(light.direction)).toBeCloseTo(0, 9);
    expect(along.y).toBeCloseTo(-1, 9);
    expect(from.toArray()).toEqual([3, 4, 5]);
  });

  test("the hemisphere's sky is at the object's top, wherever the object is", () => {
    const light = lamp({ type: 'hemisphere' });
    light.gameObject.transform.position = [50, 0, 0];
    light.gameObject.transform.rotation = [0, 0, Math.PI / 2];
    light.scene!.three.updateMatrixWorld();
    expect(light.three).toBeInstanceOf(HemisphereLight);
    const sky = new Vector3().setFromMatrixPosition(light.three.matrixWorld);
    expect(sky.distanceTo(new Vector3(-1, 0, 0))).toBeCloseTo(0, 9);
  });
});

test('reach is where the light ends', () => {
  expect(lamp({ range: 4 }).reach).toBe(4);
  expect(lamp({ range: 0 }).reach).toBe(Infinity);
  expect(lamp({ attenuation: 'near-far', far: 7 }).reach).toBe(7);
  expect(lamp({ type: 'directional' }).reach).toBe(Infinity);
});
