import { BufferAttribute, type BufferGeometry, type InterleavedBufferAttribute } from 'three';
import { MeshBVH, type SerializedBVH } from 'three-mesh-bvh';
import type { TreeSource } from './growTree';

interface Answer {
  readonly id: number;
  readonly tree?: SerializedBVH;
  readonly error?: string;
}

const waiting = new Map<number, { resolve(tree: SerializedBVH): void; reject(error: Error): void }>();
let worker: Worker | null = null;
let ids = 0;

function sourceOf(geometry: BufferGeometry): TreeSource {
  const position = geometry.getAttribute('position') as BufferAttribute | InterleavedBufferAttribute;
  const isPlain = position instanceof BufferAttribute;
  return {
    positions: (isPlain ? position.array : position.data.array).slice(),
    itemSize: position.itemSize,
    normalized: position.normalized,
    interleaved: isPlain ? null : { stride: position.data.stride, offset: position.offset },
    index: (geometry.index?.array.slice() as Uint16Array | Uint32Array | undefined) ?? null,
    groups: geometry.groups,
    drawRange: geometry.drawRange,
  };
}

function end(reason: string): void {
  worker?.terminate();
  worker = null;
  for (const { reject } of waiting.values()) reject(new Error(reason));
  waiting.clear();
}

function startWorker(): Worker {
  const started = new Worker(new URL('./treeWorker.ts', import.meta.url), { type: 'module' });
  started.addEventListener('message', ({ data: { id, tree, error } }: MessageEvent<Answer>) => {
    const asked = waiting.get(id);
    waiting.delete(id);
    if (tree) asked?.resolve(tree);
    else asked?.reject(new Error(error));
    // an idle worker is ended to free its memory
    if (waiting.size === 0) end('');
  });
  started.addEventListener('error', () => end('The worker that grows trees of triangles could not be loaded.'));
  return started;
}

/** Builds a hierarchy in a worker, or in this thread when there are no workers, as in tests. */
async function grow(source: TreeSource): Promise<SerializedBVH> {
  if (typeof Worker === 'undefined') return (await import('./growTree')).growTree(source);
  worker ??= startWorker();
  const id = ids++;
  const { positions, index } = source;
  const buffers = [positions.buffer, ...(index ? [index.buffer] : [])] as ArrayBuffer[];
  return new Promise((resolve, reject) => {
    waiting.set(id, { resolve, reject });
    worker!.postMessage({ id, source }, buffers);
  });
}

/**
 * Builds a bounding volume hierarchy for a geometry, in a worker; the geometry is unchanged. @throws Error (as a
 * rejection) when building fails
 */
export async function loadTree(geometry: BufferGeometry): Promise<MeshBVH> {
  const tree = await grow(sourceOf(geometry));
  return MeshBVH.deserialize(tree, geometry, { setIndex: false });
}
