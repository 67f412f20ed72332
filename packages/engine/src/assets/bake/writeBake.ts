import { DataUtils } from 'three';
import type { BakeData, LightmappedMesh } from './BakeData';
import { deflate, packLightmap } from './lightmapCode';
import { NumberWriter } from './NumberStream';

/** First bytes of a file of baked light. */
export const BAKE_MAGIC = 'FAROLBAK';
export const BAKE_VERSION = 1;
/** Steps between 0 and 1 to which lightmap UVs are quantised (16 bits). */
export const UV_STEPS = 65535;

/** JSON header of a file of baked light; the packed parts follow in this order. */
export interface BakeHead {
  readonly version: number;
  readonly signature: string;
  readonly lights: readonly string[];
  readonly sky: boolean;
  readonly channel: number;
  readonly lightmaps: readonly { readonly width: number; readonly height: number; readonly bytes: number }[];
  readonly meshes: readonly {
    readonly component: string;
    readonly part: number;
    readonly lightmap: number;
    readonly source: number;
    readonly vertices: number;
    readonly triangles: number;
  }[];
  /** Sizes of the lightmap UVs: packed, then unpacked (bytes). */
  readonly uvs: readonly [number, number];
  readonly probes: {
    readonly min: readonly number[];
    readonly max: readonly number[];
    readonly counts: readonly number[];
    readonly bytes: number;
  } | null;
}

/** Lightmap UVs in steps of 1/65535, source vertices and indices, as differences from the previous number. */
function meshNumbers(meshes: readonly LightmappedMesh[]): Uint8Array<ArrayBuffer> {
  const writer = new NumberWriter();
  for (const { uv1, sourceVertex, index } of meshes) {
    writer.writeSteps(
      Array.from(uv1, (value) => Math.round(Math.min(Math.max(value, 0), 1) * UV_STEPS)),
      2,
    );
    writer.writeSteps(sourceVertex);
    writer.writeSteps(index);
  }
  return writer.result;
}

/** Half floats of the coefficients, low and high bytes apart, grouped by coefficient. */
function probeBytes(coefficients: Float32Array): Uint8Array<ArrayBuffer> {
  const count = coefficients.length / 27;
  const bytes = new Uint8Array(2 * coefficients.length);
  for (let i = 0; i < coefficients.length; i++) {
    const half = DataUtils.toHalfFloat(Math.min(Math.max(coefficients[i], -65504), 65504));
    const at = (i % 27) * count + Math.floor(i / 27);
    bytes[at] = half & 255;
    bytes[coefficients.length + at] = half >> 8;
  }
  return bytes;
}

/** Baked light as a file, `.bake`: a head as JSON, then lightmaps, second UVs and probes, deflated. */
export async function writeBake(data: BakeData): Promise<Uint8Array<ArrayBuffer>> {
  const { lightmaps, meshes, probes } = data;
  const packed = await Promise.all(lightmaps.map(packLightmap));
  const numbers = meshNumbers(meshes);
  const uvs = await deflate(numbers);
  const probeBlock = probes ? await deflate(probeBytes(probes.coefficients)) : new Uint8Array(0);
  const head: BakeHead = {
    version: BAKE_VERSION,
    signature: data.signature,
    lights: data.lights,
    sky: data.hasSky,
    channel: data.channel,
    lightmaps: lightmaps.map(({ width, height }, i) => ({ width, height, bytes: packed[i].length })),
    meshes: meshes.map(({ component, part, lightmap, sourceVertices, uv1, index }) => ({
      ...{ component, part, lightmap, source: sourceVertices },
      ...{ vertices: uv1.length / 2, triangles: index.length / 3 },
    })),
    uvs: [uvs.length, numbers.length],
    probes: probes && { ...probes.box, bytes: probeBlock.length },
  };
  const text = new TextEncoder().encode(JSON.stringify(head));
  const size = new Uint8Array(4);
  new DataView(size.buffer).setUint32(0, text.length, true);
  const parts = [new TextEncoder().encode(BAKE_MAGIC), size, text, ...packed, uvs, probeBlock];
  const file = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    file.set(part, at);
    at += part.length;
  }
  return file;
}
