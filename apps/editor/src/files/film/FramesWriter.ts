import { t } from '@farol/editing';
import { Zip, ZipPassThrough } from 'three/addons/libs/fflate.module.js';
import type { FilmFile } from './FilmFile';
import type { FilmWriter } from './FilmWriter';

/** Largest ZIP without ZIP64 (bytes), which the writer does not support. @see PKWARE APPNOTE.TXT 4.4 */
const LARGEST = 2 ** 32 - 1;
/** Maximum number of files in a ZIP without ZIP64. */
export const MOST_FRAMES = 65_535;

/** Writes a film as numbered PNGs in a ZIP, `frame-00001.png` and so on. */
export class FramesWriter implements FilmWriter {
  private readonly zip: Zip;
  private readonly parts: Uint8Array<ArrayBuffer>[] = [];
  private written: Promise<void> = Promise.resolve();
  private frames = 0;
  private bytes = 0;

  /** @param file - written to while the film is made; null keeps it in memory */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly file: FilmFile | null,
  ) {
    this.zip = new Zip((error, data) => {
      if (error) throw error;
      this.bytes += data.length;
      const bytes = data as Uint8Array<ArrayBuffer>;
      if (file) this.written = this.written.then(() => file.write(bytes));
      else this.parts.push(bytes);
    });
  }

  async add(): Promise<void> {
    const { canvas } = this;
    const { width, height } = canvas;
    const png = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
    if (png === null)
      throw new Error(t('This browser makes no PNG of {width} × {height}: choose a smaller size.', { width, height }));
    if (this.bytes + png.size > LARGEST)
      throw new Error(t('The film would have more than the 4 GB of a ZIP: choose a smaller size or a shorter film.'));
    const entry = new ZipPassThrough(`frame-${String(++this.frames).padStart(5, '0')}.png`);
    entry.mtime = new Date(2000, 0, 1); // a fixed date, so that two exports of one film are identical
    this.zip.add(entry);
    entry.push(new Uint8Array(await png.arrayBuffer()), true);
    await this.written;
  }

  async end(): Promise<Blob | null> {
    this.zip.end();
    await this.written;
    if (!this.file) return new Blob(this.parts, { type: 'application/zip' });
    await this.file.close();
    return null;
  }

  async abort(): Promise<void> {
    this.zip.terminate();
    await this.written.catch(() => {});
    await this.file?.abort();
  }
}
