import { RepeatWrapping, SRGBColorSpace, Texture } from 'three';
import { readBake } from './bake/readBake';
import { parsePly } from '../geometry/parsePly';
import type { Asset } from './Asset';
import { type FileAssetType, pathOf, type ReadOptions } from './loadAsset';
import { geometriesOf, geometryMemory, readOnce, reserve } from './memory';
import { readCube } from './readCube';
import { readKtx2 } from './readKtx2';
import { readEnvironment } from './readEnvironment';
import { readModel } from './readModel';
import { signatureOf } from '../guard/signature';
import { Sound } from './Sound';

async function readTexture(bytes: ArrayBuffer): Promise<Texture> {
  let image: ImageBitmap;
  try {
    image = await createImageBitmap(new Blob([bytes]), { imageOrientation: 'flipY' });
  } catch (cause) {
    const said = signatureOf(bytes);
    throw new Error(
      said
        ? `it begins as ${said}, and is damaged or cut short. Export it again from where it was made.`
        : 'its bytes are not PNG, JPEG or WebP: was another file renamed?',
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

/** @param kind - ending of the file's name, in small letters, with its dot */
async function readPicture(bytes: ArrayBuffer, kind: string, options: ReadOptions): Promise<Texture> {
  if (kind === '.cube') return readCube(bytes);
  const said = signatureOf(bytes);
  if (said === 'HDR' || said === 'EXR') return readEnvironment(bytes, said);
  if (said === 'KTX2') return readKtx2(bytes, options);
  const wanted = { '.ktx2': 'KTX2', '.hdr': 'Radiance HDR', '.exr': 'OpenEXR' }[kind];
  if (wanted) throw new Error(`its bytes are ${said ?? 'unknown'}, not ${wanted}: was another file renamed?`);
  return readTexture(bytes);
}

/**
 * Reads an asset from the bytes of its file.
 * @param path - address or name, whose extension gives the format
 * @throws Error that says what is wrong with the bytes
 */
export async function readAsset(
  bytes: ArrayBuffer,
  path: string,
  type: FileAssetType,
  options: ReadOptions = {},
): Promise<Asset> {
  if (bytes.byteLength === 0) throw new Error('the file is empty: choose it again.');
  if (type === 'sound') return new Sound(bytes, (memory) => reserve(options, 'samples', memory));
  if (type === 'profile') {
    const { parseIES, PhotometricProfile } = await import('@farol/renderer/light-profiles');
    // the standard has ASCII; names of makers are often Latin-1
    return new PhotometricProfile(parseIES(new TextDecoder('latin1').decode(bytes)));
  }
  if (type === 'bake') return readBake(bytes);
  if (type === 'model') {
    const model = await readModel(bytes, options);
    reserve(options, 'geometry', geometryMemory(geometriesOf(model.scene)));
    return model;
  }
  if (type === 'texture') {
    const [kind] = /\.\w+$/.exec(pathOf(path)) ?? [''];
    return readOnce(bytes, kind, options, () => readPicture(bytes, kind, options));
  }
  const geometry = await parsePly(bytes);
  reserve(options, 'geometry', geometryMemory([geometry]));
  return geometry;
}
