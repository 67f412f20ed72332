import { BufferAttribute, BufferGeometry } from 'three';
import { Slices } from '../../base/Slices';
import { inSteps, runInSlices, type Steps } from '../../base/steps';
import { computeCreaseNormalsInSlices } from '../../geometry/computeCreaseNormals';
import type { ObjFile, ObjRun } from './parseObj';

/** Triangles of one material. */
export interface ObjPrimitive {
  readonly material: string | null;
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly uvs: Float32Array | null;
  readonly colours: Float32Array | null;
  readonly index: Uint32Array;
}

/** Mesh of one group, or of all groups in a file with very many. */
export interface ObjMesh {
  readonly name: string;
  readonly primitives: readonly ObjPrimitive[];
}

/** Number of groups above which all are joined: each group costs a draw call, and some programs write one per face. */
const MOST_GROUPS = 4000;

const CREASE = Math.PI / 6;

/**
 * The meshes of an OBJ file: a mesh for each group, a primitive for each material in it. Corners without a normal get
 * one, by a crease angle of 30°, computed over the whole file, so that no seam shows between groups.
 * @param signal - cancels the work
 * @throws the signal's abort reason (as a rejection)
 */
export async function objMeshes(file: ObjFile, signal?: AbortSignal): Promise<ObjMesh[]> {
  const normals = await completeNormals(file, signal);
  return runInSlices(buildMeshes({ ...file, normals }), new Slices(signal));
}

/** Normals of a file, completed where missing or of length 0; corners are updated to index them. */
async function completeNormals({ positions, normals, corners }: ObjFile, signal?: AbortSignal): Promise<Float32Array> {
  const slices = new Slices(signal);
  const own = await runInSlices(unitNormals(normals, corners), slices);
  const bare = await runInSlices(trianglesWithoutNormals(corners), slices);
  if (bare.length === 0) return own;
  const geometry = new BufferGeometry();
  const places = new Float32Array(bare.length * 3);
  await runInSlices(
    inSteps(bare.length, (from, to) => {
      for (let i = from; i < to; i++) {
        const vertex = corners[bare[i] * 3] * 3;
        for (let k = 0; k < 3; k++) places[i * 3 + k] = positions[vertex + k];
      }
    }),
    slices,
  );
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  const creased = await computeCreaseNormalsInSlices(geometry, CREASE, signal);
  const made = creased.getAttribute('normal').array as Float32Array;
  const index = creased.index!.array;
  const all = new Float32Array(own.length + made.length);
  all.set(own);
  all.set(made, own.length);
  for (let i = 0; i < bare.length; i++) {
    const at = bare[i] * 3 + 2;
    if (corners[at] < 0) corners[at] = own.length / 3 + index[i];
  }
  return all;
}

/** Normalises normals; a corner whose normal has length 0 loses it. */
function* unitNormals(normals: Float32Array, corners: Int32Array): Steps<Float32Array> {
  const unit = new Float32Array(normals.length);
  yield* inSteps(normals.length / 3, (from, to) => {
    for (let i = from * 3; i < to * 3; i += 3) {
      const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
      if (!(length > 1e-12)) continue;
      for (let k = 0; k < 3; k++) unit[i + k] = normals[i + k] / length;
    }
  });
  yield* inSteps(corners.length / 3, (from, to) => {
    for (let at = from * 3 + 2; at < to * 3; at += 3) {
      const normal = corners[at] * 3;
      if (normal >= 0 && unit[normal] === 0 && unit[normal + 1] === 0 && unit[normal + 2] === 0) corners[at] = -1;
    }
  });
  return unit;
}

/** Corners of all triangles with a missing normal at any corner. */
function* trianglesWithoutNormals(corners: Int32Array): Steps<Uint32Array> {
  const found = new Uint32Array(corners.length / 3);
  let count = 0;
  yield* inSteps(corners.length / 9, (from, to) => {
    for (let corner = from * 3; corner < to * 3; corner += 3) {
      const at = corner * 3 + 2;
      if (corners[at] >= 0 && corners[at + 3] >= 0 && corners[at + 6] >= 0) continue;
      for (let k = 0; k < 3; k++) found[count++] = corner + k;
    }
  });
  return found.subarray(0, count);
}

/** Sorts runs of corners by mesh, then by material, in the order of the file. */
function sortRuns(runs: readonly ObjRun[]): { name: string; materials: Map<string | null, ObjRun[]> }[] {
  const isJoined = new Set(runs.map(({ key }) => key)).size > MOST_GROUPS;
  const meshes = new Map<string, { name: string; materials: Map<string | null, ObjRun[]> }>();
  for (const run of runs) {
    const key = isJoined ? '' : run.key;
    let mesh = meshes.get(key);
    if (!mesh) meshes.set(key, (mesh = { name: isJoined ? '' : run.name, materials: new Map() }));
    const list = mesh.materials.get(run.material);
    if (list) list.push(run);
    else mesh.materials.set(run.material, [run]);
  }
  return [...meshes.values()];
}

function* buildMeshes(file: ObjFile): Steps<ObjMesh[]> {
  const meshes: ObjMesh[] = [];
  for (const { name, materials } of sortRuns(file.runs)) {
    const primitives: ObjPrimitive[] = [];
    for (const [material, runs] of materials) primitives.push(yield* buildPrimitive(file, material, runs));
    meshes.push({ name, primitives });
  }
  return meshes;
}

/** Random factor of a hash, so that no file can be made in which all corners collide. */
const randomFactor = (): number => Math.floor(Math.random() * 2 ** 31) * 2 + 1;
const factors = [randomFactor(), randomFactor(), randomFactor()];

function* buildPrimitive(
  { positions, normals, uvs, colours, corners }: ObjFile,
  material: string | null,
  runs: readonly ObjRun[],
): Steps<ObjPrimitive> {
  const count = runs.reduce((sum, { from, to }) => sum + to - from, 0);
  const index = new Uint32Array(count);
  const bits = Math.max(1, Math.ceil(Math.log2(count)));
  const first = new Int32Array(2 ** bits).fill(-1);
  /** Corner that each vertex of the primitive comes from; vertices of equal hash are linked from `first` by `next`. */
  const kept = new Uint32Array(count);
  const next = new Int32Array(count);
  const [a, b, c] = factors;
  let vertices = 0;
  let done = 0;
  let hasUvs = false;
  for (const { from: start, to: end } of runs) {
    yield* inSteps(end - start, (from, to) => {
      for (let corner = start + from; corner < start + to; corner++) {
        const at = corner * 3;
        const [place, uv, normal] = [corners[at], corners[at + 1], corners[at + 2]];
        const hash = (Math.imul(place, a) + Math.imul(uv + 1, b) + Math.imul(normal + 1, c)) >>> (32 - bits);
        let vertex = first[hash];
        while (vertex >= 0) {
          const other = kept[vertex] * 3;
          if (corners[other] === place && corners[other + 1] === uv && corners[other + 2] === normal) break;
          vertex = next[vertex];
        }
        if (vertex < 0) {
          vertex = vertices++;
          kept[vertex] = corner;
          next[vertex] = first[hash];
          first[hash] = vertex;
          if (uv >= 0) hasUvs = true;
        }
        index[done++] = vertex;
      }
    });
  }
  const take = function* (source: Float32Array, size: number, offset: number): Steps<Float32Array> {
    const target = new Float32Array(vertices * size);
    yield* inSteps(vertices, (from, to) => {
      for (let vertex = from; vertex < to; vertex++) {
        const at = corners[kept[vertex] * 3 + offset];
        if (at >= 0) for (let k = 0; k < size; k++) target[vertex * size + k] = source[at * size + k];
      }
    });
    return target;
  };
  return {
    material,
    positions: yield* take(positions, 3, 0),
    normals: yield* take(normals, 3, 2),
    uvs: hasUvs ? yield* take(uvs, 2, 1) : null,
    colours: colours ? yield* take(colours, 3, 0) : null,
    index,
  };
}
