import { Signal } from '@farol/editing';

/** A file that was opened or saved here. */
export interface RecentFile {
  readonly id: string;
  /** Name of the file. */
  readonly name: string;
  /** Name of its scene. */
  readonly scene: string;
  /** When it was last opened or saved (ms since 1970). */
  readonly time: number;
  /** Where the browser lets us read it again; null where it does not. */
  readonly handle: FileSystemFileHandle | null;
  /** The file as it was then, where there is no handle; null where it was too large to keep. */
  readonly copy: Blob | null;
  /** A small picture of its scene; null until there is one. */
  readonly picture: Blob | null;
}

/** The files that were last opened or saved in this browser, newest first. */
export class RecentFiles {
  readonly changed = new Signal();

  private files: readonly RecentFile[] = [];

  /** Another array after each change; empty until the browser's store has been read. */
  get list(): readonly RecentFile[] {
    return this.files;
  }

  set list(files: readonly RecentFile[]) {
    this.files = files;
    this.changed.emit();
  }
}
