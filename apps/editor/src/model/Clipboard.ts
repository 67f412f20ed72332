import { Signal } from '@farol/editing';
import type { ClipboardFiles } from './ClipboardFiles';

/** Key in localStorage from which other tabs of the editor read the copied text. */
const KEY = 'farol-clipboard';

const NONE: ReadonlyMap<string, Blob> = new Map();

/** Code that stores and reads copied files, fetched when files are first copied, or pasted from another tab. */
const loadFiles = async (): Promise<ClipboardFiles> => import('./ClipboardFiles');

/**
 * Copied objects and values as text, with the files that the text refers to; shared by all tabs of a browser. Needs no
 * permission, since the system's clipboard is not used.
 */
export class Clipboard {
  /** Emits when something was copied in this tab. */
  readonly changed = new Signal();

  /** Pending while the copying code is fetched and objects are copied; null otherwise. */
  coming: Promise<void> | null = null;

  private copiedText: string | null = null;
  private files: ReadonlyMap<string, Blob> = NONE;
  /** Whether files are being stored; until they are, other tabs still read the previous copy. */
  private isStoring = false;
  private hasStored = false;

  /** Text of the last copy, of any tab; null when nothing was copied. */
  get text(): string | null {
    if (this.isStoring) return this.copiedText;
    try {
      return localStorage.getItem(KEY) ?? this.copiedText;
    } catch {
      return this.copiedText;
    }
  }

  set text(text: string | null) {
    this.put(text, NONE);
  }

  /** Whether the last copy holds GameObjects, or GameObjects are being copied. */
  get hasObjects(): boolean {
    return this.coming !== null || (this.text?.startsWith('{"format":"farol-objects"') ?? false);
  }

  /** Notes that objects are being copied. @param copied - fulfilled after `put`; rejected when copying failed */
  async expect(copied: Promise<void>): Promise<void> {
    this.coming = copied;
    this.changed.emit();
    try {
      await copied;
    } finally {
      if (this.coming === copied) this.coming = null;
      this.changed.emit();
    }
  }

  /** Replaces the last copy. @param files - files that the text refers to, by their names in the text */
  put(text: string | null, files: ReadonlyMap<string, Blob>): void {
    this.copiedText = text;
    this.files = files;
    this.isStoring = false;
    if (files.size > 0) void this.store(text, files);
    else this.publish(text);
    this.changed.emit();
  }

  /** A file that the copied text refers to, copied in this tab or another; null when it no longer exists. */
  async file(name: string): Promise<Blob | null> {
    const copiedFile = this.files.get(name);
    if (copiedFile) return copiedFile;
    try {
      return await (await loadFiles()).readFile(name);
    } catch {
      return null;
    }
  }

  /** Stores the files before the text, so that a tab that reads the text finds its files. */
  private async store(text: string | null, files: ReadonlyMap<string, Blob>): Promise<void> {
    this.isStoring = true;
    try {
      await (await loadFiles()).writeFiles(files);
      this.hasStored = true;
    } catch {
      // IndexedDB is missing or full: the tab that pastes reports the missing files
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
      // localStorage is missing or full: removes the previous copy, so that other tabs do not paste that
      try {
        localStorage.removeItem(KEY);
      } catch {
        // localStorage is missing
      }
    }
    if (!this.hasStored || this.files.size > 0) return;
    this.hasStored = false;
    void loadFiles()
      .then(({ writeFiles }) => writeFiles(NONE))
      .catch(() => {});
  }
}
