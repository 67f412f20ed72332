import type { PartChange } from './parts';
import type { SessionInfo } from '../../model/SessionInfo';

/** A request to the autosave's worker. */
export type WorkerRequest =
  | { readonly kind: 'parts'; readonly parts: readonly PartChange[] }
  | { readonly kind: 'file'; readonly path: string; readonly blob: Blob | null }
  /** Discards all data sent since the last commit. */
  | { readonly kind: 'drop' }
  | { readonly kind: 'commit'; readonly info: SessionInfo }
  | { readonly kind: 'list' }
  | { readonly kind: 'read'; readonly id: string }
  | { readonly kind: 'delete'; readonly id: string };

/** The worker's answer: a result or an error. */
export interface WorkerResponse {
  readonly id: number;
  readonly result?: unknown;
  readonly error?: { readonly name: string; readonly message: string };
}

/** A stored scene, assembled from its stored parts. */
export interface StoredScene {
  readonly text: string;
  readonly files: ReadonlyMap<string, Blob>;
}
