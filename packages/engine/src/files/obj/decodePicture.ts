import { TGALoader } from 'three/addons/loaders/TGALoader.js';
import { checkImageSize, checkPixels } from '../../guard/pictures/imageSize';
import type { Picture } from './pictures';

const isTga = (name: string): boolean => /\.(tga|vda|icb|vst)$/i.test(name);

/** MIME type by the first bytes, when glTF allows that format; else null. */
export function gltfMime(bytes: Uint8Array): 'image/png' | 'image/jpeg' | null {
  if (bytes[0] === 0x89 && bytes[1] === 0x50 && bytes[2] === 0x4e && bytes[3] === 0x47) return 'image/png';
  return bytes[0] === 0xff && bytes[1] === 0xd8 && bytes[2] === 0xff ? 'image/jpeg' : null;
}

/** Decodes a TGA. @throws Error when the bytes are no TGA */
export function decodeTga(bytes: Uint8Array<ArrayBuffer>): Picture {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [width, height] = bytes.length < 18 ? [0, 0] : [view.getUint16(12, true), view.getUint16(14, true)];
  checkPixels(width, height);
  // types 1 to 3 are uncompressed: their size is checked, since the loader reads missing bytes as black
  const isPacked = bytes[2] > 3;
  if (bytes.length < 18 || (!isPacked && bytes.length < 18 + (width * height * bytes[16]) / 8))
    throw new Error('it is cut short');
  const { data } = new TGALoader().parse(bytes.slice().buffer) as unknown as { data: Uint8Array };
  return { width, height, data };
}

/** Whether the browser can decode a picture. */
export async function canDecode(bytes: Uint8Array<ArrayBuffer>): Promise<boolean> {
  try {
    checkImageSize(bytes);
    (await createImageBitmap(new Blob([bytes]))).close();
    return true;
  } catch {
    return false;
  }
}

/**
 * Decodes an image: TGA, or any format of the browser.
 * @param name - of the file; TGA is recognised by its extension
 * @throws Error when it cannot be decoded
 */
export async function decodePicture(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<Picture> {
  if (isTga(name) && !gltfMime(bytes)) return decodeTga(bytes);
  checkImageSize(bytes);
  const bitmap = await createImageBitmap(new Blob([bytes]), {
    premultiplyAlpha: 'none',
    colorSpaceConversion: 'none',
  });
  try {
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d', { willReadFrequently: true });
    if (!context) throw new Error('the browser gives no canvas');
    context.drawImage(bitmap, 0, 0);
    const { width, height, data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    return { width, height, data };
  } finally {
    bitmap.close();
  }
}
