import { Signal } from '@farol/editing';
import type { ClipboardFiles } from './ClipboardFiles';

/** Key of localStorage under which other tabs of the editor find the copied text. */
const KEY = 'farol-clipboard';

const NONE: ReadonlyMap<string, Blob> = new Map();

/** Fetched with the first copy that has files, or the first paste that needs files of another tab. */
const loadFiles = async (): Promise<ClipboardFiles> => import('./ClipboardFiles');

/**
 * Copied objects and values as text, with the files they name; shared by all tabs of a browser. Asks for no permission,
 * since the system's clipboard is not used.
 */
export class Clipboard {
  /** Emits when something was copied in this tab. */
  readonly changed = new Signal();

  /** Copied objects on their way, while the code of copies is fetched; null when there are none. */
  coming: Promise<void> | null = null;

  private copiedText: string | null = null;
  private files: ReadonlyMap<string, Blob> = NONE;
  /** Whether files are being stored; until then other tabs still have the copy before this one. */
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

  /** Whether GameObjects were copied last, or are on their way. */
  get hasObjects(): boolean {
    return this.coming !== null || (this.text?.startsWith('{"format":"farol-objects"') ?? false);
  }

  /** Tells that objects are being copied. @param copied - fulfilled once they were put here; rejected when they cannot be */
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

  /** @param files - files that the text names, by the names it has for them */
  put(text: string | null, files: ReadonlyMap<string, Blob>): void {
    this.copiedText = text;
    this.files = files;
    this.isStoring = false;
    if (files.size > 0) void this.store(text, files);
    else this.publish(text);
    this.changed.emit();
  }

  /** A file that the copied text names, copied in this tab or another; null when it is gone. */
  async file(name: string): Promise<Blob | null> {
    const copiedFile = this.files.get(name);
    if (copiedFile) return copiedFile;
    try {
      return await (await loadFiles()).readFile(name);
    } catch {
      return null;
    }
  }

  /** Stores the files before the text, so that a tab that finds the text finds its files too. */
  private async store(text: string | null, files: ReadonlyMap<string, Blob>): Promise<void> {
    this.isStoring = true;
    try {
      await (await loadFiles()).writeFiles(files);
      this.hasStored = true;
    } catch {
      // storage is missing or full: the tab that pastes reports the files that are missing
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
      // storage is missing or full: the copy before must not be pasted in place of this one
      try {
        localStorage.removeItem(KEY);
      } catch {
        // storage is missing
      }
    }
    if (!this.hasStored || this.files.size > 0) return;
    this.hasStored = false;
    void loadFiles()
      .then(({ writeFiles }) => writeFiles(NONE))
      .catch(() => {});
  }
}
