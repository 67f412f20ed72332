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
import { signatureOf } from './signature';
import { Sound } from './Sound';

async function readTexture(bytes: ArrayBuffer): Promise<Texture> {
  checkImageSize(new Uint8Array(bytes));
  let image: ImageBitmap;
  try {
    image = await createImageBitmap(new Blob([bytes]), { imageOrientation: 'flipY' });
  } catch (cause) {
    const said = signatureOf(bytes);
    throw new Error(
      said
        ? `it begins as ${said}, and is damaged or cut short. Export it again from where it was made.`
        : 'its bytes are no PNG, JPEG or WebP: was another file renamed?',
      { cause },
    );
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
