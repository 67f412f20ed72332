import type { PartChange, PartKey } from './parts';

/** The latest state of each part and file that was sent but not stored yet. */
export class PendingParts {
  private parts = new Map<PartKey, string | null>();
  private files = new Map<string, Blob | null>();

  addParts(changes: readonly PartChange[]): void {
    for (const [key, json] of changes) this.parts.set(key, json);
  }

  addFile(path: string, blob: Blob | null): void {
    this.files.set(path, blob);
  }

  clear(): void {
    this.parts.clear();
    this.files.clear();
  }

  /** Stores everything pending. When refused, it stays pending, unless newer states have been sent meanwhile. */
  async store(
    write: (parts: ReadonlyMap<PartKey, string | null>, files: ReadonlyMap<string, Blob | null>) => Promise<void>,
  ): Promise<void> {
    const { parts, files } = this;
    this.parts = new Map();
    this.files = new Map();
    try {
      await write(parts, files);
    } catch (error) {
      this.parts = new Map([...parts, ...this.parts]);
      this.files = new Map([...files, ...this.files]);
      throw error;
    }
  }
}
