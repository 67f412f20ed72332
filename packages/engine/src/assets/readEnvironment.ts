import { ClampToEdgeWrapping, LinearFilter, RepeatWrapping, type Texture } from 'three';
import { shortText } from '@farol/renderer';
import { checkExr } from '../exr/checkExr';
import { checkPixels, imageSize, PixelsError } from './imageSize';

/**
 * Reads an equirectangular picture of linear light. The loader is fetched when it is first needed.
 * @throws Error that says what is wrong with the bytes
 */
export async function readEnvironment(bytes: ArrayBuffer, format: 'HDR' | 'EXR'): Promise<Texture> {
  const loader =
    format === 'HDR'
      ? new (await import('three/addons/loaders/HDRLoader.js')).HDRLoader()
      : new (await import('three/addons/loaders/EXRLoader.js')).EXRLoader();
  let texture: Texture;
  const size = imageSize(new Uint8Array(bytes));
  if (size) checkPixels(size.width, size.height);
  try {
    if (format === 'EXR') await checkExr(bytes);
    else if (!size) throw new Error('its header says no size');
    texture = loader.createDataTexture(bytes);
  } catch (cause) {
    if (cause instanceof PixelsError) throw cause;
    const reason = cause instanceof Error ? shortText(cause.message.replace(/^THREE\.\w+:\s*/, ''), 160) : '';
    throw new Error(`its ${format} data are damaged or cut short (${reason}): export it again.`, { cause });
  }
  const { width, height } = texture.image as { width: number; height: number };
  if (!(width > 0 && height > 0)) throw new Error(`its ${format} data have no pixels: export it again.`);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = ClampToEdgeWrapping;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.generateMipmaps = false;
  texture.needsUpdate = true;
  return texture;
}
