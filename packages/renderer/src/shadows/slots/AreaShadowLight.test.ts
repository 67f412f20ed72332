import { RectAreaLight } from 'three';
import { describe, expect, it } from 'vitest';
import type { FarolLightData } from '../../lights/lightData';
import { AreaShadowLight, softSizeOf } from './AreaShadowLight';

function shadowOf(data?: FarolLightData) {
  const light = new RectAreaLight('white', 1, 2, 0.5);
  if (data) light.userData.farol = data;
  return AreaShadowLight.follow(light, 7);
}

describe('the light that draws the shadow map of an area light', () => {
  it('is one for each light, where the light is, as soft as that is large', () => {
    const light = new RectAreaLight('white', 1, 2, 0.5);
    light.position.set(1, 2, 3);
    light.updateMatrixWorld();
    const stand = AreaShadowLight.follow(light, 7);
    expect(AreaShadowLight.follow(light, 7)).toBe(stand);
    expect(AreaShadowLight.of(light)).toBe(stand);
    expect(stand.matrixWorld.equals(light.matrixWorld)).toBe(true);
    expect([stand.distance, softSizeOf(stand), softSizeOf(light)]).toEqual([7, 0.5, 0]);
  });

  it.each([
    [undefined, 1024, 0.03],
    [{}, 1024, 0.03],
    [{ shadowMapSize: 256, shadowNormalBias: 0 }, 256, 0],
    [{ shadowMapSize: 1, shadowNormalBias: -1 }, 16, 0.03],
    [{ shadowMapSize: 1e6, shadowNormalBias: 0.1 }, 8192, 0.1],
    [{ shadowMapSize: NaN, shadowNormalBias: NaN }, 1024, 0.03],
  ] as const)('takes the size of its map and its bias from %o', (data, size, normalBias) => {
    const { shadow } = shadowOf(data);
    expect([shadow.mapSize.x, shadow.mapSize.y, shadow.normalBias]).toEqual([size, size, normalBias]);
  });

  it('follows changes', () => {
    const light = new RectAreaLight();
    light.userData.farol = { shadowMapSize: 64 };
    light.layers.set(3);
    expect(AreaShadowLight.follow(light, 0).layers.mask).toBe(8);
    delete light.userData.farol;
    light.layers.enable(1);
    light.width = 8;
    light.height = 0.5;
    light.position.x = 5;
    light.updateMatrixWorld();
    const stand = AreaShadowLight.follow(light, 2);
    expect([stand.shadow.mapSize.x, stand.layers.mask, stand.distance, softSizeOf(stand)]).toEqual([1024, 10, 2, 1]);
    expect(stand.matrixWorld.elements[12]).toBe(5);
  });
});
