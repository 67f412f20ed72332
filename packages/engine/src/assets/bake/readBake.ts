import type { ProbeBox } from '@farol/renderer/light-probes';
import { DataUtils } from 'three';
import { counted } from '../../base/counted';
import type { LightmapData, LightmappedMesh, ProbeData } from './BakeData';
import { BakedLight } from './BakedLight';
import { inflate, unpackLightmap } from './lightmapCode';
import { NumberReader } from './NumberStream';
import { BAKE_MAGIC, BAKE_VERSION, type BakeHead, UV_STEPS } from './writeBake';

/** Greatest side of a lightmap (texels). */
const MOST_TEXELS = 8192;
/** Greatest number of texels of all lightmaps: sixteen of 4096 × 4096 take 2 GB of GPU memory. */
const MOST_IN_ALL = 2 ** 28;
/** Greatest number of probe-grid cells along an axis. */
const MOST_CELLS = 64;
const MOST_VERTICES = 2 ** 28;

const damaged = (): never => {
  throw new Error('it is damaged, or not a file of baked light: bake the light again.');
};

const isCount = (value: unknown, most: number): value is number =>
  typeof value === 'number' && Number.isInteger(value) && value >= 0 && value <= most;

const isTriple = (value: unknown): value is [number, number, number] =>
  Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);

/** Reads the parts of a file in sequence. */
class Parts {
  private at = 0;

  constructor(private readonly bytes: Uint8Array<ArrayBuffer>) {}

  readBytes(length: number): Uint8Array<ArrayBuffer> {
    if (!isCount(length, this.bytes.length - this.at)) damaged();
    return this.bytes.slice(this.at, (this.at += length));
  }
}

function readHead(parts: Parts): BakeHead {
  if (new TextDecoder().decode(parts.readBytes(BAKE_MAGIC.length)) !== BAKE_MAGIC) damaged();
  const length = new DataView(parts.readBytes(4).buffer).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(parts.readBytes(length))) as BakeHead;
  if (isCount(head.version, 1e9) && head.version > BAKE_VERSION)
    throw new Error('it was baked by a newer Farol: update Farol, or bake the light again.');
  const isRight =
    typeof head.signature === 'string' &&
    [1, 2, 3].includes(head.channel) &&
    Array.isArray(head.lights) &&
    head.lights.every((id) => typeof id === 'string') &&
    Array.isArray(head.lightmaps) &&
    head.lightmaps.every(({ width, height }) => isCount(width, MOST_TEXELS) && isCount(height, MOST_TEXELS)) &&
    Array.isArray(head.meshes) &&
    head.meshes.every(
      ({ component, part, lightmap, source, vertices, triangles }) =>
        typeof component === 'string' &&
        isCount(part, MOST_VERTICES) &&
        isCount(lightmap, head.lightmaps.length - 1) &&
        isCount(source, MOST_VERTICES) &&
        isCount(vertices, MOST_VERTICES) &&
        isCount(triangles, MOST_VERTICES),
    ) &&
    Array.isArray(head.uvs) &&
    head.uvs.every((bytes) => isCount(bytes, 2 ** 31));
  if (!isRight) return damaged();
  const texels = head.lightmaps.reduce((sum, { width, height }) => sum + width * height, 0);
  if (texels > MOST_IN_ALL) {
    const limit = `and ${counted(MOST_IN_ALL)} is the limit`;
    throw new Error(`its lightmaps come to ${counted(texels)} texels, ${limit}: bake the light again, with fewer.`);
  }
  return head;
}

function readMeshes(head: BakeHead, bytes: Uint8Array): LightmappedMesh[] {
  // refuses false counts before arrays of that size are made: each coded number takes at least one byte
  const numbers = head.meshes.reduce((sum, { vertices, triangles }) => sum + 3 * vertices + 3 * triangles, 0);
  if (numbers > bytes.length) damaged();
  const reader = new NumberReader(bytes);
  const meshes = head.meshes.map(({ component, part, lightmap, source, vertices, triangles }): LightmappedMesh => {
    const uv1 = Float32Array.from(reader.readSteps(2 * vertices, 2), (value) => value / UV_STEPS);
    const sourceVertex = Uint32Array.from(reader.readSteps(vertices));
    const index = Uint32Array.from(reader.readSteps(3 * triangles));
    if (!sourceVertex.every((vertex) => vertex < source) || !index.every((vertex) => vertex < vertices)) damaged();
    return { component, part, lightmap, sourceVertices: source, uv1, index, sourceVertex };
  });
  return reader.isAtEnd ? meshes : damaged();
}

async function readProbes({ probes }: BakeHead, parts: Parts): Promise<ProbeData | null> {
  if (probes === null) return null;
  const { min, max, counts, bytes } = probes;
  if (!isTriple(min) || !isTriple(max) || !isTriple(counts)) return damaged();
  if (!counts.every((count) => isCount(count, MOST_CELLS) && count > 0)) damaged();
  const count = counts[0] * counts[1] * counts[2];
  const halves = await inflate(parts.readBytes(bytes), 54 * count);
  const coefficients = Float32Array.from({ length: 27 * count }, (_, i) => {
    const at = (i % 27) * count + Math.floor(i / 27);
    return DataUtils.fromHalfFloat(halves[at] + 256 * halves[27 * count + at]);
  });
  const box: ProbeBox = { min, max, counts };
  return { box, coefficients };
}

/** Reads a file of baked light. @throws Error (as a rejection) that says what is wrong with it */
export async function readBake(bytes: ArrayBuffer): Promise<BakedLight> {
  try {
    const parts = new Parts(new Uint8Array(bytes));
    const head = readHead(parts);
    const packed = head.lightmaps.map((lightmap) => parts.readBytes(lightmap.bytes));
    const lightmaps: LightmapData[] = [];
    // one lightmap after the other, since unpacking one takes several times its size
    for (const [i, { width, height }] of head.lightmaps.entries()) {
      lightmaps.push(await unpackLightmap(packed[i], width, height));
    }
    const meshes = readMeshes(head, await inflate(parts.readBytes(head.uvs[0]), head.uvs[1]));
    const probes = await readProbes(head, parts);
    const { signature, lights, sky, channel } = head;
    return new BakedLight({ signature, lights, hasSky: sky === true, channel, lightmaps, meshes, probes });
  } catch (error) {
    // messages of JSON.parse and inflate do not help a user
    if (error instanceof SyntaxError || error instanceof TypeError) damaged();
    throw error;
  }
}
