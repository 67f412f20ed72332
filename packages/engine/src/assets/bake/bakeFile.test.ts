import { deflateRawSync } from 'node:zlib';
import { DataUtils } from 'three';
import { describe, expect, test } from 'vitest';
import { createRandom } from '../../base/createRandom';
import type { BakeData, LightmapData } from './BakeData';
import { packLightmap, unpackLightmap } from './lightmapCode';
import { readBake } from './readBake';
import { gradient } from '../../bake/testing/smallBake';
import { writeBake } from './writeBake';

/** sRGB value (0 to 255) of a linear colour. */
const shown = (linear: number): number =>
  255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.min(linear, 1) ** (1 / 2.4) - 0.055);

/** Light with noise, edges, deep shadow and light beyond white. */
function noisy(width: number, height: number): LightmapData {
  const random = createRandom(7);
  const data = new Uint16Array(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    const bright = i % 7 === 0 ? 40 : i % 5 === 0 ? 0.002 : 1;
    for (let c = 0; c < 3; c++) data[4 * i + c] = DataUtils.toHalfFloat(bright * random() ** 3);
    data[4 * i + 3] = 0x3c00;
  }
  return { width, height, data };
}

describe('a lightmap in a file', () => {
  test.each([
    ['smooth', gradient(64, 48)],
    ['noisy', noisy(61, 33)],
  ])('that is %s is off by less than 1/255 of what a screen shows, and by 1/256 of itself', async (_, lightmap) => {
    const { data, ...size } = await unpackLightmap(await packLightmap(lightmap), lightmap.width, lightmap.height);
    expect(size).toEqual({ width: lightmap.width, height: lightmap.height });
    let worst = 0;
    let worstShown = 0;
    for (let i = 0; i < data.length; i++) {
      const [is, was] = [DataUtils.fromHalfFloat(data[i]), DataUtils.fromHalfFloat(lightmap.data[i])];
      worstShown = Math.max(worstShown, Math.abs(shown(is) - shown(was)));
      // half floats below this value are coarser than that
      if (was > 6.2e-5) worst = Math.max(worst, Math.abs(is - was) / was);
    }
    expect(worstShown).toBeLessThan(1);
    expect(worst).toBeLessThanOrEqual(1 / 256);
    expect(worst).toBeGreaterThan(0);
  });

  test('takes what is no light as darkness, and what is too bright as the brightest', async () => {
    const data = Uint16Array.from([0x7e00, 0xbc00, 0x7c00, 0x3c00]); // NaN, -1, Infinity
    const read = await unpackLightmap(await packLightmap({ width: 1, height: 1, data }), 1, 1);
    expect([...read.data].map(DataUtils.fromHalfFloat)).toEqual([0, 0, 65280, 1]);
  });

  test('that is smooth takes less than a byte and a half a texel', async () => {
    expect((await packLightmap(gradient(128, 128))).length).toBeLessThan(1.5 * 128 * 128);
  });
});

const baked: BakeData = {
  signature: 'abc',
  lights: ['lamp:Light'],
  hasSky: true,
  channel: 1,
  lightmaps: [gradient(16, 16), gradient(32, 16)],
  meshes: [
    {
      component: 'floor:ObjectRenderer',
      part: 0,
      lightmap: 1,
      sourceVertices: 4,
      uv1: Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1, 1, 0].map((value) => 0.25 + 0.5 * value)),
      index: Uint32Array.from([0, 1, 2, 2, 3, 4]),
      sourceVertex: Uint32Array.from([0, 1, 2, 3, 0]),
    },
  ],
  probes: {
    box: { min: [-1, 0, -2], max: [1, 2, 2], counts: [2, 1, 2] },
    coefficients: Float32Array.from({ length: 4 * 27 }, (_, i) => (i - 50) / 16),
  },
};

describe('a file of baked light', () => {
  test('holds all that was baked; written again it is the same', async () => {
    const bytes = await writeBake(baked);
    const { data } = await readBake(bytes.buffer);
    const { uv1, ...mesh } = data.meshes[0];
    const { uv1: wasUv1, ...wasMesh } = baked.meshes[0];
    expect(mesh).toEqual(wasMesh);
    expect(uv1.every((value, i) => Math.abs(value - wasUv1[i]) <= 0.5 / 65535 + 1e-7)).toBe(true);
    expect(data.probes).toEqual(baked.probes);
    expect(data).toMatchObject({ signature: 'abc', lights: ['lamp:Light'], hasSky: true });
    expect(data.lightmaps.map(({ width, height }) => [width, height])).toEqual([
      [16, 16],
      [32, 16],
    ]);
    expect(await writeBake(data)).toEqual(bytes);
  });

  test('without probes has none', async () => {
    const { data } = await readBake((await writeBake({ ...baked, probes: null })).buffer);
    expect(data.probes).toBeNull();
  });

  test('that is cut short, is something else, or was changed, says so', async () => {
    const bytes = await writeBake(baked);
    const problem = 'it is damaged, or not a file of baked light: bake the light again.';
    for (const length of [0, 5, 11, 40, bytes.length - 1])
      await expect(readBake(bytes.slice(0, length).buffer), `${length} bytes`).rejects.toThrow(problem);
    await expect(readBake(new TextEncoder().encode('<html>no bake</html>').buffer)).rejects.toThrow(problem);
    const length = new DataView(bytes.buffer).getUint32(8, true);
    const head = new TextDecoder().decode(bytes.slice(12, 12 + length));
    for (const [from, to] of [
      ['"lightmap":1', '"lightmap":2'],
      ['"source":4', '"source":3'],
      ['"vertices":5', '"vertices":6'],
      ['"counts":[2,1,2]', '"counts":[2,0,2]'],
      ['"lights":["lamp:Light"]', '"lights":[1234567890123]'],
      ['"width":16', '"width":17'],
    ]) {
      expect(head).toContain(from);
      const changed = new Uint8Array(bytes);
      changed.set(new TextEncoder().encode(head.replace(from, to.padEnd(from.length))), 12);
      await expect(readBake(changed.slice().buffer), to).rejects.toThrow(problem);
    }
    const newer = new Uint8Array(bytes);
    newer.set(new TextEncoder().encode(head.replace('"version":1', '"version":2')), 12);
    await expect(readBake(newer.buffer)).rejects.toThrow('it was baked by a newer Farol');
  });

  test('that would come to absurd memory is refused before any is taken', async () => {
    const packed = deflateRawSync(Buffer.alloc(6 * 8192 * 8192));
    const lightmaps = Array.from({ length: 5 }, () => ({ width: 8192, height: 8192, bytes: packed.length }));
    const head = {
      version: 1,
      signature: '',
      lights: [],
      sky: false,
      channel: 1,
      lightmaps,
      meshes: [],
      uvs: [0, 0],
      probes: null,
    };
    const json = new TextEncoder().encode(JSON.stringify(head));
    const parts = ['FAROLBAK', Uint32Array.of(json.length), json, ...lightmaps.map(() => packed)];
    const bytes = await new Blob(parts as BlobPart[]).arrayBuffer();
    expect(bytes.byteLength).toBeLessThan(3_000_000);
    await expect(readBake(bytes)).rejects.toThrow(/its lightmaps come to 335,544,320 texels/);
  });
});
