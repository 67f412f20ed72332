import {
  ClampToEdgeWrapping,
  type CompressedTexture,
  Data3DTexture,
  LinearFilter,
  RGBAFormat,
  type Texture,
  UnsignedByteType,
} from 'three';

/** RGBA pixels of an image, 8 bits per channel, top row first. */
interface Pixels {
  readonly data: ArrayLike<number>;
  readonly width: number;
  readonly height: number;
}

function pixelsOf(texture: Texture): Pixels | null {
  const image = texture.image as (Partial<Pixels> & { width: number; height: number }) | null;
  if (!image || !(image.width > 0) || (texture as CompressedTexture).isCompressedTexture) return null;
  if (image.data) return texture.type === UnsignedByteType ? (image as Pixels) : null;
  const canvas = document.createElement('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  const context = canvas.getContext('2d', { willReadFrequently: true })!;
  // images of the library are stored bottom row first
  if (!texture.flipY) {
    context.translate(0, image.height);
    context.scale(1, -1);
  }
  context.drawImage(image as unknown as CanvasImageSource, 0, 0);
  return context.getImageData(0, 0, image.width, image.height);
}

/** Size of a table's slices in an image, and how many are in a row; null for an image that is no table. */
function layoutOf(width: number, height: number): { size: number; columns: number } | null {
  if (width === height * height) return { size: height, columns: height };
  if (height === width * width) return { size: width, columns: 1 };
  // slices in a square, such as 8 × 8 slices of 64 × 64
  const size = Math.round((width * height) ** (1 / 3));
  if (size ** 3 !== width * height || width % size !== 0) return null;
  return { size, columns: width / size };
}

/**
 * Makes a colour lookup table of an image: slices of blue in a row, in a column, or in a square; red to the right,
 * green down.
 * @returns null for an image that is no table
 */
export function makeLookupTable(texture: Texture): Data3DTexture | null {
  const pixels = pixelsOf(texture);
  const layout = pixels && layoutOf(pixels.width, pixels.height);
  if (!layout) return null;
  const { size, columns } = layout;
  const data = new Uint8Array(size ** 3 * 4);
  for (let blue = 0, to = 0; blue < size; blue++) {
    const left = (blue % columns) * size;
    const top = Math.floor(blue / columns) * size;
    for (let green = 0; green < size; green++) {
      for (let red = 0; red < size; red++, to += 4) {
        const from = ((top + green) * pixels.width + left + red) * 4;
        for (let i = 0; i < 3; i++) data[to + i] = pixels.data[from + i];
        data[to + 3] = 255;
      }
    }
  }
  const table = new Data3DTexture(data, size, size, size);
  table.format = RGBAFormat;
  table.type = UnsignedByteType;
  table.minFilter = table.magFilter = LinearFilter;
  table.wrapS = table.wrapT = table.wrapR = ClampToEdgeWrapping;
  table.needsUpdate = true;
  return table;
}
