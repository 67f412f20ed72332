import { Matrix4, RectAreaLight, Vector3, type WebGLRenderer } from 'three';
import { describe, expect, it } from 'vitest';
import { DataTable } from '../../gpu/DataTable';
import { createRandom, randomDirection } from '../../lights/testing/testScenes';
import { MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';
import all from './areaFeatures.glsl?raw';
import { AreaLightTable } from './AreaLightTable';
import { AREA } from './areaRecord';

function makeTable(): AreaLightTable {
  const registry = new MicroShaderRegistry();
  registry.add([parseMicroShader('areaFeatures', all)]);
  const webgl = { extensions: { has: () => true } } as unknown as WebGLRenderer;
  return new AreaLightTable(webgl, { value: null }, registry);
}

describe('the table of area lights', () => {
  it('has a sphere round each light that holds all points within range of its surface', () => {
    const table = makeTable();
    const random = createRandom(3);
    const surface = new Vector3();
    for (let i = 0; i < 200; i++) {
      const light = new RectAreaLight(0xffffff, 1, 0.1 + 6 * random(), 0.1 + 6 * random());
      const range = 0.2 + 3 * random();
      light.userData.farol = { range, shape: (['rectangle', 'disc', 'tube'] as const)[i % 3] };
      const radius = table.radiusOf(light);
      let farthest = 0;
      for (let k = 0; k < 100; k++) {
        // often on the rim; discs and tubes are within their rectangle
        const [u, v] = [random(), random()].map((place) => (place < 0.3 ? 0 : place > 0.7 ? 1 : place) - 0.5);
        surface.set(u * light.width, v * light.height, 0);
        farthest = Math.max(farthest, surface.addScaledVector(new Vector3(...randomDirection(random)), range).length());
      }
      expect(farthest).toBeLessThanOrEqual(radius + 1e-9);
      expect(radius).toBeLessThan(1.3 * farthest + 0.01);
    }
  });

  it('ends a light without a range where its irradiance, at most, is the threshold', () => {
    const table = makeTable();
    const light = new RectAreaLight(0xffffff, 8, 2, 0.5);
    light.color.setRGB(0.5, 0.25, 0);
    expect(table.radiusOf(light)).toBe(0);
    table.threshold = 0.01;
    const half = 0.5 * Math.hypot(2, 0.5);
    // radiance times area by squared distance
    expect(table.radiusOf(light)).toBeCloseTo(Math.sqrt((0.5 * 8 * 1) / 0.01) + half, 9);
    light.userData.farol = { shape: 'disc' };
    expect(table.radiusOf(light)).toBeCloseTo(Math.sqrt((0.5 * 8 * (Math.PI / 4)) / 0.01) + half, 9);
    light.userData.farol = { range: 0 };
    expect(table.radiusOf(light)).toBe(0);
    light.width = 0;
    expect(table.radiusOf(light)).toBeNaN();
  });

  it('writes half of the width and of the height along its axes in view space, and its range', () => {
    const table = makeTable();
    const light = new RectAreaLight(0xffffff, 1, 4, 2);
    light.userData.farol = { range: 3, shape: 'rectangle' };
    light.rotation.z = Math.PI / 2;
    light.scale.setScalar(5);
    light.updateMatrixWorld();
    const data = new DataTable(8);
    data.reserve(32);
    table.write(data, 16, light, new Matrix4().makeRotationZ(Math.PI / 2));
    const across = [...data.data.subarray(16 + AREA.across, 16 + AREA.across + 3)];
    const up = [...data.data.subarray(16 + AREA.up, 16 + AREA.up + 4)];
    [-2, 0, 0].forEach((value, i) => expect(across[i]).toBeCloseTo(value, 6));
    [0, -1, 0, 3].forEach((value, i) => expect(up[i]).toBeCloseTo(value, 6));
  });
});
