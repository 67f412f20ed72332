/** RGBA bytes, first row first. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray;
}

/** Header size of a fake image file (bytes): width and height. */
const HEADER = 8;

/**
 * A fake canvas for Node that copies images of its own size, and encodes them as bytes that `readPicture` decodes.
 * Tests replace `OffscreenCanvas` and `document.createElement` by it.
 */
export class PageCanvas {
  fillStyle = '';
  private pixels: Uint8ClampedArray | null = null;

  constructor(
    public width = 1,
    public height = 1,
  ) {}

  getContext(): this {
    return this;
  }

  get data(): Uint8ClampedArray {
    return (this.pixels ??= new Uint8ClampedArray(this.width * this.height * 4));
  }

  /** Copies an image. @throws RangeError for another size, which a real canvas would scale */
  drawImage(picture: Pixels): void {
    if (picture.width !== this.width || picture.height !== this.height) throw new RangeError('Of another size.');
    this.data.set(picture.data);
  }

  fillRect(): void {
    const channels = [1, 3, 5].map((at) => Number.parseInt(this.fillStyle.slice(at, at + 2), 16));
    for (let i = 0; i < this.data.length; i += 4) this.data.set([...channels, 255], i);
  }

  getImageData(): Pixels {
    return { width: this.width, height: this.height, data: this.data.slice() };
  }

  putImageData(picture: Pixels): void {
    this.drawImage(picture);
  }

  convertToBlob({ type }: { readonly type: string }): Promise<Blob> {
    return Promise.resolve(new Blob([new Uint32Array([this.width, this.height]), this.data.slice()], { type }));
  }
}

/** Replaces `createImageBitmap`. */
export async function readPicture(file: Blob): Promise<Pixels> {
  const bytes = await file.arrayBuffer();
  const [width, height] = new Uint32Array(bytes, 0, 2);
  return { width, height, data: new Uint8ClampedArray(bytes, HEADER) };
}

/** Replaces `ImageData`. */
export class PageImageData implements Pixels {
  constructor(
    readonly data: Uint8ClampedArray,
    readonly width: number,
    readonly height: number,
  ) {}
}
