import { Signal } from '@farol/editing';
import type { ClipboardFiles } from './ClipboardFiles';

/** Where other tabs of the editor find what was copied. */
const KEY = 'farol-clipboard';

const NONE: ReadonlyMap<string, Blob> = new Map();

/** Fetched with the first copy that has files, or the first paste that needs some from another tab. */
const loadFiles = async (): Promise<ClipboardFiles> => import('./ClipboardFiles');

/**
 * Copied objects and values as text, with the files that they need: of this tab, and of others of the same browser. It asks
 * for no permission.
 */
export class Clipboard {
  /** Emits when something was copied here. */
  readonly changed = new Signal();

  private own: string | null = null;
  private files: ReadonlyMap<string, Blob> = NONE;
  /** Whether files are being stored: until they are, other tabs have what was copied before. */
  private isStoring = false;
  private hasStored = false;

  /** What was copied last; null when nothing was. */
  get text(): string | null {
    if (this.isStoring) return this.own;
    try {
      return localStorage.getItem(KEY) ?? this.own;
    } catch {
      return this.own;
    }
  }

  set text(text: string | null) {
    this.put(text, NONE);
  }

  /** @param files - what the text names as files, by its names for them */
  put(text: string | null, files: ReadonlyMap<string, Blob>): void {
    this.own = text;
    this.files = files;
    this.isStoring = false;
    if (files.size > 0) void this.store(text, files);
    else this.publish(text);
    this.changed.emit();
  }

  /** A file that what was copied names, from wherever it was copied; null when it is gone. */
  async file(name: string): Promise<Blob | null> {
    const own = this.files.get(name);
    if (own) return own;
    try {
      return await (await loadFiles()).readFile(name);
    } catch {
      return null;
    }
  }

  /** Stores the files, then tells other tabs, so that they find the files once they find the text. */
  private async store(text: string | null, files: ReadonlyMap<string, Blob>): Promise<void> {
    this.isStoring = true;
    try {
      await (await loadFiles()).writeFiles(files);
      this.hasStored = true;
    } catch {
      // no storage, or not enough: another tab says which files it does not have
    }
    if (this.files !== files) return;
    this.isStoring = false;
    this.publish(text);
  }

  private publish(text: string | null): void {
    try {
      if (text === null) localStorage.removeItem(KEY);
      else localStorage.setItem(KEY, text);
    } catch {
      // no storage, or not enough: what was there before must not come back in its place
      try {
        localStorage.removeItem(KEY);
      } catch {
        // no storage at all
      }
    }
    if (!this.hasStored || this.files.size > 0) return;
    this.hasStored = false;
    void loadFiles()
      .then(({ writeFiles }) => writeFiles(NONE))
      .catch(() => {});
  }
}
