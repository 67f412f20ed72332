import { shortText } from '@farol/editing';
import { ClampToEdgeWrapping, LinearFilter, RepeatWrapping, type Texture } from 'three';
import { checkExr } from '../guard/exr/checkExr';
import { PixelsError } from '../guard/pictures/imageSize';
import { readHdr } from './readHdr';

async function readExr(bytes: ArrayBuffer): Promise<Texture> {
  const { EXRLoader } = await import('three/addons/loaders/EXRLoader.js');
  await checkExr(bytes);
  return new EXRLoader().createDataTexture(bytes);
}

/**
 * Reads an equirectangular picture of linear light. The loader is fetched on first use.
 * @throws Error that says what is wrong with the bytes
 */
export async function readEnvironment(bytes: ArrayBuffer, format: 'HDR' | 'EXR'): Promise<Texture> {
  let texture: Texture;
  try {
    texture = format === 'EXR' ? await readExr(bytes) : readHdr(new Uint8Array(bytes));
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
