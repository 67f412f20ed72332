import { DataUtils, MeshStandardMaterial, Scene, ShaderChunk, ShaderLib, SphericalHarmonics3, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { Frame } from '../../frame/Frame';
import type { RenderItem } from '../../frame/RenderItem';
import type { TwinKind, TwinShader } from '../../materials/TwinKind';
import { LightProbes, setBakedSurroundings } from './LightProbes';
import { probePoints } from './ProbeBox';
import { ProbeGrid } from './ProbeGrid';

const box = { min: [0, 0, 0], max: [4, 2, 6], counts: [2, 1, 3] } as const;
const coefficients = Float32Array.from({ length: 27 * 6 }, (_, i) => ((i * 7) % 41) / 20 - 1);

describe('a grid of probes', () => {
  test('has them in the middles of equal cells, x fastest', () => {
    expect([...probePoints(box)]).toEqual([1, 1, 1, 3, 1, 1, 1, 1, 3, 3, 1, 3, 1, 1, 5, 3, 1, 5]);
  });

  test('holds each coefficient where the shader looks for it, the first and last slice of each volume twice', () => {
    const { texture } = new ProbeGrid(box, coefficients);
    const { data, width, height, depth } = texture.image as unknown as {
      data: Uint16Array;
      width: number;
      height: number;
      depth: number;
    };
    expect([width, height, depth]).toEqual([2, 1, 35]);
    const at = (x: number, slice: number, channel: number): number =>
      DataUtils.fromHalfFloat(data[4 * (slice * 2 + x) + channel]);
    for (let probe = 0; probe < 6; probe++) {
      const [x, z] = [probe % 2, Math.floor(probe / 2)];
      for (let i = 0; i < 27; i++) {
        const volume = 5 * Math.floor(i / 4);
        const wanted = coefficients[27 * probe + i];
        expect(at(x, volume + z + 1, i % 4)).toBeCloseTo(wanted, 3);
        if (z === 0) expect(at(x, volume, i % 4)).toBeCloseTo(wanted, 3);
        if (z === 2) expect(at(x, volume + 4, i % 4)).toBeCloseTo(wanted, 3);
      }
    }
  });

  test('of another number of coefficients is refused', () => {
    expect(() => new ProbeGrid(box, coefficients.slice(1))).toThrow('161 coefficients for 6 probes; give 162');
  });

  test('is summed as three sums a LightProbe', () => {
    // the sum of probeIrradiance.glsl, term by term
    const sh = new SphericalHarmonics3().fromArray([...coefficients.slice(0, 27)]);
    const n = new Vector3(0.48, -0.6, 0.64);
    const c = sh.coefficients;
    const sum = c[0].clone().multiplyScalar(0.886227);
    for (const [k, axis] of [
      [1, n.y],
      [2, n.z],
      [3, n.x],
    ])
      sum.addScaledVector(c[k], 1.023328 * axis);
    sum.addScaledVector(c[4], 0.858086 * n.x * n.y).addScaledVector(c[5], 0.858086 * n.y * n.z);
    sum.addScaledVector(c[7], 0.858086 * n.x * n.z).addScaledVector(c[6], 0.743125 * n.z * n.z - 0.247708);
    sum.addScaledVector(c[8], 0.429043 * (n.x * n.x - n.y * n.y));
    const wanted = sh.getIrradianceAt(n, new Vector3());
    expect(sum.distanceTo(wanted)).toBeLessThan(1e-5);
  });
});

describe('the effect', () => {
  const kind: TwinKind = { key: 'lit', role: 'forward', chunks: () => [], patch: () => {} };
  const material = new MeshStandardMaterial();
  const item = { shading: 'lit', material } as unknown as RenderItem;
  const shaderOf = (twin: TwinKind): TwinShader => {
    const { uniforms, vertexShader, fragmentShader } = ShaderLib.standard;
    const shader = { uniforms: { ...uniforms }, vertexShader, fragmentShader } as TwinShader;
    twin.patch(shader, material, '');
    return shader;
  };

  test('leaves scenes without baked light, and what three does not light, as they are', () => {
    const effect = new LightProbes();
    const scene = new Scene();
    effect.begin({ scene } as Frame);
    expect(effect.adapt(kind, item)).toBe(kind);
    setBakedSurroundings(scene, { grid: null, hasSky: true });
    effect.begin({ scene } as Frame);
    expect(effect.adapt(kind, { ...item, shading: 'unlit' })).toBe(kind);
    const { role: _, ...noRole } = kind;
    expect(effect.adapt(noRole, item)).toBe(noRole);
    expect(effect.adapt(kind, item)).not.toBe(kind);
    expect(effect.adapt(kind, item)).toBe(effect.adapt(kind, item));
    setBakedSurroundings(scene, null);
    effect.begin({ scene } as Frame);
    expect(effect.adapt(kind, item)).toBe(kind);
  });

  test('adds probes where there is no lightmap, and takes away the sky that was baked', () => {
    const effect = new LightProbes();
    const scene = new Scene();
    const grid = new ProbeGrid(box, coefficients);
    setBakedSurroundings(scene, { grid, hasSky: true });
    effect.begin({ scene } as Frame);
    const { uniforms, fragmentShader } = shaderOf(effect.adapt(kind, item));
    expect(uniforms.farol_probes.value).toBe(grid.texture);
    expect(uniforms.farol_environmentShare.value).toBe(0);
    const [declared, main] = fragmentShader.split('void main()');
    expect(declared).toContain('vec3 farol_probeIrradiance(');
    expect(main).toMatch(
      /lights_fragment_maps>\s+#if defined\( RE_IndirectDiffuse \)\s+#ifndef USE_LIGHTMAP\s+irradiance \+=/,
    );
    // what the added lines name is there in three's chunk before them
    for (const name of ['geometryPosition', 'geometryNormal', 'irradiance', 'iblIrradiance'])
      expect(ShaderChunk.lights_fragment_begin).toContain(`vec3 ${name} =`);
    setBakedSurroundings(scene, { grid: null, hasSky: false });
    effect.begin({ scene } as Frame);
    expect(uniforms.farol_environmentShare.value).toBe(1);
    expect(uniforms.farol_probes.value).not.toBe(grid.texture);
  });
});
