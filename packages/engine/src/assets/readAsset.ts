import { RepeatWrapping, SRGBColorSpace, Texture } from 'three';
import { readBake } from '../bake/readBake';
import { fitGeometry } from '../geometry/fitGeometry';
import { parsePly } from '../geometry/parsePly';
import type { Asset } from './Asset';
import { checkImageSize } from './imageSize';
import { type FileAssetType, pathOf, type ReadOptions } from './loadAsset';
import { readCube } from './readCube';
import { readKtx2 } from './readKtx2';
import { readEnvironment } from './readEnvironment';
import { readModel } from './readModel';
import { Sound } from './Sound';

/** What the first bytes of a file say it is; null when they say nothing. */
function signatureOf(bytes: ArrayBuffer): string | null {
  const head = [...new Uint8Array(bytes, 0, Math.min(16, bytes.byteLength))];
  const text = String.fromCharCode(...head);
  if (text.startsWith('\x89PNG')) return 'PNG';
  if (text.startsWith('\xff\xd8\xff')) return 'JPEG';
  if (text.startsWith('RIFF') && text.slice(8, 12) === 'WEBP') return 'WebP';
  if (text.startsWith('#?')) return 'HDR';
  if (text.startsWith('v/1\x01')) return 'EXR';
  if (text.startsWith('\xabKTX 20\xbb')) return 'KTX2';
  return null;
}

async function readTexture(bytes: ArrayBuffer): Promise<Texture> {
  checkImageSize(new Uint8Array(bytes));
  let image: ImageBitmap;
  try {
    image = await createImageBitmap(new Blob([bytes]), { imageOrientation: 'flipY' });
  } catch (cause) {
    const said = signatureOf(bytes);
    const reason = said
      ? `it begins as ${said}, and is damaged or cut short`
      : 'its bytes are no PNG, JPEG or WebP: was another file renamed?';
    throw new Error(`${reason}. Export it again from where it was made.`, { cause });
  }
  const texture = new Texture(image);
  texture.flipY = false;
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.needsUpdate = true;
  return texture;
}

/**
 * Reads an asset from the bytes of its file.
 * @param path - address or name: what follows its last dot says which format it is
 * @throws Error that says what is wrong with the bytes
 */
export async function readAsset(
  bytes: ArrayBuffer,
  path: string,
  type: FileAssetType,
  options: ReadOptions = {},
): Promise<Asset> {
  if (bytes.byteLength === 0) throw new Error('the file is empty: choose it again.');
  if (type === 'sound') return new Sound(bytes);
  if (type === 'profile') {
    const { parseIES, PhotometricProfile } = await import('@farol/renderer/light-profiles');
    // the standard has ASCII; names of makers are often Latin-1
    return new PhotometricProfile(parseIES(new TextDecoder('latin1').decode(bytes)));
  }
  if (type === 'bake') return readBake(bytes);
  if (type === 'model') return readModel(bytes, options.renderer, options.signal);
  if (type === 'texture') {
    if (pathOf(path).endsWith('.cube')) return readCube(bytes);
    const said = signatureOf(bytes);
    if (said === 'HDR' || said === 'EXR') return readEnvironment(bytes, said);
    if (said === 'KTX2') return readKtx2(bytes, options);
    if (pathOf(path).endsWith('.ktx2')) {
      throw new Error(`its bytes are ${said ?? 'something other'}, not KTX2: was another file renamed?`);
    }
    if (/\.(hdr|exr)$/.test(pathOf(path))) {
      const wanted = pathOf(path).endsWith('.hdr') ? 'Radiance HDR' : 'OpenEXR';
      throw new Error(`its bytes are ${said ?? 'something other'}, not ${wanted}: was another file renamed?`);
    }
    return readTexture(bytes);
  }
  const geometry = await parsePly(bytes);
  return options.normalise ? fitGeometry(geometry) : geometry;
}
