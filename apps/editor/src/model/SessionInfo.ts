/** Summary of an autosave, readable without loading its scene. */
export interface SessionInfo {
  readonly id: string;
  readonly name: string;
  /** The file that the scene was last saved to; null for none. */
  readonly fileName: string | null;
  readonly handle: FileSystemFileHandle | null;
  /** Hash of the file's bytes when the session last read or wrote it; absent when unknown. */
  readonly seen?: string;
  /** Time of the last write (ms since 1970). */
  readonly time: number;
  /** Number of GameObjects. This and `edit` are absent in autosaves of earlier versions. */
  readonly objects?: number;
  /** Label of the last edit in the undo history; null when there is none. */
  readonly edit?: string | null;
  /** Whether the scene has changes that are in no file. */
  readonly isDirty: boolean;
}
