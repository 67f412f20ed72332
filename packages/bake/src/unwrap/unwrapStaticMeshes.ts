import { type BufferGeometry, type MeshStandardMaterial, Vector3 } from 'three';
import type { CheckedBakeOptions } from '../checkOptions';
import type { StaticMesh } from '../scene/StaticMesh';
import { WorkerPool } from '../worker/WorkerPool';
import { unwrapMeshes } from './unwrapMeshes';
import type { SurfaceToUnwrap, Unwrapped, UnwrappedMesh, UnwrapRequest } from './UnwrapRequest';

export interface UnwrappedMeshes {
  /** Lightmap UVs of meshes that get a lightmap; null for others. */
  readonly unwrapped: (UnwrappedMesh | null)[];
  /** Surface from which the charts of each mesh were cut, shared by equal meshes; null for meshes without a lightmap. */
  readonly surfaces: (SurfaceToUnwrap | null)[];
  /** Texels per metre, one number per lightmap. */
  readonly texelsPerMetre: readonly number[];
}

/** Computes lightmap UVs of meshes; those of one geometry and scale are cut into charts once. */
export async function unwrapStaticMeshes(
  meshes: readonly StaticMesh[],
  { size, padding, texelsPerMetre, signal, onWarning }: CheckedBakeOptions,
  onProgress: (share: number) => void,
): Promise<UnwrappedMeshes> {
  const { surfaces, surfaceOf } = distinctSurfaces(meshes.filter(({ isLit }) => isLit));
  const request = { surfaces, meshes: surfaceOf, size, padding, texelsPerMetre: texelsPerMetre ?? null };
  const result = await unwrapInWorkers(request, signal, onProgress);
  let next = 0;
  const unwrapped = meshes.map(({ isLit }) => (isLit ? result.meshes[next++] : null));
  next = 0;
  const surfaceOfEach = meshes.map(({ isLit }) => (isLit ? surfaces[surfaceOf[next++]] : null));
  result.texelsPerMetre.forEach((density, lightmap) => {
    if (texelsPerMetre === undefined || density > 0.8 * texelsPerMetre) return;
    const first = meshes[unwrapped.findIndex((each) => each?.lightmap === lightmap)];
    onWarning(
      `${first.name} is larger than a lightmap: it gets only ${density.toPrecision(2)} texels a metre. Choose a larger size.`,
    );
  });
  return { unwrapped, surfaces: surfaceOfEach, texelsPerMetre: result.texelsPerMetre };
}

/**
 * Surfaces of meshes, in metres; meshes of equal geometry, scale and shading share one.
 *
 * @returns surfaces, and the index of each mesh's surface
 */
export function distinctSurfaces(meshes: readonly StaticMesh[]): { surfaces: SurfaceToUnwrap[]; surfaceOf: number[] } {
  const surfaces: SurfaceToUnwrap[] = [];
  const known = new Map<string, number>();
  const surfaceOf = meshes.map(({ geometry, index, surfaces: parts, placements: [placement] }) => {
    const isFlat = parts.some(({ material }) => (material as MeshStandardMaterial).flatShading);
    const { x, y, z } = new Vector3().setFromMatrixScale(placement);
    const key = [geometry.uuid, isFlat, ...[x, y, z].map((scale) => scale.toPrecision(4))].join(' ');
    const found = known.get(key);
    if (found !== undefined) return found;
    known.set(key, surfaces.length);
    return surfaces.push(scaledSurface(geometry, index, isFlat, [x, y, z])) - 1;
  });
  return { surfaces, surfaceOf };
}

async function unwrapInWorkers(
  request: UnwrapRequest,
  signal: AbortSignal | undefined,
  onProgress: (share: number) => void,
): Promise<Unwrapped> {
  const pool = await WorkerPool.make(request.surfaces.length, signal);
  try {
    return await unwrapMeshes(
      request,
      {
        cut: (surface) => pool.ask({ kind: 'cut', surface }, { weight: surface.index.length }),
        pack: (surfaces, meshes, options, told) =>
          pool.ask({ kind: 'pack', surfaces, meshes, options }, { onProgress: told }),
      },
      onProgress,
    );
  } finally {
    pool.dispose();
  }
}

function scaledSurface(
  { attributes }: BufferGeometry,
  index: Uint32Array,
  isFlat: boolean,
  scale: readonly number[],
): SurfaceToUnwrap {
  const { position, normal } = attributes;
  const positions = new Float32Array(3 * position.count);
  const normals = normal && !isFlat ? new Float32Array(3 * position.count) : null;
  for (let i = 0; i < position.count; i++) {
    for (let k = 0; k < 3; k++) {
      positions[3 * i + k] = position.getComponent(i, k) * scale[k];
      if (normals) normals[3 * i + k] = normal.getComponent(i, k);
    }
  }
  return { positions, normals, index };
}
