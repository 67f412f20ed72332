import { Signal } from '@farol/editing';

/** A file that was opened or saved in this browser. */
export interface RecentFile {
  readonly id: string;
  readonly name: string;
  /** Name of the scene in the file. */
  readonly scene: string;
  /** Time at which the file was last opened or saved (ms since 1970). */
  readonly time: number;
  /** Handle to read the file again; null in browsers without handles. */
  readonly handle: FileSystemFileHandle | null;
  /** Copy of the file, when there is no handle; null when it was too large. */
  readonly copy: Blob | null;
  /** Thumbnail of the scene in the file; null until it is made. */
  readonly picture: Blob | null;
}

/** The last files opened or saved in this browser, newest first. */
export class RecentFiles {
  readonly changed = new Signal();

  private files: readonly RecentFile[] = [];

  /** Empty until the browser's storage has been read; a new array after each change. */
  get list(): readonly RecentFile[] {
    return this.files;
  }

  set list(files: readonly RecentFile[]) {
    this.files = files;
    this.changed.emit();
  }
}
