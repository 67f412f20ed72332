/** What is known of an autosave without reading it. */
export interface SessionInfo {
  readonly id: string;
  /** Name of the scene. */
  readonly name: string;
  /** The file that it was last saved to; null for none. */
  readonly fileName: string | null;
  readonly handle: FileSystemFileHandle | null;
  /** Mark of the file's bytes, as the session knew them; absent where it did not. */
  readonly seen?: string;
  /** When it was last written (ms since 1970). */
  readonly time: number;
  /** How many GameObjects it has; absent in what versions before this one stored, as is the next. */
  readonly objects?: number;
  /** Label of the last edit; null when that was undone or forgotten. */
  readonly edit?: string | null;
  /** Whether it has changes that are in no file. */
  readonly isDirty: boolean;
}
