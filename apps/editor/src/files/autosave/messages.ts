import type { PartChange } from './parts';
import type { SessionInfo } from '../../model/SessionInfo';

/** What the autosave's worker is asked for. */
export type WorkerRequest =
  | { readonly kind: 'parts'; readonly parts: readonly PartChange[] }
  | { readonly kind: 'file'; readonly path: string; readonly blob: Blob | null }
  /** Forgets what was sent and not committed. */
  | { readonly kind: 'drop' }
  /** Stores what was sent since the last commit. */
  | { readonly kind: 'commit'; readonly info: SessionInfo }
  | { readonly kind: 'list' }
  | { readonly kind: 'read'; readonly id: string }
  | { readonly kind: 'delete'; readonly id: string };

/** Its answer: what was asked for, or what went wrong. */
export interface WorkerResponse {
  readonly id: number;
  readonly result?: unknown;
  readonly error?: { readonly name: string; readonly message: string };
}

/** A scene that was stored, put together. */
export interface StoredScene {
  readonly text: string;
  readonly files: ReadonlyMap<string, Blob>;
}
