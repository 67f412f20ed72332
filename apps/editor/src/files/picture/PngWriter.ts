const CRC = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; bit++) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});

/** Checksum of a PNG chunk, over its type and data. */
function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = CRC[(crc ^ byte) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

function chunk(type: string, data: Uint8Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(12 + data.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  for (let i = 0; i < 4; i++) bytes[4 + i] = type.charCodeAt(i);
  bytes.set(data, 8);
  view.setUint32(8 + data.length, crc32(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

/** Writes a PNG of 8 bits RGBA, sRGB, row by row, of any size; a canvas is limited to 16,384 pixels. */
export class PngWriter {
  private readonly parts: Uint8Array<ArrayBuffer>[];
  private readonly deflate = new CompressionStream('deflate');
  private readonly input = this.deflate.writable.getWriter();
  private readonly done: Promise<void>;
  private rows = 0;

  /**
   * @param width - 1 to 2^31 - 1 pixels
   * @param height - 1 to 2^31 - 1 pixels
   */
  constructor(
    private readonly width: number,
    private readonly height: number,
  ) {
    const header = new Uint8Array(13);
    const view = new DataView(header.buffer);
    view.setUint32(0, width);
    view.setUint32(4, height);
    header.set([8, 6], 8); // 8 bits per channel; RGB with alpha
    const signature = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
    this.parts = [signature, chunk('IHDR', header), chunk('sRGB', Uint8Array.of(0))];
    this.done = this.collect();
  }

  /** Writes the next rows, from the top down. @param pixels - RGBA of whole rows, colour not multiplied by alpha */
  async write(pixels: Uint8Array): Promise<void> {
    const size = 4 * this.width;
    const rows = pixels.length / size;
    const filtered = new Uint8Array(rows * (size + 1)); // each row begins with its filter type, 0: none
    for (let row = 0; row < rows; row++)
      filtered.set(pixels.subarray(row * size, (row + 1) * size), row * (size + 1) + 1);
    this.rows += rows;
    await this.input.write(filtered);
  }

  /** @throws Error when rows are missing */
  async end(): Promise<Blob> {
    if (this.rows !== this.height) throw new Error(`A PNG of ${this.height} rows got ${this.rows}.`);
    await this.input.close();
    await this.done;
    return new Blob([...this.parts, chunk('IEND', new Uint8Array(0))], { type: 'image/png' });
  }

  private async collect(): Promise<void> {
    const output = this.deflate.readable.getReader();
    for (let next = await output.read(); !next.done; next = await output.read())
      this.parts.push(chunk('IDAT', next.value));
  }
}
