import { DataUtils, MeshStandardMaterial, Scene, ShaderChunk, ShaderLib, SphericalHarmonics3, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { Frame } from '../../frame/Frame';
import type { RenderItem } from '../../frame/RenderItem';
import type { TwinKind, TwinShader } from '../../materials/TwinKind';
import { LightProbes, setBakedSurroundings } from './LightProbes';
import { probePoints } from './ProbeBox';
import { ProbeGrid } from './ProbeGrid';
import probeIrradiance from './probeIrradiance.glsl?raw';

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

  test('is summed as three sums a LightProbe, by the shader', () => {
    // the shader's statements that make `sum`, for one channel k; each texel s0 to s6 has four of the coefficients c
    const place = (name: string): number => Number(name[1]);
    const indices = (read: string): number[] =>
      [...read.matchAll(/(s\d)\.(\w+)/g)].flatMap(([, name, parts]) =>
        [...parts].map((part) => 4 * place(name) + 'xyzw'.indexOf(part)),
      );
    const statements = probeIrradiance.match(/^ *(vec3 )?sum \+?= .*;$/gm)!;
    const body = statements
      .map((line) => line.replace('vec3 sum', 'let sum'))
      .map((line) => line.replaceAll(/vec3\(s[^()]*\)|s\d\.\w+/g, (read) => `c[[${indices(read).join()}][k]]`))
      .join('\n');
    expect(statements).toHaveLength(5);
    const sum = new Function('c', 'k', 'n', `${body} return sum;`) as (c: number[], k: number, n: Vector3) => number;
    const c = [...coefficients.slice(0, 27)];
    const sh = new SphericalHarmonics3().fromArray(c);
    for (const [x, y, z] of [
      [0.48, -0.6, 0.64],
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, -1],
      [-0.6, 0.48, 0.64],
    ]) {
      const n = new Vector3(x, y, z);
      const wanted = sh.getIrradianceAt(n, new Vector3()).toArray();
      for (const k of [0, 1, 2]) expect(sum(c, k, n), `channel ${k} of ${x}, ${y}, ${z}`).toBeCloseTo(wanted[k], 5);
    }
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
    // three's chunk defines the names used by the added lines before them
    for (const name of ['geometryPosition', 'geometryNormal', 'irradiance', 'iblIrradiance'])
      expect(ShaderChunk.lights_fragment_begin).toContain(`vec3 ${name} =`);
    setBakedSurroundings(scene, { grid: null, hasSky: false });
    effect.begin({ scene } as Frame);
    expect(uniforms.farol_environmentShare.value).toBe(1);
    expect(uniforms.farol_probes.value).not.toBe(grid.texture);
  });
});
