import type { BatchedMesh, DataTexture } from 'three';

/** Private properties of three's BatchedMesh with its instances. */
interface Batch {
  readonly _matricesTexture: DataTexture;
  readonly _indirectTexture: DataTexture;
  readonly _visibilityChanged: boolean;
}

/** The matrices of a batch's instances, 16 floats each. */
export function batchMatrices(mesh: BatchedMesh): DataTexture {
  return (mesh as unknown as Batch)._matricesTexture;
}

/** Index of the instance of each draw of a batch. */
export function batchIndices(mesh: BatchedMesh): DataTexture {
  return (mesh as unknown as Batch)._indirectTexture;
}

/** Whether instances were shown or hidden since the batch was last drawn. */
export function batchVisibilityChanged(mesh: BatchedMesh): boolean {
  return (mesh as unknown as Batch)._visibilityChanged;
}
