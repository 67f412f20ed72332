/** Non-standard method of browsers with the File System Access API. */
interface Pickers {
  showSaveFilePicker?(options: object): Promise<FileSystemFileHandle & { remove?(): Promise<void> }>;
}

/** A file on the user's disk that is written while a film is made; it keeps its former content until `close`. */
export class FilmFile {
  private constructor(
    private readonly handle: FileSystemFileHandle & { remove?(): Promise<void> },
    private readonly stream: FileSystemWritableFileStream,
  ) {}

  /**
   * Asks the user where to save. Call at the user's click, before anything is awaited.
   * @param type - MIME type
   * @returns null where the browser writes no files, or refuses to: the film is then held in memory and downloaded
   * @throws AbortError when the user cancelled
   */
  static async ask(suggestedName: string, description: string, type: string): Promise<FilmFile | null> {
    const { showSaveFilePicker } = window as Pickers;
    if (!showSaveFilePicker) return null;
    const extension = suggestedName.slice(suggestedName.lastIndexOf('.'));
    const types = [{ description, accept: { [type]: [extension] } }];
    try {
      const handle = await showSaveFilePicker.call(window, { id: 'farol-export', suggestedName, types });
      return new FilmFile(handle, await handle.createWritable());
    } catch (error) {
      // the page is in a frame, or the click was too long ago
      if (error instanceof DOMException && error.name === 'SecurityError') return null;
      throw error;
    }
  }

  get name(): string {
    return this.handle.name;
  }

  /** Writes bytes. @param position - offset from the beginning of the file (bytes); after the last write when absent */
  write(data: Uint8Array<ArrayBuffer>, position?: number): Promise<void> {
    return this.stream.write(position === undefined ? data : { type: 'write', data, position });
  }

  close(): Promise<void> {
    return this.stream.close();
  }

  /** Leaves the file as it was; removes an empty one, which the picker created. */
  async abort(): Promise<void> {
    await this.stream.abort().catch(() => {});
    const { size } = await this.handle.getFile().catch(() => ({ size: 1 }));
    if (size === 0) await this.handle.remove?.().catch(() => {});
  }
}
