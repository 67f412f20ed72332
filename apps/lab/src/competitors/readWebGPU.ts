/** The part of WebGPU used here; TypeScript's library lacks it. */
export interface CopyingDevice {
  readonly queue: { submit(commands: unknown[]): void };
  createBuffer(descriptor: { size: number; usage: number }): CopyBuffer;
  createCommandEncoder(): {
    copyTextureToBuffer(from: object, to: object, size: readonly number[]): void;
    finish(): unknown;
  };
}

interface CopyBuffer {
  mapAsync(mode: number): Promise<void>;
  getMappedRange(): ArrayBuffer;
  destroy(): void;
}

/** `GPUBufferUsage.COPY_DST | MAP_READ`, and `GPUMapMode.READ`. */
const USAGE = 0x8 | 0x1;
const READ = 1;

/**
 * Reads the picture drawn to a WebGPU canvas in this task; its context must be configured with COPY_SRC.
 *
 * @returns 8-bit pixels, top row first, opaque
 */
export async function readWebGPU(device: CopyingDevice, canvas: HTMLCanvasElement): Promise<ImageData> {
  const { width, height } = canvas;
  const context = canvas.getContext('webgpu' as 'bitmaprenderer') as unknown as {
    getCurrentTexture(): { readonly format: string };
  };
  const texture = context.getCurrentTexture();
  // rows begin at multiples of 256 bytes
  const bytesPerRow = Math.ceil((width * 4) / 256) * 256;
  const buffer = device.createBuffer({ size: bytesPerRow * height, usage: USAGE });
  const encoder = device.createCommandEncoder();
  encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow }, [width, height]);
  device.queue.submit([encoder.finish()]);
  await buffer.mapAsync(READ);
  const rows = new Uint8Array(buffer.getMappedRange());
  const pixels = new ImageData(width, height);
  const [red, blue] = texture.format.startsWith('bgra') ? [2, 0] : [0, 2];
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const from = y * bytesPerRow + 4 * x;
      const to = 4 * (y * width + x);
      pixels.data[to] = rows[from + red];
      pixels.data[to + 1] = rows[from + 1];
      pixels.data[to + 2] = rows[from + blue];
      pixels.data[to + 3] = 255;
    }
  }
  buffer.destroy();
  return pixels;
}
