import { t } from '@farol/editing';
import { type DataTexture, RGBAFormat, Texture, UnsignedByteType, type WebGLRenderer } from 'three';
import { readTexels } from './readTexels';

type Picture = HTMLCanvasElement | OffscreenCanvas;

/** Changes to make in an image: reversal of rows, inversion of channels of a normal map. */
interface Flips {
  readonly rows: boolean;
  readonly red: boolean;
  readonly green: boolean;
}

/** Image formats that glTF supports; others become PNG. */
const kept = ['image/jpeg', 'image/webp'];

function canvasOf(width: number, height: number): { canvas: HTMLCanvasElement; context: CanvasRenderingContext2D } {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error(t('the browser has no canvas left to draw it on: close other pages and try again.'));
  return { canvas, context };
}

function turnRows(data: Uint8ClampedArray, width: number, height: number): void {
  const stride = width * 4;
  for (let y = 0; y < height >> 1; y++) {
    const [upper, lower] = [y * stride, (height - 1 - y) * stride];
    const row = data.slice(upper, upper + stride);
    data.copyWithin(upper, lower, lower + stride);
    data.set(row, lower);
  }
}

function turnChannel(data: Uint8ClampedArray, channel: number): void {
  for (let i = channel; i < data.length; i += 4) data[i] = 255 - data[i];
}

const isPlainData = ({ image, format, type }: DataTexture): boolean =>
  image.data instanceof Uint8Array && format === RGBAFormat && type === UnsignedByteType;

/**
 * Converts textures for glTF: images that a canvas can hold, first row at v = 0. Shared images stay shared in the file.
 */
export class GltfTextures {
  private readonly pictures = new WeakMap<object, Map<string, Promise<Picture>>>();
  private readonly made = new Map<string, Promise<Texture>>();

  /** @param webgl - for reading back textures that no canvas can: compressed ones, floats */
  constructor(private readonly webgl: WebGLRenderer) {}

  /** Converts a colour or data map. @param user - user of the texture, for messages */
  convert(texture: Texture, user: string): Promise<Texture> {
    return this.convertOnce(texture, { rows: texture.flipY, red: false, green: false }, user);
  }

  /** Converts a normal map, inverting channels: in glTF green points up, and scales are not negative. */
  convertNormalMap(texture: Texture, red: boolean, green: boolean, user: string): Promise<Texture> {
    return this.convertOnce(texture, { rows: texture.flipY, red, green }, user);
  }

  private convertOnce(texture: Texture, flips: Flips, user: string): Promise<Texture> {
    const key = `${texture.uuid} ${Object.values(flips).join()}`;
    let made = this.made.get(key);
    if (!made) this.made.set(key, (made = this.make(texture, flips, user)));
    return made;
  }

  private async make(texture: Texture, flips: Flips, user: string): Promise<Texture> {
    try {
      const copy = new Texture(await this.pictureOf(texture, flips));
      const { name, wrapS, wrapT, magFilter, minFilter, channel, colorSpace, rotation } = texture;
      Object.assign(copy, { name, wrapS, wrapT, magFilter, minFilter, channel, colorSpace, rotation, flipY: false });
      copy.repeat.copy(texture.repeat);
      copy.offset.copy(texture.offset);
      const mimeType: unknown = texture.userData.mimeType;
      if (kept.includes(String(mimeType)) && !flips.red && !flips.green) copy.userData.mimeType = mimeType;
      return copy;
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      const name = texture.name ? `'${texture.name}'` : t('A texture');
      throw new Error(t('{name} of {user} cannot be exported: {reason}', { name, user, reason }), { cause });
    }
  }

  private pictureOf(texture: Texture, flips: Flips): Promise<Picture> {
    let pictures = this.pictures.get(texture.source);
    if (!pictures) this.pictures.set(texture.source, (pictures = new Map()));
    const key = Object.values(flips).join();
    let picture = pictures.get(key);
    if (!picture) pictures.set(key, (picture = this.draw(texture, flips)));
    return picture;
  }

  private async draw(texture: Texture, { rows, red, green }: Flips): Promise<Picture> {
    const image = texture.image as { width?: number; height?: number; data?: unknown } | null;
    const [width, height] = [image?.width ?? 0, image?.height ?? 0];
    if (!image || width === 0 || height === 0)
      throw new Error(t('it has no picture: load it again, or choose another.'));
    const { canvas, context } = canvasOf(width, height);
    const isSampled = 'isCompressedTexture' in texture || (image.data && !isPlainData(texture as DataTexture));
    let data: Uint8ClampedArray<ArrayBuffer> | null = null;
    if (isSampled) data = await readTexels(this.webgl, texture, width, height);
    else if (image.data) data = new Uint8ClampedArray(image.data as Uint8Array);
    else context.drawImage(image as CanvasImageSource, 0, 0, width, height);
    if (!data && !rows && !red && !green) return canvas;
    data ??= context.getImageData(0, 0, width, height).data;
    // textures read back from the GPU already have v = 0 first
    if (rows && !isSampled) turnRows(data, width, height);
    if (red) turnChannel(data, 0);
    if (green) turnChannel(data, 1);
    context.putImageData(new ImageData(data, width, height), 0, 0);
    return canvas;
  }
}
